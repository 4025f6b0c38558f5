// Validates and creates key times.
#pragma once

#include <vector>

#include "core/base/status.h"

namespace shapespline {

/// Errors: TimeCountMismatch, NotFinite, TooLarge (absolute time above 1e9), TimesNotIncreasing (also if two keys are
/// closer than 1e-12 of the total time, or than 1e-30).
Status validateTimes(const std::vector<double>& times, int keyCount);

/// J times evenly spaced over [0, 1].
std::vector<double> evenTimes(int keyCount);

}  // namespace shapespline
