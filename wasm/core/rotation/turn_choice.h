// Chooses between the two directions of each rotation in a sequence.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// A rotation in one step, and its alternative in the other direction, which differs by a full turn. Costs are mean
/// squares of angles.
struct TurnOptions {
  Vec3 turn, other;  ///< rotation vectors in a common frame of all steps
  double cost, otherCost;
  bool isOpen;  ///< whether the alternative is worth considering
};

/// Both directions of a single rotation, open above 150 degrees.
TurnOptions turnOptions(const Vec3& turn);

/// For each step, whether to take the alternative. Minimises the sum of |turn_s - turn_(s-1)|^2 (bending) plus ten
/// times the sum of the costs (rotation). The shorter direction wins, unless it is hardly shorter and the neighbouring
/// steps rotate in the other direction. If both are equal up to rounding, the largest coordinate of the rotation is
/// positive.
std::vector<char> chooseTurns(const std::vector<TurnOptions>& steps);

}  // namespace shapespline
