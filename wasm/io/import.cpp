#include "io/import.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <optional>
#include <stdexcept>

#include "core/base/format.h"
#include "core/mesh/mesh.h"
#include "io/base/byte_text.h"
#include "io/base/sample_times.h"
#include "io/cache/point_cache.h"
#include "io/file_kind.h"
#include "io/frame_source.h"
#include "io/gltf/gltf_reader.h"
#include "io/import_hints.h"
#include "io/join_keys.h"
#include "io/numbered_files.h"
#include "io/pose_reader.h"

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

bool areAll(const std::vector<MeshFile>& meshes, FileKind kind) {
  return std::all_of(meshes.begin(), meshes.end(), [&](const MeshFile& mesh) { return mesh.kind == kind; });
}

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

// The first pose brings the mesh and the scene; of the others only one is held beside the keys.
Status addPose(PoseFile&& pose, std::string name, Import& out, const std::string& where) {
  if (out.keyframes.keyCount() > 0)
    return KeyJoiner(out).add(pose.faces, {{std::move(name), 0, std::move(pose.positions)}}, where);
  out.keyframes = {std::move(pose.faces), {{std::move(name), 0, std::move(pose.positions)}}, std::move(pose.normals)};
  out.scene = std::move(pose.scene);
  out.warnings = std::move(pose.warnings);
  out.objects = std::move(pose.objects);
  return {};
}

// Only a file that says nothing else is asked: its up axis was not chosen.
void hintAtUpAxis(const PoseFile& pose, const MeshFile& mesh, const ImportOptions& options, const std::string& where,
                  std::vector<Warning>& warnings) {
  const bool silent = mesh.kind == FileKind::Ply || mesh.kind == FileKind::Off;
  if (silent && !options.zUp && (pose.writtenZUp || standsOnZ(pose.positions, pose.faces)))
    warnings.push_back(zUpWarning(where, pose.writtenZUp));
}

// Poses say nothing of time: from one to the next it takes a second.
void setTimesInSeconds(Keyframes& keyframes) {
  for (int j = 0; j < keyframes.keyCount(); ++j) keyframes.keys[j].time = j;
}

Error atKey(Error error, int key) {
  error.key = key;
  return error;
}

Result<Import> importPoses(const std::vector<MeshFile>& meshes, std::span<const NamedBytes> files,
                           const ImportOptions& options, const StageProgress& progress) {
  Import out;
  PoseReader reader{files, options};
  FileFacts facts{static_cast<int>(meshes.size()), 0, 0, areAll(meshes, FileKind::Gltf)};
  std::vector<AnimationInfo> animations;
  std::vector<Warning> hints;
  for (std::size_t j = 0; j < meshes.size(); ++j) {
    const int key = static_cast<int>(j);
    const std::string where = placeName(*meshes[j].file, key, meshes.size());
    const auto onPose = [&](double fraction) {
      if (progress)
        progress("reading the poses", (static_cast<double>(j) + fraction) / static_cast<double>(meshes.size()));
    };
    onPose(0);
    auto pose = reader.read(meshes[j], where, onPose);
    if (!pose) return atKey(pose.error(), key);
    facts.skinned += pose->skinned;
    facts.animated += !pose->animations.empty();
    if (j == 0) animations = std::move(pose->animations);
    if (j == 0) hintAtUpAxis(*pose, meshes[j], options, std::string(baseName(meshes[j].file->name)), hints);
    if (Status added = addPose(std::move(*pose), keyName(*meshes[j].file), out, where); !added)
      return atKey(added.error(), key);
  }
  std::move(hints.begin(), hints.end(), std::back_inserter(out.warnings));
  setTimesInSeconds(out.keyframes);
  warnOfSamePoses(facts, out);
  // Where nothing moves, the keys can be taken from what the files hold besides.
  const bool still = std::any_of(out.warnings.begin(), out.warnings.end(),
                                 [](const Warning& warning) { return warning.code == "same-poses"; });
  if (still && facts.animated == facts.files) out.animations = std::move(animations);
  return out;
}

bool sameKeys(const Keyframes& a, const Keyframes& b) {
  return a.faces == b.faces && std::equal(a.keys.begin(), a.keys.end(), b.keys.begin(), b.keys.end(),
                                          [](const Key& x, const Key& y) { return x.positions == y.positions; });
}

// Several files with an animation each: the keys of one after those of the other. Exporters write a rig's whole
// animation into every file, which counts once.
Result<Import> importAnimations(const std::vector<MeshFile>& meshes, std::span<const NamedBytes> files,
                                ImportOptions options, const StageProgress& progress) {
  options.oneKeyWillDo = true;
  std::optional<Import> out;
  Keyframes first;
  int repeated = 0;
  for (std::size_t j = 0; j < meshes.size(); ++j) {
    const std::string where = placeName(*meshes[j].file, static_cast<int>(j), meshes.size());
    const auto share = [&](const char* stage, double fraction) {
      if (progress) progress(stage, (static_cast<double>(j) + fraction) / static_cast<double>(meshes.size()));
    };
    auto import = readGltfKeys(*meshes[j].file, files, options, where, share);
    if (!import) return atKey(import.error(), static_cast<int>(j));
    if (!out) {
      first = import->keyframes;
      out = std::move(*import);
      continue;
    }
    if (sameKeys(first, import->keyframes)) {
      ++repeated;
      continue;
    }
    if (Status added = KeyJoiner(*out).add(import->keyframes.faces, std::move(import->keyframes.keys), where); !added)
      return atKey(added.error(), static_cast<int>(j));
  }
  if (repeated + 1 < static_cast<int>(meshes.size())) {
    for (int key = 0; key < out->keyframes.keyCount(); ++key)
      if (out->keyframes.keyCount() == static_cast<int>(meshes.size()))
        out->keyframes.keys[key].name = keyName(*meshes[key].file);
    setTimesInSeconds(out->keyframes);
  }
  if (repeated > 0)
    out->warnings.push_back(
        {"repeated-animation",
         "Some files hold the same animation as " + std::string(baseName(meshes[0].file->name)) + ": it is taken once.",
         repeated});
  return std::move(*out);
}

// The frames of a numbered series of files, each read when it is asked for.
Result<Import> importSeries(const std::vector<MeshFile>& meshes, const NumberedFiles& series,
                            std::span<const NamedBytes> files, const ImportOptions& options,
                            const StageProgress& progress) {
  Import out;
  PoseReader reader{files, options};
  auto mesh = reader.read(meshes[0], placeName(*meshes[0].file, 0, meshes.size()));
  if (!mesh) return atKey(mesh.error(), 0);
  hintAtUpAxis(*mesh, meshes[0], options, std::string(baseName(meshes[0].file->name)), mesh->warnings);
  if (Status added = addPose(std::move(*mesh), "mesh", out, ""); !added) return added.error();
  const auto n = out.keyframes.vertexCount();
  const auto frame = [&](std::size_t index) -> Result<Positions> {
    const std::string where = placeName(*meshes[index].file, static_cast<int>(index), meshes.size());
    auto pose = reader.read(meshes[index], where);
    if (!pose) return pose.error();
    const std::size_t count = pose->positions.size();
    Import one;
    one.keyframes = {out.keyframes.faces, {out.keyframes.keys[0]}, {}};
    if (Status added = KeyJoiner(one).add(pose->faces, {{"", 0, std::move(pose->positions)}}, where); !added)
      return added.error();
    if (one.keyframes.vertexCount() != n)
      return vertexCountMismatch(where, static_cast<int>(index), count, static_cast<std::size_t>(n));
    return std::move(one.keyframes.keys[1].positions);
  };
  const FrameSource source{series.name, series.seconds, frame};
  const std::string where = std::string(baseName(meshes[0].file->name));
  if (Status sampled = sampleFrames(source, options, where, out, progress); !sampled) return sampled.error();
  if (!options.animationAsked())
    out.warnings.push_back(
        {"numbered-files",
         grouped(static_cast<std::int64_t>(meshes.size())) +
             " numbered files are taken as frames of an animation, 24 a second: " + grouped(out.keyframes.keyCount()) +
             " evenly spaced ones of them are the keys. Choose others on its timeline (on the "
             "command line, with --sample).",
         static_cast<int>(meshes.size())});
  return out;
}

using Axes = Mat3;

// In which axes the cache shows the mesh: programs write them as they are, or with y and z exchanged.
Axes axesOf(const PointCache& cache, const Positions& mesh) {
  const Positions frames[] = {cache.frame(0), cache.frame(cache.seconds.size() - 1)};
  const Positions* one = &mesh;
  const double near = 1e-3 * boundingDiagonal({&one, 1});
  Axes zUp, exchanged, yUp;
  zUp << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  exchanged << 1, 0, 0, 0, 0, 1, 0, 1, 0;
  yUp << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  for (const Axes& axes : {Axes(Axes::Identity()), zUp, exchanged, yUp})
    for (const Positions& frame : frames)
      if (std::equal(frame.begin(), frame.end(), mesh.begin(),
                     [&](const Vec3& p, const Vec3& q) { return (axes * p - q).norm() <= near; }))
        return axes;
  return Axes::Identity();
}

// A mesh, and its vertices over time in another file.
Result<Import> importCache(const MeshFile& mesh, const MeshFile& moves, std::span<const NamedBytes> files,
                           const ImportOptions& options, const StageProgress& progress) {
  const std::string where = placeName(*mesh.file, 0, 1), place = placeName(*moves.file, 0, 1);
  PoseReader reader{files, options};
  auto pose = reader.read(mesh, where);
  if (!pose) return pose.error();
  const auto cache = moves.kind == FileKind::Pc2 ? readPc2(*moves.file, place) : readMdd(*moves.file, place);
  if (!cache) return cache.error();
  if (cache->points != pose->positions.size())
    return Error{ErrorCode::VertexCountMismatch,
                 place + " moves " + grouped(static_cast<std::int64_t>(cache->points)) + " points, but " + where +
                     " has " + grouped(static_cast<std::int64_t>(pose->positions.size())) +
                     " vertices. Export both from the same object, with the same modifiers."};
  Import out;
  hintAtUpAxis(*pose, mesh, options, where, pose->warnings);
  if (Status added = addPose(std::move(*pose), "mesh", out, where); !added) return added.error();
  const Axes axes = axesOf(*cache, out.keyframes.keys[0].positions);
  const bool own = axes == Axes::Identity();
  const auto frame = [&](std::size_t index) -> Result<Positions> {
    Positions positions = cache->frame(index);
    // In axes of its own it is seen as the mesh lies now, else it goes with the mesh.
    if (own) orient(positions, options.zUp, options.unit);
    else
      for (Vec3& p : positions) p = axes * p;
    return positions;
  };
  const FrameSource source{keyName(*moves.file), cache->seconds, frame};
  if (Status sampled = sampleFrames(source, options, place, out, progress); !sampled) return sampled.error();
  return out;
}

// A lone OBJ, PLY or OFF cannot be enough, but what is wrong in it comes first.
Error onePoseOnly(const MeshFile& mesh, std::span<const NamedBytes> files, const ImportOptions& options) {
  const std::string where = placeName(*mesh.file, 0, 1);
  const auto pose = PoseReader{files, options}.read(mesh, where);
  if (!pose) return pose.error();
  return {ErrorCode::TooFewKeys, where + " holds one pose only. Add a file for every other key."};
}

Result<Import> readCaches(const std::vector<MeshFile>& meshes, std::span<const NamedBytes> files,
                          const ImportOptions& options, const StageProgress& progress) {
  if (meshes.size() == 1)
    return Error{ErrorCode::TooFewKeys, placeName(*meshes[0].file, 0, 1) +
                                            " holds a motion without its mesh. Give the OBJ that it belongs to, too."};
  if (meshes.size() == 2 && isCache(meshes[0].kind) != isCache(meshes[1].kind)) {
    const int cache = isCache(meshes[0].kind) ? 0 : 1;
    return importCache(meshes[1 - cache], meshes[cache], files, options, progress);
  }
  return Error{ErrorCode::InvalidOption, "A PC2 or MDD file moves one mesh. Give it with one OBJ, and nothing else."};
}

Result<Import> readSeveral(const std::vector<MeshFile>& meshes, std::span<const NamedBytes> files,
                           const ImportOptions& options, const StageProgress& progress) {
  const auto series = numberedFiles(meshes);
  const bool many = series && meshes.size() > kMostOwnKeys && options.keyTimes.empty() && options.like.empty();
  if (series && (many || options.animationAsked())) return importSeries(meshes, *series, files, options, progress);
  if (!options.animationAsked()) {
    auto import = importPoses(meshes, files, options, progress);
    if (import && series && meshes.size() > static_cast<std::size_t>(options.sampleCount))
      import->animations = {infoOf({series->name, series->seconds, {}})};
    return import;
  }
  if (areAll(meshes, FileKind::Gltf)) return importAnimations(meshes, files, options, progress);
  return Error{ErrorCode::InvalidOption,
               "Keys are sampled from an animation, from numbered OBJ or PLY files or from a mesh with its PC2 or MDD, "
               "but " +
                   grouped(std::int64_t(meshes.size())) +
                   " files of other kinds or names were given, each of which is a key. Leave the animation and the "
                   "samples out."};
}

// Further poses of a mesh come in its vertices.
Result<Import> likeTheMesh(Import&& import, const ImportOptions& options) {
  if (options.likePose.empty()) return std::move(import);
  Import mesh;
  mesh.keyframes = {options.like, {{"mesh", 0, options.likePose}}, {}};
  const std::size_t n = options.likePose.size(), count = import.keyframes.vertexCount();
  const std::string where = import.keyframes.keys[0].name;
  if (Status added = KeyJoiner(mesh).add(import.keyframes.faces, import.keyframes.keys, where); !added)
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
        return Error{ErrorCode::InvalidOption, "A face of the mesh that the files are poses of names no vertex of it."};
  if (n > 0 && options.like.empty())
    return Error{ErrorCode::InvalidOption, "The mesh that the files are poses of has no faces."};
  return {};
}

Result<Import> readKeys(const std::vector<MeshFile>& meshes, std::span<const NamedBytes> files,
                        const ImportOptions& options, const StageProgress& progress) {
  if (meshes.empty())
    return Error{ErrorCode::TooFewKeys, files.empty()
                                            ? "No files were given. Give at least two poses of one mesh."
                                            : "None of the files holds a mesh. Give glTF, OBJ, PLY or OFF files."};
  if (std::any_of(meshes.begin(), meshes.end(), [](const MeshFile& mesh) { return isCache(mesh.kind); }))
    return readCaches(meshes, files, options, progress);
  if (meshes.size() > 1) return readSeveral(meshes, files, options, progress);
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
  } else if (error.key >= 0 && error.key < static_cast<int>(meshes.size()) &&
             error.message.starts_with(keyframes.keys[error.key].name)) {
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
  if (Status like = checkLike(options); !like) return like.error();
  auto read = readKeys(*meshes, files, options, progress);
  if (!read) return read;
  auto keys = likeTheMesh(std::move(*read), options);
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
