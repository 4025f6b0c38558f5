#include "io/import.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <optional>
#include <stdexcept>

#include "core/base/format.h"
#include "io/base/byte_text.h"
#include "io/file_kind.h"
#include "io/gltf/gltf_reader.h"
#include "io/polygon/polygon_readers.h"

namespace shapespline {

namespace {

// How messages call a key's file.
std::string placeName(const NamedBytes& file, int key, std::size_t keys) {
  const std::string name(baseName(file.name));
  return keys > 1 ? name + " (key " + std::to_string(key + 1) + ")" : name;
}

std::string keyName(const NamedBytes& file) {
  const std::string_view name = baseName(file.name);
  return std::string(name.substr(0, name.rfind('.')));
}

// A mesh file and what it is.
struct MeshFile {
  const NamedBytes* file;
  FileKind kind;
};

Result<std::vector<MeshFile>> meshFiles(std::span<const NamedBytes> files) {
  std::vector<MeshFile> meshes;
  for (const NamedBytes& file : files) {
    if (isCompanion(file.name)) continue;
    const int key = static_cast<int>(meshes.size());
    const auto kind = fileKind(file, placeName(file, key, files.size()));
    if (!kind) {
      Error error = kind.error();
      if (files.size() > 1) error.key = key;
      return error;
    }
    meshes.push_back({&file, *kind});
  }
  return meshes;
}

Result<PolygonMesh> readPolygons(const MeshFile& mesh, std::span<const NamedBytes> files, const std::string& where,
                                 const FractionReport& onProgress) {
  if (mesh.kind == FileKind::Obj) return readObj(*mesh.file, files, where, onProgress);
  return mesh.kind == FileKind::Ply ? readPly(*mesh.file, where, onProgress) : readOff(*mesh.file, where, onProgress);
}

// Y up, metres.
void orient(Positions& positions, bool zUp, double scale) {
  for (Vec3& p : positions) p = scale * (zUp ? Vec3(p.x(), p.z(), -p.y()) : p);
}

// Reads one pose after the other; polygons are cut as in the first one that has any.
struct PoseReader {
  std::span<const NamedBytes> files;
  const ImportOptions& options;
  std::optional<PolygonCuts> cuts;

  Result<PoseFile> read(const MeshFile& mesh, const std::string& where, const FractionReport& onProgress = {}) {
    if (mesh.kind == FileKind::Gltf) return readGltfPose(*mesh.file, files, where, onProgress);
    auto polygons = readPolygons(mesh, files, where, partOf(onProgress, 0, 0.8));
    if (!polygons) return polygons.error();
    orient(polygons->positions, options.zUp, options.unit);
    orient(polygons->normals, options.zUp, 1);
    if (!cuts) cuts = options.like.empty() ? cutPolygons(*polygons) : cutPolygonsLike(*polygons, options.like);
    reportFraction(onProgress, 0.85);
    PoseFile pose;
    pose.faces = trianglesOf(*polygons, *cuts);
    polygons->scene.seams.faces = drawnTrianglesOf(*polygons, *cuts);
    polygons->scene.groups = triangleGroups(*polygons);
    reportFraction(onProgress, 0.95);
    pose.positions = std::move(polygons->positions);
    pose.normals = std::move(polygons->normals);
    pose.scene = std::move(polygons->scene);
    pose.warnings = std::move(polygons->warnings);
    return pose;
  }
};

// Keys are compared and added one by one, so that only one file's scene is held beside the positions.
Status addPose(PoseFile&& pose, const MeshFile& mesh, Import& out, const std::string& where) {
  Keyframes& k = out.keyframes;
  const int key = k.keyCount();
  if (key == 0) {
    k.faces = std::move(pose.faces);
    k.normals = std::move(pose.normals);
    out.scene = std::move(pose.scene);
    out.warnings = std::move(pose.warnings);
  } else {
    if (pose.positions.size() != k.keys[0].positions.size())
      return Error{ErrorCode::VertexCountMismatch,
                   where + " has " + grouped(std::int64_t(pose.positions.size())) + " vertices but key 1 has " +
                       grouped(k.vertexCount()) + ". All keys must come from one mesh.",
                   key};
    if (Status same = compareFaces(k.faces, pose.faces, key, std::string(baseName(mesh.file->name))); !same)
      return same;
  }
  k.keys.push_back({keyName(*mesh.file), 0, std::move(pose.positions)});
  return {};
}

Result<Import> importPoses(const std::vector<MeshFile>& meshes, std::span<const NamedBytes> files,
                           const ImportOptions& options, const StageProgress& progress) {
  if (options.animationAsked())
    return Error{
        ErrorCode::InvalidOption,
        "Keys are sampled from an animation of one file, but " + grouped(std::int64_t(meshes.size())) +
            " files were given, each of which is a key. Give one file, or leave the animation and the samples out."};
  Import out;
  PoseReader reader{files, options, {}};
  for (std::size_t j = 0; j < meshes.size(); ++j) {
    const int key = static_cast<int>(j);
    const std::string where = placeName(*meshes[j].file, key, meshes.size());
    const auto onPose = [&](double fraction) {
      if (progress)
        progress("reading the poses", (static_cast<double>(j) + fraction) / static_cast<double>(meshes.size()));
    };
    onPose(0);
    auto pose = reader.read(meshes[j], where, onPose);
    Status added = pose ? addPose(std::move(*pose), meshes[j], out, where) : Status(pose.error());
    if (added) continue;
    Error error = added.error();
    error.key = key;
    return error;
  }
  const std::vector<double> times = evenTimes(static_cast<int>(meshes.size()));
  for (std::size_t j = 0; j < meshes.size(); ++j) out.keyframes.keys[j].time = times[j];
  return out;
}

// A lone OBJ, PLY or OFF cannot be enough, but what is wrong in it comes first.
Error onePoseOnly(const MeshFile& mesh, std::span<const NamedBytes> files, const ImportOptions& options) {
  const std::string where = placeName(*mesh.file, 0, 1);
  const auto pose = PoseReader{files, options, {}}.read(mesh, where);
  if (!pose) return pose.error();
  return {ErrorCode::TooFewKeys, where + " holds one pose only. Add a file for every other key."};
}

Result<Import> readKeys(const std::vector<MeshFile>& meshes, std::span<const NamedBytes> files,
                        const ImportOptions& options, const StageProgress& progress) {
  if (meshes.empty())
    return Error{ErrorCode::TooFewKeys, files.empty()
                                            ? "No files were given. Give at least two poses of one mesh."
                                            : "None of the files holds a mesh. Give glTF, OBJ, PLY or OFF files."};
  if (meshes.size() > 1) return importPoses(meshes, files, options, progress);
  if (meshes[0].kind != FileKind::Gltf) return onePoseOnly(meshes[0], files, options);
  return readGltfKeys(*meshes[0].file, files, options, placeName(*meshes[0].file, 0, 1), progress);
}

Status setTimes(Keyframes& keyframes, const std::vector<double>& times) {
  if (times.empty()) return {};
  if (Status valid = validateTimes(times, keyframes.keyCount()); !valid) return valid;
  for (std::size_t j = 0; j < times.size(); ++j) keyframes.keys[j].time = times[j];
  return {};
}

// glTF is y up and in metres: what else was asked for does not fit.
void checkOrientation(const std::vector<MeshFile>& meshes, const ImportOptions& options,
                      std::vector<Warning>& warnings) {
  const auto isGltf = [](const MeshFile& mesh) { return mesh.kind == FileKind::Gltf; };
  const auto count = std::count_if(meshes.begin(), meshes.end(), isGltf);
  if (count == 0 || (!options.zUp && options.unit == 1)) return;
  warnings.push_back({"orientation-ignored",
                      "The up axis and the unit are for OBJ, PLY and OFF files; glTF states its own, so "
                      "they do not change it.",
                      static_cast<int>(count)});
}

// What is wrong with the keys names them; their file belongs to it.
Error withFile(Error error, const std::vector<MeshFile>& meshes, const Keyframes& keyframes) {
  if (meshes.size() == 1) {
    error.message = placeName(*meshes[0].file, 0, 1) + ": " + error.message;
  } else if (error.key >= 0 && error.message.starts_with(keyframes.keys[error.key].name)) {
    error.message.replace(0, keyframes.keys[error.key].name.size(), baseName(meshes[error.key].file->name));
  }
  return error;
}

Result<Import> importChecked(std::span<const NamedBytes> files, const ImportOptions& options,
                             const StageProgress& progress) {
  if (!(options.unit > 0) || !std::isfinite(options.unit))
    return Error{ErrorCode::InvalidOption, "The unit must be a positive number of metres."};
  const auto meshes = meshFiles(files);
  if (!meshes) return meshes.error();
  auto keys = readKeys(*meshes, files, options, progress);
  if (!keys) return keys;
  checkOrientation(*meshes, options, keys->warnings);
  if (Status times = setTimes(keys->keyframes, options.keyTimes); !times) return times.error();
  if (Status valid = validate(keys->keyframes); !valid) return withFile(valid.error(), *meshes, keys->keyframes);
  return keys;
}

}  // namespace

Result<Import> importKeyframes(std::span<const NamedBytes> files, const ImportOptions& options,
                               const StageProgress& progress) {
  // The libraries below throw on what they do not expect; no exception leaves this folder.
  try {
    return importChecked(files, options, progress);
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::OutOfMemory,
                 "There is not enough memory for these files. Simplify the mesh or take fewer keys."};
  } catch (const std::length_error&) {
    return Error{ErrorCode::OutOfMemory,
                 "There is not enough memory for these files. Simplify the mesh or take fewer keys."};
  } catch (const std::exception& e) {
    return Error{ErrorCode::MalformedFile,
                 std::string("The files could not be read (") + e.what() + "). Export them again."};
  }
}

}  // namespace shapespline
