#include "io/base/sample_times.h"

#include <algorithm>
#include <cmath>

#include "core/base/format.h"
#include "core/spline/key_times.h"

namespace shapespline {

namespace {

// Most vertices of all keys together. Their positions and encoding still fit a 32-bit address space.
constexpr std::uint64_t maxKeyVertices = 60'000'000;
// A file with more keys is a recording, not a set of key poses.
constexpr std::size_t maxKeys = 10'000;

Status checkTimes(const std::vector<double>& times) {
  for (std::size_t i = 0; i < times.size(); ++i)
    if (!std::isfinite(times[i]) || (i > 0 && !(times[i] > times[i - 1])))
      return Error{ErrorCode::TimesNotIncreasing,
                   "The sample times do not increase: sample " + std::to_string(i + 1) + " is at " +
                       shortNumber(times[i]) + ". Give them in increasing order.",
                   static_cast<int>(i)};
  return {};
}

// The frame nearest to t if it is closer than `reach`, otherwise t.
double frameNear(double t, const std::vector<double>& frames, double reach) {
  const auto after = std::lower_bound(frames.begin(), frames.end(), t);
  double nearest = t, distance = reach;
  const auto consider = [&](double frame) {
    if (std::abs(frame - t) >= distance) return;
    nearest = frame;
    distance = std::abs(frame - t);
  };
  if (after != frames.begin()) consider(*(after - 1));
  if (after != frames.end()) consider(*after);
  return nearest;
}

}  // namespace

Result<std::vector<double>> sampleTimes(const ImportOptions& options, const std::vector<double>& frames,
                                        const std::string& what, std::vector<Warning>& warnings) {
  const double start = frames.front(), end = frames.back();
  if (!options.sampleTimes.empty()) {
    if (Status times = checkTimes(options.sampleTimes); !times) return times.error();
    if (options.sampleTimes.front() < start || options.sampleTimes.back() > end)
      warnings.push_back({"sample-outside-animation",
                          "Some sample times are outside the animation (" + shortNumber(start) + " to " +
                              shortNumber(end) + " s), where the shape stays still.",
                          0});
    return options.sampleTimes;
  }
  if (options.sampleCount < 2)
    return Error{ErrorCode::TooFewKeys, "At least two keys are needed. Use two or more samples of the animation."};
  if (Status size = checkKeyCount(options.sampleCount, 0, what); !size) return size.error();
  if (!(end > start)) return Error{ErrorCode::TooFewKeys, what + " has only one key time. Choose another animation."};
  std::vector<double> times = evenTimes(options.sampleCount);
  const double spacing = (end - start) / (options.sampleCount - 1);
  for (double& t : times) t = t == 1 ? end : frameNear(start + t * (end - start), frames, spacing / 2);
  return times;
}

std::string sampleName(double seconds) { return shortNumber(std::round(1000 * seconds) / 1000) + " s"; }

Status checkKeyCount(std::size_t keys, std::size_t vertices, const std::string& where) {
  if (keys <= maxKeys && static_cast<std::uint64_t>(keys) * vertices <= maxKeyVertices) return {};
  return Error{ErrorCode::TooLarge, where + ": " + grouped(static_cast<std::int64_t>(keys)) + " keys of " +
                                        grouped(static_cast<std::int64_t>(vertices)) +
                                        " vertices exceed the limit. Use fewer keys."};
}

}  // namespace shapespline
