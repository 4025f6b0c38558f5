#include "io/frame_source.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "io/base/byte_text.h"
#include "io/base/sample_times.h"

namespace shapespline {

namespace {

Status checkAnimation(const FrameSource& source, const ImportOptions& options, const std::string& where) {
  const int* index = std::get_if<int>(&options.animation);
  const std::string* name = std::get_if<std::string>(&options.animation);
  if ((!index || *index == 0) && (!name || *name == source.name)) return {};
  return Error{ErrorCode::UnknownAnimation, where + " has no animation " +
                                                (index ? std::to_string(*index) : inQuotes(*name)) + "; it has 0 " +
                                                inQuotes(source.name) + "."};
}

// Caches the last frame read. Consecutive samples usually share a frame.
struct FrameReader {
  const FrameSource& source;
  std::size_t last = 0;
  std::optional<Positions> held{};

  Result<Positions> read(std::size_t index) {
    if (held && last == index) return *held;
    auto frame = source.frame(index);
    if (frame) {
      last = index;
      held = *frame;
    }
    return frame;
  }

  Result<Positions> at(double t) {
    const std::vector<double>& times = source.seconds;
    const auto after = static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), t) - times.begin());
    if (after == times.size()) return read(times.size() - 1);
    if (after == 0 || times[after] == t) return read(after);
    auto from = read(after - 1);
    if (!from) return from;
    const auto to = read(after);
    if (!to) return to;
    const double share = (t - times[after - 1]) / (times[after] - times[after - 1]);
    for (std::size_t v = 0; v < from->size(); ++v) (*from)[v] += share * ((*to)[v] - (*from)[v]);
    return from;
  }
};

}  // namespace

std::vector<double> statedTimes(const ImportOptions& options, const std::vector<double>& own) {
  const std::vector<double>& stated = options.frameTimes;
  const bool increase = std::adjacent_find(stated.begin(), stated.end(), std::greater_equal<>()) == stated.end();
  return stated.size() == own.size() && increase ? stated : own;
}

AnimationInfo infoOf(const FrameSource& source) {
  return {source.name, source.seconds.front(), source.seconds.back(), static_cast<int>(source.seconds.size()), true,
          {}};
}

Status sampleFrames(const FrameSource& source, const ImportOptions& options, const std::string& where, Import& import,
                    const StageProgress& progress) {
  if (Status known = checkAnimation(source, options, where); !known) return known;
  const bool few = !options.sampleAsked && source.seconds.size() <= maxOwnKeys;
  const bool own = options.sampleTimes.empty() && source.seconds.size() >= 2 && (few || options.everyFrame);
  const auto times =
      own ? Result<std::vector<double>>(source.seconds)
          : sampleTimes(options, source.seconds, where + ": the animation " + inQuotes(source.name), import.warnings);
  if (!times) return times.error();
  if (Status size = checkKeyCount(times->size(), import.keyframes.vertexCount(), where); !size) return size;
  FrameReader frames{source};
  std::vector<Key> keys;
  for (double t : *times) {
    if (progress) progress("sampling the keys", static_cast<double>(keys.size()) / static_cast<double>(times->size()));
    auto shape = frames.at(t);
    if (!shape) return shape.error();
    keys.push_back({sampleName(t), t, std::move(*shape)});
  }
  import.keyframes.keys = std::move(keys);
  import.animations = {infoOf(source)};
  import.animation = 0;
  return {};
}

}  // namespace shapespline
