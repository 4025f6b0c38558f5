#include "io/base/finite_shape.h"

#include <cmath>
#include <string>

#include "core/base/format.h"

namespace shapespline {

Status checkFinite(std::span<const float> positions, int frame) {
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!std::isfinite(positions[i]))
      return Error{ErrorCode::NotFinite,
                   "Vertex " + grouped(std::int64_t(i / 3)) +
                       (frame < 0 ? " of the shape" : " of frame " + std::to_string(frame)) +
                       " is not finite. Choose a range closer to the keys.",
                   frame, static_cast<int>(i / 3)};
  return {};
}

}  // namespace shapespline
