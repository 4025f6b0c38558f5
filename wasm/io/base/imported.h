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
  std::variant<std::monostate, int, std::string>
      animation;                    ///< default: the first animation that moves, with its parts; "all": all together
  std::vector<double> sampleTimes;  ///< seconds on the animation's timeline; overrides sampleCount
  int sampleCount = 8;              ///< evenly spaced frames; for more than 32 key times or several animations
  bool sampleAsked = false;         ///< the user chose sampleCount: use it even for few key times
  bool everyFrame = false;          ///< use each frame as a key; overrides sampleCount
  bool posedByActions = false;      ///< for poses: apply the only animation if it does not move
  bool withHidden = false;          ///< for poses: include meshes hidden by KHR_node_visibility
  bool oneKeyWillDo = false;        ///< accept a still animation as one key: the file is one of several
  std::vector<double> frameTimes;   ///< frame times, in seconds, for formats that store none
  std::vector<double> keyTimes;     ///< default: the animation's times, or even times over [0, 1]
  bool zUp = false;                 ///< the file is Z up; OBJ, PLY and OFF only
  double unit = 1;                  ///< metres per unit; OBJ, PLY and OFF only
  /// Faces and optional pose of a reference mesh, for adding poses. Polygons are cut into its triangles. With a pose,
  /// the keys use its vertices.
  std::vector<Triangle> like;
  Positions likePose;
  std::optional<Vec3> offset;            ///< subtracted from all positions (far_offset.h); default: computed
  std::vector<ObjectFaces> likeObjects;  ///< objects of the faces in `like`; empty if unknown
  std::vector<std::string> objects;      ///< names of the objects to import; empty for all

  bool animationAsked() const {
    return !std::holds_alternative<std::monostate>(animation) || !sampleTimes.empty() || sampleAsked || everyFrame;
  }
};

struct AnimationInfo {
  std::string name;
  double start = 0, end = 0;  ///< in seconds
  int keys = 0;               ///< distinct key times
  bool moves = true;          ///< false: the animation is a single pose, with any number of key times
  std::vector<int> together;  ///< for an entry of several animations that play together, their indices
};

/// How an object of one pose was matched with another.
enum class MatchRule { Name, Shape, Order };

struct MatchedObject {
  int key = 0;         ///< first key of the other object's file
  std::string object;  ///< object name in the first key
  std::string found;   ///< object name in the other file
  MatchRule rule = MatchRule::Order;
};

struct Import {
  Keyframes keyframes;
  Scene scene;
  std::vector<AnimationInfo> animations;
  int animation = -1;                  ///< index of the animation that provided the keys, or -1
  std::vector<std::string> objects;    ///< names of optional objects in the first file, without duplicates
  std::vector<MatchedObject> matches;  ///< matches in later files with objects; at most maxObjects
  std::vector<Warning> warnings;
  /// Offset subtracted from all positions in double precision, in metres with Y up: position + offset is the true
  /// position. Readers set the offset of a saved project.
  Vec3 offset = Vec3::Zero();
  double rounding = 0;    ///< largest single-precision rounding of the stored positions, in metres
  std::string roundedIn;  ///< display name of the file with the largest rounding

  void noteRounding(double distance, const std::string& where) {
    if (distance > rounding) {
      rounding = distance;
      roundedIn = where;
    }
  }
  /// JSON of extras.shapespline if the keys come from a saved project, else empty.
  std::string project;
};

}  // namespace shapespline
