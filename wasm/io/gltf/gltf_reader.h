// glTF -> keys: one pose, morph targets, a sampled animation, or the keys of a saved project.
#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/status.h"
#include "core/base/warning.h"
#include "io/base/given_files.h"
#include "io/base/imported.h"
#include "io/base/named_bytes.h"
#include "io/base/scene.h"

namespace shapespline {

/// One pose with everything around it.
struct PoseFile {
  Positions positions;
  std::vector<Triangle> faces;
  Positions normals;  ///< n, or empty
  Scene scene;
  std::vector<Warning> warnings;
  std::vector<std::string> objects;       ///< names of objects that may be left out, without duplicates
  std::vector<AnimationInfo> animations;  ///< of the file's own
  bool isPosed = false;                   ///< by one animation, which does not move
  std::string action;                     ///< the applied animation, if any
  bool hides = false;                     ///< some of its meshes are hidden (KHR_node_visibility)
  bool skinned = false;                   ///< bones pose it
  bool writtenZUp = false;                ///< its program writes this format with z up
  Vec3 offset = Vec3::Zero();  ///< stated in the file: its numbers are relative to it; the positions include it
  double rounding = 0;         ///< as Import::rounding
};

/// The scene as the file itself poses it. `where` is how messages call the file.
Result<PoseFile> readGltfPose(const NamedBytes& file, const GivenFiles& files, const ImportOptions& options,
                              const std::string& where, const FractionReport& onProgress = {});

/// Several keys of one file. Times are set; nothing is validated beyond what reading needs.
Result<Import> readGltfKeys(const NamedBytes& file, const GivenFiles& files, const ImportOptions& options,
                            const std::string& where, const StageProgress& progress);

}  // namespace shapespline
