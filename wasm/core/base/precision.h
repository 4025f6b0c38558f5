// How a factor, and what a frame streams through, is stored.
#pragma once

namespace shapespline {

/// How the numbers that a frame streams through are stored. They are always computed in double.
enum class Precision {
  Single,  ///< what is drawn: 1e-5 of the bounding box
  Double,
  Exact,  ///< coordinates in double, the factor in single: the solution is refined until it is the double one's equal
};

}  // namespace shapespline
