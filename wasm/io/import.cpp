#include "io/import.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>
#include <utility>

#include "core/base/format.h"
#include "io/base/byte_text.h"
#include "io/base/sample_times.h"
#include "io/far_offset.h"
#include "io/file_kind.h"
#include "io/frame_source.h"
#include "io/gltf/gltf_reader.h"
#include "io/import_hints.h"
#include "io/import_motion.h"
#include "io/import_poses.h"
#include "io/join_keys.h"
#include "io/numbered_files.h"
#include "io/pose_reader.h"

namespace shapespline {

namespace {

struct FoundFiles {
  std::vector<MeshFile> meshes;
  std::vector<Error> others;  // errors for files of other kinds in the selection
  std::vector<Warning> warnings;
};

Result<FoundFiles> findMeshes(std::span<const NamedBytes> files) {
  FoundFiles found;
  for (const NamedBytes& file : files) {
    if (isCompanion(file)) continue;
    const int key = static_cast<int>(found.meshes.size());
    const bool isNamed = isMeshName(file.name);
    const auto kind = fileKind(file, isNamed ? placeName(file, key, files.size()) : std::string(baseName(file.name)));
    if (kind) {
      found.meshes.push_back({&file, *kind});
      const std::string other = otherExtension(file.name, *kind);
      if (!other.empty() && found.warnings.empty())
        found.warnings.push_back({"other-extension", placeName(file, key, 1) + other, 0});
      if (!other.empty()) ++found.warnings[0].count;
      continue;
    }
    Error error = kind.error();
    if (files.size() > 1) error.key = key;
    if (isNamed) return error;
    found.others.push_back(std::move(error));
  }
  return found;
}

// Adds a warning for each error, up to a limit.
void warnOfOthers(const std::vector<Error>& others, std::vector<Warning>& warnings) {
  constexpr std::size_t most = 10;
  for (std::size_t i = 0; i < others.size() && i < most; ++i)
    warnings.push_back({"left-out-file", "A file is ignored: " + others[i].message, 1});
  if (others.size() > most)
    warnings.push_back({"left-out-file",
                        grouped(static_cast<std::int64_t>(others.size() - most)) + " more such files are ignored.",
                        static_cast<int>(others.size() - most)});
}

// The error for a single OBJ, PLY or OFF file. Errors in the file itself take precedence.
Error onePoseOnly(const MeshFile& mesh, const SourceFiles& files, const ImportOptions& options) {
  const std::string where = placeName(*mesh.file, 0, 1);
  const auto pose = PoseReader{files, options}.read(mesh, where);
  if (!pose) return pose.error();
  return {ErrorCode::TooFewKeys, where + " has only one pose. Add one file for each further key."};
}

Result<Import> readCaches(const std::vector<MeshFile>& meshes, const SourceFiles& files, const ImportOptions& options,
                          const StageProgress& progress) {
  if (meshes.size() == 1)
    return Error{ErrorCode::TooFewKeys,
                 placeName(*meshes[0].file, 0, 1) + " has a motion without its mesh. Give its OBJ as well."};
  if (meshes.size() == 2 && isCache(meshes[0].kind) != isCache(meshes[1].kind)) {
    const int cache = isCache(meshes[0].kind) ? 0 : 1;
    return importCache(meshes[1 - cache], meshes[cache], files, options, progress);
  }
  return Error{ErrorCode::InvalidOption,
               "A PC2 or MDD file stores the motion of one mesh. Give it with one OBJ and no other file."};
}

// Whether all files show the same pose, and have animations of one pose each.
bool showsActions(const Import& import) {
  return !import.animations.empty() &&
         std::none_of(import.animations.begin(), import.animations.end(), [](const auto& a) { return a.moves; }) &&
         allSame(import.keyframes);
}

// Uses the animations' poses, one key each, if they differ. Poses added to a mesh come one at a time.
Result<Import> orByActions(Import&& import, const std::vector<MeshFile>& meshes, const SourceFiles& files,
                           const ImportOptions& options, const StageProgress& progress) {
  auto actions = importAnimations(meshes, files, options, progress);
  const bool useful = actions && actions->animation < 0 && actions->keyframes.keyCount() > 1 &&
                      (!options.like.empty() || !allSame(actions->keyframes));
  return useful ? std::move(actions) : Result<Import>(std::move(import));
}

Result<Import> readSeveral(const std::vector<MeshFile>& meshes, const SourceFiles& files, const ImportOptions& options,
                           const StageProgress& progress) {
  const auto series = numberedFiles(meshes);
  const bool many = series && meshes.size() > maxOwnKeys && options.keyTimes.empty() && options.like.empty();
  if (series && (many || options.animationAsked())) return importSeries(*series, files, options, progress);
  if (!options.animationAsked()) {
    auto import = importPoses(meshes, files, options, progress);
    if (import && showsActions(*import)) return orByActions(std::move(*import), meshes, files, options, progress);
    if (import && series && meshes.size() > static_cast<std::size_t>(options.sampleCount))
      import->animations = {infoOf({series->name, series->seconds, {}})};
    if (const std::string sequences = sequencesAmong(meshes); import && !sequences.empty())
      import->warnings.push_back({"several-sequences",
                                  "The files belong to several numbered sequences, which became keys of one motion: " +
                                      sequences + ". If that is not intended, give the files of one sequence.",
                                  static_cast<int>(meshes.size())});
    return import;
  }
  if (areAll(meshes, FileKind::Gltf)) return importAnimations(meshes, files, options, progress);
  return Error{ErrorCode::InvalidOption,
               "Keys can be sampled from an animation, from numbered OBJ or PLY files or from a mesh with its PC2 or "
               "MDD. Each of these " +
                   grouped(std::int64_t(meshes.size())) + " files is a key. Omit the animation and the samples."};
}

// Animations in files without a mesh move the bones of the only file with a mesh.
Result<Import> readWithMotions(const std::vector<MeshFile>& meshes, const SourceFiles& files,
                               const ImportOptions& options, const StageProgress& progress) {
  auto import = readSeveral(meshes, files, options, progress);
  if (import || !areAll(meshes, FileKind::Gltf)) return import;
  const ErrorCode code = import.error().code;
  if (code != ErrorCode::NoTriangles && code != ErrorCode::UnknownAnimation) return import;
  std::vector<const NamedBytes*> motions, shapes;
  for (const MeshFile& mesh : meshes) (isMotionOnly(*mesh.file, files) ? motions : shapes).push_back(mesh.file);
  if (motions.empty() || shapes.size() != 1) return import;
  return readGltfKeys(*shapes[0], files, options, placeName(*shapes[0], 0, 1), progress, motions);
}

// Maps added poses to the vertices of the mesh. where: the name of their file.
Result<Import> likeTheMesh(Import&& import, const ImportOptions& options, const std::string& where) {
  if (options.likePose.empty()) return std::move(import);
  Import mesh;
  mesh.keyframes = {options.like, {{"mesh", 0, options.likePose}}, {}};
  const std::size_t n = options.likePose.size(), count = import.keyframes.vertexCount();
  mesh.scene.objects = options.likeObjects;
  if (Status added = KeyJoiner(mesh).add(import.keyframes.faces, import.keyframes.keys, where, import.scene.objects);
      !added)
    return added.error();
  if (mesh.keyframes.keys[0].positions.size() != n) return vertexCountMismatch(where, 0, count, n);
  mesh.keyframes.keys.erase(mesh.keyframes.keys.begin());
  import.keyframes = {options.like, std::move(mesh.keyframes.keys), {}};
  import.scene = {};
  import.scene.groups = {{0, import.keyframes.faceCount(), -1}};
  return std::move(import);
}

Status checkLike(const ImportOptions& options) {
  const int n = static_cast<int>(options.likePose.size());
  for (const Triangle& f : options.like)
    for (int v : f)
      if (n > 0 && (v < 0 || v >= n))
        return Error{ErrorCode::InvalidOption, "A face of the reference mesh refers to a vertex that does not exist."};
  if (n > 0 && options.like.empty()) return Error{ErrorCode::InvalidOption, "The reference mesh has no faces."};
  return {};
}

Result<Import> readKeys(const std::vector<MeshFile>& meshes, const SourceFiles& files, const ImportOptions& options,
                        const StageProgress& progress) {
  if (meshes.empty())
    return Error{ErrorCode::TooFewKeys, files.empty() ? "No files were given. Give at least two poses of one mesh."
                                                      : "No mesh in these files. Use glTF, OBJ, PLY or OFF."};
  if (std::any_of(meshes.begin(), meshes.end(), [](const MeshFile& mesh) { return isCache(mesh.kind); }))
    return readCaches(meshes, files, options, progress);
  if (meshes.size() > 1) return readWithMotions(meshes, files, options, progress);
  if (meshes[0].kind != FileKind::Gltf) return onePoseOnly(meshes[0], files, options);
  auto import = readGltfKeys(*meshes[0].file, files, options, placeName(*meshes[0].file, 0, 1), progress);
  return import;
}

Status setTimes(Keyframes& keyframes, const std::vector<double>& times) {
  if (times.empty()) return {};
  if (Status valid = validateTimes(times, keyframes.keyCount()); !valid) return valid;
  for (std::size_t j = 0; j < times.size(); ++j) keyframes.keys[j].time = times[j];
  return {};
}

// Warns that axis and unit options do not apply: glTF is Y up and in metres.
void checkOrientation(const std::vector<MeshFile>& meshes, const ImportOptions& options,
                      std::vector<Warning>& warnings) {
  const auto isGltf = [](const MeshFile& mesh) { return mesh.kind == FileKind::Gltf; };
  const auto count = std::count_if(meshes.begin(), meshes.end(), isGltf);
  if (count == 0 || (!options.zUp && options.unit == 1)) return;
  warnings.push_back({"orientation-ignored",
                      "The up axis and the unit apply to OBJ, PLY and OFF files only. They have no "
                      "effect on glTF files, which define both.",
                      static_cast<int>(count)});
}

// Runs a check whose error names the file: at its start, or as the name of the key if every key has its own file.
template <class Check>
Status checkFiles(const std::vector<MeshFile>& meshes, std::vector<Key>& keys, const Check& check) {
  const bool isOneEach = meshes.size() > 1 && meshes.size() == keys.size();
  std::vector<std::string> names;
  for (const MeshFile& mesh : meshes) names.emplace_back(baseName(mesh.file->name));
  const auto exchange = [&] {
    for (std::size_t j = 0; isOneEach && j < keys.size(); ++j) std::swap(keys[j].name, names[j]);
  };
  exchange();
  Status status = check();
  exchange();
  if (status || meshes.size() > 1) return status;
  Error error = status.error();
  error.message = placeName(*meshes[0].file, 0, 1) + ": " + error.message;
  return error;
}

Result<Import> importChecked(std::span<const NamedBytes> files, const ImportOptions& options,
                             const StageProgress& progress) {
  if (!(options.unit > 0) || !std::isfinite(options.unit))
    return Error{ErrorCode::InvalidOption, "The unit must be a positive number of metres."};
  const auto found = findMeshes(files);
  if (!found) return found.error();
  if (Status like = checkLike(options); !like) return like.error();
  const std::vector<MeshFile>& meshes = found->meshes;
  auto read = readKeys(meshes, SourceFiles(files), options, progress);
  // The missing keys may be in skipped files.
  if (!read && read.error().code == ErrorCode::TooFewKeys && !found->others.empty()) return found->others[0];
  if (!read) return read;
  const auto subtract = [&] { return subtractOffset(*read, options); };
  if (Status local = checkFiles(meshes, read->keyframes.keys, subtract); !local) return local.error();
  auto keys = likeTheMesh(std::move(*read), options, placeName(*meshes[0].file, 0, 1));
  if (!keys) return keys;
  warnOfOthers(found->others, keys->warnings);
  keys->warnings.insert(keys->warnings.end(), found->warnings.begin(), found->warnings.end());
  checkOrientation(meshes, options, keys->warnings);
  if (Status times = setTimes(keys->keyframes, options.keyTimes); !times) return times.error();
  const auto areValid = [&] { return validate(keys->keyframes); };
  if (Status valid = checkFiles(meshes, keys->keyframes.keys, areValid); !valid) return valid.error();
  warnOfRounding(*keys);
  warnOfDistantKeys(*keys);
  return keys;
}

}  // namespace

Result<Import> importKeyframes(std::span<const NamedBytes> files, const ImportOptions& options,
                               const StageProgress& progress) {
  // Libraries may throw on unexpected input. No exception leaves this folder.
  try {
    return importChecked(files, options, progress);
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::OutOfMemory,
                 "There is not enough memory for these files. Simplify the mesh or use fewer keys."};
  } catch (const std::length_error&) {
    return Error{ErrorCode::OutOfMemory,
                 "There is not enough memory for these files. Simplify the mesh or use fewer keys."};
  } catch (const std::exception& e) {
    return Error{ErrorCode::MalformedFile,
                 std::string("The files could not be read (") + e.what() + "). Export them again."};
  }
}

}  // namespace shapespline
