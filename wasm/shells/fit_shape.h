// Finds the shape with lengths and angles closest to given ones (NRIC: Sassen et al. 2020).
#pragma once

#include <functional>
#include <optional>

#include "shells/shell_system.h"

namespace shapespline {

using ShapeTest = std::function<bool(const Positions&)>;

/// Levenberg-Marquardt from `start`, through shapes that are allowed. size: diagonal of the shape. Returns nullopt if
/// the fit does not converge.
std::optional<Positions> fitShape(ShellSystem& system, const ShellMeasures& target, Positions start, double size,
                                  const ShapeTest& isAllowed);

}  // namespace shapespline
