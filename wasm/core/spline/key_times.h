// The times of the keys.
#pragma once

#include <vector>

#include "core/base/status.h"

namespace shapespline {

/// Errors: TimeCountMismatch, NotFinite, TooLarge (farther than 1e9 from 0), TimesNotIncreasing (also where two keys
/// are closer than 1e-12 of the whole time).
Status validateTimes(const std::vector<double>& times, int keyCount);

/// J times evenly spaced over [0, 1].
std::vector<double> evenTimes(int keyCount);

}  // namespace shapespline
