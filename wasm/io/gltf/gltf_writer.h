// Writes poses and motions as GLB.
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

/// A sequence of shapes to write. Each frame's 3n positions are requested once, in order.
struct AnimationSource {
  const std::vector<Triangle>* faces = nullptr;
  const Scene* scene = nullptr;
  std::vector<double> seconds;  ///< display time of each frame, strictly increasing from 0
  /// Number of extra frames after those of `seconds`, never shown by the animation. They store keys outside the
  /// exported range, so the file contains the whole project.
  int stills = 0;
  /// If empty, frame k is shown alone at seconds[k]. Otherwise one row per time, with a weight for each frame except
  /// the base; the row length determines the number of frames.
  std::vector<float> weights{};
  /// k in [0, shapes()). Normals: n unit vectors as 3n numbers, or empty for a file without normals.
  std::function<Status(int frame, std::vector<float>& positions, std::vector<float>& normals)> frame;
  /// JSON object for extras.shapespline of the file, or empty. Import reads the keys from its member
  /// "keys": {"times": [...], "names": [...], "frames": [...]}, with frames counted as above, and returns the whole
  /// object. "seconds" on this timeline can replace "frames" if all keys are played.
  std::string project{};
  Vec3 offset = Vec3::Zero();              ///< offset of all positions; becomes the node's translation
  std::string name{};                      ///< name of the node and its mesh, or empty
  std::string clip{};                      ///< name of the animation, or empty
  std::vector<std::string> targetNames{};  ///< names of all frames except the base, or empty

  int shapes() const {
    return static_cast<int>(weights.empty() ? seconds.size() + stills : 1 + weights.size() / seconds.size());
  }
};

/// Writes one GLB (glTF 2.0), split at the scene's seams if it has textures: a mesh with frame 0 as base, a morph
/// target for every later frame, and one LINEAR weight animation. Every primitive has its own vertices, which store
/// their mesh vertices (gltf_vertices). Passes the Khronos validator without error or warning. Errors: InvalidOption if
/// times do not increase from 0; NotFinite with the frame as `key`; TooLarge if the file could not be opened again (2
/// GB, or 16 million weights, which is about 4,000 frames); and the errors of `frame`.
Result<std::vector<std::uint8_t>> writeAnimatedGlb(const AnimationSource& source);

struct GlbSize {
  std::uint64_t bytes = 0;     ///< size of the writeAnimatedGlb output, within a few percent
  std::uint64_t vertices = 0;  ///< total of all primitives, which players hold for every target
};

/// `frames`: including stills.
GlbSize animatedGlbSize(const std::vector<Triangle>& faces, int vertices, int frames, const Scene& scene);

/// Writes one pose. positions: 3n; normals: 3n or empty; offset: as in AnimationSource.
Result<std::vector<std::uint8_t>> writePoseGlb(std::span<const float> positions, std::span<const float> normals,
                                               const std::vector<Triangle>& faces, const Scene& scene,
                                               const Vec3& offset = Vec3::Zero());

}  // namespace shapespline
