// Chooses the times at which keys are sampled from an animation, in any format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/status.h"
#include "io/base/imported.h"

namespace shapespline {

/// Up to this many key times, an animation of stored shapes uses them all as keys.
constexpr std::size_t maxOwnKeys = 32;

/// Returns the requested times, or evenly spaced times over the animation. An evenly spaced time moves to the nearest
/// frame if that is closer than half the spacing, so keys are true frames of a recording, and a time in a long interval
/// between two frames stays. frames: times of the animation's frames, increasing. Warns about requested times outside
/// the animation. `what`: name of the animation in messages. Errors: TimesNotIncreasing, TooFewKeys.
Result<std::vector<double>> sampleTimes(const ImportOptions& options, const std::vector<double>& frames,
                                        const std::string& what, std::vector<Warning>& warnings);

/// Name of a key sampled at this time.
std::string sampleName(double seconds);

/// Error: TooLarge if memory cannot hold this number of keys, or their vertices.
Status checkKeyCount(std::size_t keys, std::size_t vertices, const std::string& where);

}  // namespace shapespline
