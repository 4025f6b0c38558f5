// Samples keys at chosen times from shapes of one mesh over time.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "io/base/imported.h"

namespace shapespline {

/// Frames in the import's vertex order, each read on demand.
struct FrameSource {
  std::string name;
  std::vector<double> seconds;  ///< time of each frame, increasing
  std::function<Result<Positions>(std::size_t)> frame;
};

/// Frame times stated in the files, or `own`: times given by the format or the frame numbers.
std::vector<double> statedTimes(const ImportOptions& options, const std::vector<double>& own);

AnimationInfo infoOf(const FrameSource& source);

/// Replaces the import's keys with keys at the sample times, interpolated linearly between frames. Without requested
/// times, every frame of a short source becomes a key. `where`: display name of the source. Errors: those of the
/// frames, UnknownAnimation, TimesNotIncreasing, TooFewKeys, TooLarge.
Status sampleFrames(const FrameSource& source, const ImportOptions& options, const std::string& where, Import& import,
                    const StageProgress& progress);

}  // namespace shapespline
