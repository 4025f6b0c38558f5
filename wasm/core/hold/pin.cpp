#include "core/hold/pin.h"

#include <cmath>
#include <string>

#include "core/base/format.h"

namespace shapespline {

Status checkPins(const std::vector<Pin>& pins, int vertices, int keys) {
  const auto invalid = [](std::string message) { return Error{ErrorCode::InvalidOption, std::move(message)}; };
  for (const Pin& pin : pins) {
    if (pin.vertex < 0 || pin.vertex >= vertices)
      return invalid("A pin is at vertex " + grouped(pin.vertex) + ", but the shape has " + grouped(vertices) +
                     " vertices, counted from 0.");
    if (!(pin.radius >= 0 && pin.radius <= 1))
      return invalid("A pin's radius must be a fraction of the shape's size, from 0 to 1.");
    if (pin.key < -1 || pin.key >= keys)
      return invalid("A pin keeps its position from key " + grouped(pin.key + 1) + ", but there are " + grouped(keys) +
                     " keys.");
    for (std::size_t i = 0; i < pin.path.size(); ++i)
      if (!std::isfinite(pin.path[i].time) || !pin.path[i].move.allFinite() ||
          (i > 0 && !(pin.path[i].time > pin.path[i - 1].time)))
        return invalid("The times along a pin's path must increase, and its times and offsets must be finite.");
  }
  return {};
}

}  // namespace shapespline
