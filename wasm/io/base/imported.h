// Options and result of an import: keyframes and their scene.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/types.h"
#include "core/base/warning.h"
#include "core/sequence/keyframes.h"
#include "io/base/scene.h"

namespace shapespline {

struct ImportOptions {
  std::variant<std::monostate, int, std::string> animation;  ///< default: the first one that moves
  std::vector<double> sampleTimes;  ///< seconds on the animation's own timeline; wins over sampleCount
  int sampleCount = 8;       ///< evenly spaced, used when the animation has more than 32 key times or there are several
  bool sampleAsked = false;  ///< sampleCount was given by the user: use it even for few key times
  bool everyFrame = false;   ///< each frame of the animation is a key; wins over sampleCount
  bool posedByActions = false;     ///< poses: as an animation shows them that is the only one and does not move
  bool withHidden = false;         ///< poses: also show what KHR_node_visibility hides
  bool oneKeyWillDo = false;       ///< an animation that does not move is a key: the file is one of several
  std::vector<double> frameTimes;  ///< that the files state for frames of a format without times; seconds
  std::vector<double> keyTimes;    ///< default: the animation's own times, else evenly over [0, 1]
  bool zUp = false;                ///< OBJ, PLY and OFF only
  double unit = 1;                 ///< metres per unit, OBJ, PLY and OFF only
  /// Faces and a pose of a reference mesh, for adding poses: polygons are cut into its triangles, and with a pose the
  /// keys use its vertices.
  std::vector<Triangle> like;
  Positions likePose;
  std::optional<Vec3> offset;            ///< subtracted from all positions (far_offset.h); default: computed
  std::vector<ObjectFaces> likeObjects;  ///< of these faces; empty if unknown
  std::vector<std::string> objects;      ///< the objects of each file that are taken; empty for all of them

  bool animationAsked() const {
    return !std::holds_alternative<std::monostate>(animation) || !sampleTimes.empty() || sampleAsked || everyFrame;
  }
};

struct AnimationInfo {
  std::string name;
  double start = 0, end = 0;  ///< seconds
  int keys = 0;               ///< distinct key times
  bool moves = true;          ///< else it is one pose, however many keys it has
};

/// How an object of one pose was found in another.
enum class MatchRule { Name, Shape, Order };

struct MatchedObject {
  int key = 0;         ///< the first key of the file that holds the other one
  std::string object;  ///< in the first key
  std::string found;   ///< there
  MatchRule rule = MatchRule::Order;
};

struct Import {
  Keyframes keyframes;
  Scene scene;
  std::vector<AnimationInfo> animations;
  int animation = -1;  ///< which one the keys were taken from
  std::vector<std::string>
      objects;  ///< names of objects that may be left out: those of the first file, without duplicates
  std::vector<MatchedObject> matches;  ///< of files with objects, after the first; at most mostObjects
  std::vector<Warning> warnings;
  /// Subtracted from all positions in double precision, in metres with Y up: position + offset is the true position.
  /// From a reader: the offset of a saved project.
  Vec3 offset = Vec3::Zero();
  double rounding = 0;    ///< how far single precision may have moved the positions that the files store, in metres
  std::string roundedIn;  ///< the file with the largest rounding, as messages call it

  void noteRounding(double distance, const std::string& where) {
    if (distance > rounding) rounding = distance, roundedIn = where;
  }
  /// JSON of extras.shapespline where the keys were taken from a saved project, else empty.
  std::string project;
};

}  // namespace shapespline
