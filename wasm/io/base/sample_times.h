// At which times keys are taken from an animation, whatever holds it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/status.h"
#include "io/base/imported.h"

namespace shapespline {

/// Key times up to which an animation that only shows its own shapes gives these as keys.
constexpr std::size_t mostOwnKeys = 32;

/// The requested times, or evenly spaced ones over the animation, with a warning if some lie outside. `what` is the
/// name of the animation in messages. Errors: TimesNotIncreasing, TooFewKeys.
Result<std::vector<double>> sampleTimes(const ImportOptions& options, double start, double end, const std::string& what,
                                        std::vector<Warning>& warnings);

/// Name of a key taken at this time.
std::string sampleName(double seconds);

/// Errors: TooLarge for more keys, or more vertices in all of them, than memory holds.
Status checkKeyCount(std::size_t keys, std::size_t vertices, const std::string& where);

}  // namespace shapespline
