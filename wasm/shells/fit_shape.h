// The shape whose lengths and angles come nearest to given ones (NRIC: Sassen et al. 2020).
#pragma once

#include <optional>

#include "shells/shell_system.h"

namespace shapespline {

/// Levenberg-Marquardt from `start`. size: of the shape, a length. Nothing where it does not converge.
std::optional<Positions> fitShape(ShellSystem& system, const ShellMeasures& target, Positions start, double size);

}  // namespace shapespline
