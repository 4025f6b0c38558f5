#include "io/import.h"

#include <algorithm>

#include "core/text.h"
#include "io/byte_text.h"
#include "io/file_kind.h"
#include "io/gltf_reader.h"

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
    const auto kind = fileKind(file, std::string(baseName(file.name)));
    if (!kind) {
      Error error = kind.error();
      error.key = key;
      return error;
    }
    meshes.push_back({&file, *kind});
  }
  return meshes;
}

Result<PoseFile> readPose(const MeshFile& mesh, std::span<const NamedBytes> files, const std::string& where) {
  return readGltfPose(*mesh.file, files, where);
}

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
                       grouped(k.vertexCount()) + ". All keys must come from one mesh.", key};
    if (Status same = compareFaces(k.faces, pose.faces, key, std::string(baseName(mesh.file->name))); !same) return same;
  }
  k.keys.push_back({keyName(*mesh.file), 0, std::move(pose.positions)});
  return {};
}

Result<Import> importPoses(const std::vector<MeshFile>& meshes, std::span<const NamedBytes> files) {
  Import out;
  for (std::size_t j = 0; j < meshes.size(); ++j) {
    const int key = static_cast<int>(j);
    const std::string where = placeName(*meshes[j].file, key, meshes.size());
    auto pose = readPose(meshes[j], files, where);
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

Result<Import> readKeys(const std::vector<MeshFile>& meshes, std::span<const NamedBytes> files, const ImportOptions& options) {
  if (meshes.empty())
    return Error{ErrorCode::TooFewKeys, files.empty() ? "No files were given. Give at least two poses of one mesh."
                                                      : "None of the files holds a mesh. Give glTF, OBJ, PLY or OFF files."};
  if (meshes.size() > 1) return importPoses(meshes, files);
  return readGltfKeys(*meshes[0].file, files, options, placeName(*meshes[0].file, 0, 1));
}

Status setTimes(Keyframes& keyframes, const std::vector<double>& times) {
  if (times.empty()) return {};
  if (Status valid = validateTimes(times, keyframes.keyCount()); !valid) return valid;
  for (std::size_t j = 0; j < times.size(); ++j) keyframes.keys[j].time = times[j];
  return {};
}

Result<Import> importChecked(std::span<const NamedBytes> files, const ImportOptions& options) {
  const auto meshes = meshFiles(files);
  if (!meshes) return meshes.error();
  auto keys = readKeys(*meshes, files, options);
  if (!keys) return keys;
  if (Status times = setTimes(keys->keyframes, options.keyTimes); !times) return times.error();
  if (Status valid = validate(keys->keyframes); !valid) return valid.error();
  return keys;
}

}  // namespace

Result<Import> importKeyframes(std::span<const NamedBytes> files, const ImportOptions& options) {
  // The libraries below throw on what they do not expect; no exception leaves this folder.
  try {
    return importChecked(files, options);
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::OutOfMemory, "There is not enough memory for these files. Simplify the mesh or take fewer keys."};
  } catch (const std::length_error&) {
    return Error{ErrorCode::OutOfMemory, "There is not enough memory for these files. Simplify the mesh or take fewer keys."};
  } catch (const std::exception& e) {
    return Error{ErrorCode::MalformedFile, std::string("The files could not be read (") + e.what() + "). Export them again."};
  }
}

}  // namespace shapespline
