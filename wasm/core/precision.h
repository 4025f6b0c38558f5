#pragma once

namespace shapespline {

/// How the numbers that a frame streams through are stored. They are always computed in double.
enum class Precision { Single, Double };

}  // namespace shapespline
