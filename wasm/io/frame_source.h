// Shapes over time, one mesh in all of them -> keys at chosen times.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "io/base/imported.h"

namespace shapespline {

/// Frames in the import's vertices, read when they are asked for.
struct FrameSource {
  std::string name;
  std::vector<double> seconds;  ///< of each frame, increasing
  std::function<Result<Positions>(std::size_t)> frame;
};

/// The times that the files state for these frames, or those that their format or number gives (`own`).
std::vector<double> statedTimes(const ImportOptions& options, const std::vector<double>& own);

AnimationInfo infoOf(const FrameSource& source);

/// Puts keys in the place of those that the import holds: at the sample times, on straight lines between frames. Where
/// nothing is asked for, each of few frames is a key. `where` is how messages call the source. Errors: those of the
/// frames, UnknownAnimation, TimesNotIncreasing, TooFewKeys, TooLarge.
Status sampleFrames(const FrameSource& source, const ImportOptions& options, const std::string& where, Import& import,
                    const StageProgress& progress);

}  // namespace shapespline
