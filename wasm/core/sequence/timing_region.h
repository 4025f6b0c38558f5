// A region of a shape with a timing of its own. Plain data.
#pragma once

#include <vector>

#include "core/spline/curve_options.h"

namespace shapespline {

/// Faces with a timing of their own, instead of the timing of the whole.
struct TimingRegion {
  std::vector<int> faces;  ///< runs of input faces: the first face and the number of faces, in turn; none: the position
  KeyTiming timing;
  bool soft = true;  ///< blends over two rings of patches around its border
};

}  // namespace shapespline
