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
  /// k in [0, seconds.size() + stills). Normals: 3n unit vectors, or empty for a file without normals.
  std::function<Status(int frame, std::vector<float>& positions, std::vector<float>& normals)> frame;
  /// JSON object for extras.shapespline of the file, or empty. Import takes the keys from its member
  /// "keys": {"times": [...], "names": [...], "frames": [...]}, frames counted as above ("seconds" on this timeline do
  /// as well where all keys are played), and hands the whole back.
  std::string project;
};

/// One GLB, with the scene's seams split open where it has textures: a mesh whose base is frame 0 and a morph target
/// for every later frame, and one LINEAR weight animation that plays them (glTF 2.0). Passes the Khronos validator
/// without error or warning. Errors: InvalidOption for times that do not increase from 0, NotFinite with the frame as
/// `key`, TooLarge where the file would not open again (2 GB; 16 million weights, which are some 4,000 frames), and
/// whatever `frame` returns.
Result<std::vector<std::uint8_t>> writeAnimatedGlb(const AnimationSource& source);

/// Bytes that writeAnimatedGlb will produce, to a few percent. `frames` counts stills too.
std::uint64_t animatedGlbSize(int vertices, int faces, int frames, const Scene& scene);

/// One pose. positions: 3n; normals: 3n or empty.
Result<std::vector<std::uint8_t>> writePoseGlb(std::span<const float> positions, std::span<const float> normals,
                                               const std::vector<Triangle>& faces, const Scene& scene);

}  // namespace shapespline
