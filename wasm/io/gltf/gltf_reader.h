// Reads keys from glTF: one pose, morph targets, a sampled animation, or a saved project.
#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/status.h"
#include "core/base/warning.h"
#include "io/base/imported.h"
#include "io/base/named_bytes.h"
#include "io/base/scene.h"
#include "io/base/source_files.h"

namespace shapespline {

/// One pose with its scene and facts about its file.
struct PoseFile {
  Positions positions;
  std::vector<Triangle> faces;
  Positions normals;  ///< n unit normals, or empty
  Scene scene;
  std::vector<Warning> warnings;
  std::vector<std::string> objects;       ///< names of optional objects, without duplicates
  std::vector<AnimationInfo> animations;  ///< animations in the file
  bool isPosed = false;                   ///< posed by a still animation
  std::string action;                     ///< name of the applied animation, or empty
  bool hides = false;                     ///< some meshes are hidden (KHR_node_visibility)
  bool skinned = false;                   ///< posed by bones
  bool writtenZUp = false;                ///< written by a program that uses Z up in this format
  Vec3 offset = Vec3::Zero();             ///< offset stated in the file, already included in the positions
  double rounding = 0;                    ///< as in Import::rounding
};

/// Reads the scene in the pose stored in the file. `where`: display name of the file.
Result<PoseFile> readGltfPose(const NamedBytes& file, const SourceFiles& files, const ImportOptions& options,
                              const std::string& where, const FractionReport& onProgress = {});

/// Whether the file has animations but no mesh.
bool isMotionOnly(const NamedBytes& file, const SourceFiles& files);

/// Reads several keys from one file and sets their times. Validates only as far as reading requires. `motions`: files
/// without a mesh, whose animations move the nodes of this file with the same names.
Result<Import> readGltfKeys(const NamedBytes& file, const SourceFiles& files, const ImportOptions& options,
                            const std::string& where, const StageProgress& progress,
                            const std::vector<const NamedBytes*>& motions = {});

}  // namespace shapespline
