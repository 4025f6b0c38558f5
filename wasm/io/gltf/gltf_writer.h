// Poses and motions -> GLB.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/base/status.h"
#include "core/base/types.h"
#include "io/base/scene.h"

namespace shapespline {

/// A sequence of shapes to be written: frame k's 3n positions are asked for once, in order.
struct AnimationSource {
  const std::vector<Triangle>* faces = nullptr;
  const Scene* scene = nullptr;
  std::vector<double> seconds;  ///< strictly increasing, the first is 0: when each frame is shown
  /// Frames behind those of `seconds` that the animation never shows: a place for keys outside the exported range, so
  /// that the file still holds the whole project.
  int stills = 0;
  /// Empty: frame k is shown alone at seconds[k]. Else a row for every time, with a weight for each frame but the
  /// first, which all others are added to; how many frames there are follows from it.
  std::vector<float> weights{};
  /// k in [0, shapes()). Normals: 3n unit vectors, or empty for a file without normals.
  std::function<Status(int frame, std::vector<float>& positions, std::vector<float>& normals)> frame;
  /// JSON object for extras.shapespline of the file, or empty. Import takes the keys from its member
  /// "keys": {"times": [...], "names": [...], "frames": [...]}, frames counted as above ("seconds" on this timeline do
  /// as well where all keys are played), and hands the whole back.
  std::string project{};
  Vec3 offset = Vec3::Zero();              ///< of all positions: becomes the node's translation
  std::string name{};                      ///< of the node and its mesh, or empty
  std::vector<std::string> targetNames{};  ///< of every frame but the first, or empty

  int shapes() const {
    return static_cast<int>(weights.empty() ? seconds.size() + stills : 1 + weights.size() / seconds.size());
  }
};

/// One GLB (glTF 2.0), split at the scene's seams if it has textures: a mesh whose base is frame 0, a morph target for
/// every later frame, and one LINEAR weight animation. Every primitive has its own vertices, which state their mesh
/// vertices (gltf_vertices). Passes the Khronos validator without error or warning. Errors: InvalidOption if times do
/// not increase from 0; NotFinite with the frame as `key`; TooLarge if the file would not open again (2 GB, or 16
/// million weights, which is about 4,000 frames); and the errors of `frame`.
Result<std::vector<std::uint8_t>> writeAnimatedGlb(const AnimationSource& source);

struct GlbSize {
  std::uint64_t bytes = 0;     ///< that writeAnimatedGlb will produce, to a few percent
  std::uint64_t vertices = 0;  ///< of all primitives together, which is what players hold for every target
};

/// `frames` counts stills too.
GlbSize animatedGlbSize(const std::vector<Triangle>& faces, int vertices, int frames, const Scene& scene);

/// One pose. positions: 3n; normals: 3n or empty; offset: as of an animation.
Result<std::vector<std::uint8_t>> writePoseGlb(std::span<const float> positions, std::span<const float> normals,
                                               const std::vector<Triangle>& faces, const Scene& scene,
                                               const Vec3& offset = Vec3::Zero());

}  // namespace shapespline
