// Bytes of one or several files -> keyframes and the scene around them. The only entrance for files.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/base/status.h"
#include "core/sequence/keyframes.h"
#include "core/sequence/sequence.h"
#include "io/scene.h"

namespace shapespline {

/// A file as the user gave it. The name may hold a path relative to the folder that was given.
struct NamedBytes {
  std::string name;
  std::span<const std::uint8_t> bytes;
};

struct ImportOptions {
  std::variant<std::monostate, int, std::string> animation;  ///< default: the first one
  std::vector<double> sampleTimes;  ///< seconds on the animation's own time line; wins over sampleCount
  int sampleCount = 8;       ///< evenly spaced, used when the animation has more than 32 key times or there are several
  bool sampleAsked = false;  ///< sampleCount was given by the user: use it even for few key times
  std::vector<double> keyTimes;  ///< default: the animation's own times, else evenly over [0, 1]
  bool zUp = false;              ///< OBJ, PLY and OFF only
  double unit = 1;               ///< metres per unit, OBJ, PLY and OFF only
  std::vector<Triangle> like;    ///< of a mesh that the files are further poses of: polygons are cut into its triangles

  bool animationAsked() const {
    return !std::holds_alternative<std::monostate>(animation) || !sampleTimes.empty() || sampleAsked;
  }
};

struct AnimationInfo {
  std::string name;
  double start = 0, end = 0;  ///< seconds
  int keys = 0;               ///< distinct key times
};

struct Import {
  Keyframes keyframes;
  Scene scene;
  std::vector<AnimationInfo> animations;
  int animation = -1;  ///< which one the keys were taken from
  std::vector<Warning> warnings;
  /// JSON of extras.shapespline where the keys were taken from a saved project, else empty.
  std::string project;
};

/// Reads keys from files: several files with one pose each (keys in the order given), or one with morph targets or an
/// animation. Buffers and images that a file names are looked up among the files. What a saved project holds
/// (export.h) becomes its keys again, unless an animation or samples are asked for. `progress` hears the stages with a
/// fraction of the whole in [0, 1] that never falls.
/// Errors: every ErrorCode of reading and of keys that do not fit; the message names file, key and place.
Result<Import> importKeyframes(std::span<const NamedBytes> files, const ImportOptions& options,
                               const StageProgress& progress = {});

}  // namespace shapespline
