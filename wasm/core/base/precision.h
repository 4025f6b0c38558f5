// Storage precision of a factor and of the data read for every frame.
#pragma once

namespace shapespline {

/// Storage precision of the data read for every frame. The data is always computed in double.
enum class Precision {
  Single,  ///< for drawing: accurate to 1e-5 of the bounding box
  Double,
  Exact,  ///< coordinates in double, the factor in single; refinement gives the accuracy of double
};

}  // namespace shapespline
