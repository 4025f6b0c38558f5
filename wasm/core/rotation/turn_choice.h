// Chooses between the two senses of each turn in a sequence.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// A turn in one step and its alternative in the other direction, which differs by a full turn. Costs are mean squares
/// of angles.
struct TurnOptions {
  Vec3 turn, other;  ///< rotation vectors in a common frame of all steps
  double cost, otherCost;
  bool isOpen;  ///< whether the alternative is worth considering
};

/// Both directions of a single turn, open above 150 degrees.
TurnOptions turnOptions(const Vec3& turn);

/// For each step, whether to take the alternative. Minimises bending, sum |turn_s - turn_(s-1)|^2, plus turning, ten
/// times sum cost. The shorter direction wins unless it is hardly shorter and the neighbouring steps turn the other
/// way. Ties up to rounding go to the positive side of the turn's largest coordinate.
std::vector<char> chooseTurns(const std::vector<TurnOptions>& steps);

}  // namespace shapespline
