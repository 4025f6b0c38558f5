// Which of two senses each turn of a sequence takes.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// A turn in one step, one way and the other; `other` differs by a whole turn. Costs are mean squares of angles.
struct TurnOptions {
  Vec3 turn, other;  ///< rotation vectors, in a frame that all steps share
  double cost, otherCost;
  bool isOpen;  ///< whether the other way is worth a thought
};

/// The two ways of a single turn, open above 150 degrees.
TurnOptions turnOptions(const Vec3& turn);

/// Of each step whether it takes the other way: the choice of least bending, sum |turn_s - turn_(s-1)|^2, and of least
/// turning, ten times sum cost. So the shorter way is taken unless it is hardly shorter and the steps before and after
/// go the other way. Where two choices are as good up to rounding, that on the positive side of the turn's largest
/// coordinate.
std::vector<char> chooseTurns(const std::vector<TurnOptions>& steps);

}  // namespace shapespline
