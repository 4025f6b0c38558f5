#include "io/import_motion.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/base/format.h"
#include "core/mesh/mesh.h"
#include "io/base/byte_text.h"
#include "io/base/stored_rounding.h"
#include "io/cache/point_cache.h"
#include "io/frame_source.h"
#include "io/gltf/gltf_reader.h"
#include "io/import_poses.h"
#include "io/join_keys.h"

namespace shapespline {

namespace {

bool sameKeys(const Keyframes& a, const Keyframes& b) {
  return a.faces == b.faces && std::equal(a.keys.begin(), a.keys.end(), b.keys.begin(), b.keys.end(),
                                          [](const Key& x, const Key& y) { return x.positions == y.positions; });
}

// With one key per file, file names replace action names that are equal.
void nameApart(std::vector<Key>& keys, const std::vector<MeshFile>& meshes) {
  std::set<std::string> names;
  for (const Key& key : keys) names.insert(key.name);
  for (std::size_t k = 0; k < keys.size() && names.size() < keys.size(); ++k) keys[k].name = keyName(*meshes[k].file);
}

using Axes = Mat3;

Positions movedBy(const Vec3& way, Positions positions) {
  if (way == Vec3::Zero()) return positions;
  for (Vec3& p : positions) p += way;
  return positions;
}

// Finds the cache's axes: some programs write the mesh's axes, others exchange Y and Z.
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

}  // namespace

Result<Import> importAnimations(const std::vector<MeshFile>& meshes, const SourceFiles& files, ImportOptions options,
                                const StageProgress& progress) {
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
    out->noteRounding(import->rounding, placeName(*meshes[j].file, 0, 1));
    // Files of one pose each may repeat the pose.
    if (import->keyframes.keyCount() > 1 && sameKeys(first, import->keyframes)) {
      ++repeated;
      continue;
    }
    if (Status added = KeyJoiner(*out).add(import->keyframes.faces, std::move(import->keyframes.keys), where,
                                           import->scene.objects);
        !added)
      return atKey(added.error(), static_cast<int>(j));
  }
  if (repeated + 1 < static_cast<int>(meshes.size())) {
    if (out->keyframes.keyCount() == static_cast<int>(meshes.size())) nameApart(out->keyframes.keys, meshes);
    setTimesInSeconds(out->keyframes);
  }
  if (repeated > 0)
    out->warnings.push_back({"repeated-animation",
                             "Several files have the same animation as " + std::string(baseName(meshes[0].file->name)) +
                                 ". It is used once.",
                             repeated});
  return std::move(*out);
}

Result<Import> importSeries(const NumberedFiles& series, const SourceFiles& files, const ImportOptions& options,
                            const StageProgress& progress) {
  const std::vector<MeshFile>& meshes = series.meshes;
  Import out;
  PoseReader reader{files, options};
  const std::string first = placeName(*meshes[0].file, 0, meshes.size());
  auto mesh = reader.read(meshes[0], first);
  if (!mesh) return atKey(mesh.error(), 0);
  const bool writtenZUp = mesh->writtenZUp;
  if (Status added = addPose(std::move(*mesh), "mesh", out, first); !added) return added.error();
  hintAtUpAxis(meshes[0].kind, writtenZUp, options, std::string(baseName(meshes[0].file->name)), out);
  const auto n = out.keyframes.vertexCount();
  const auto frame = [&](std::size_t index) -> Result<Positions> {
    const std::string where = placeName(*meshes[index].file, static_cast<int>(index), meshes.size());
    auto pose = reader.read(meshes[index], where);
    if (!pose) return pose.error();
    out.noteRounding(pose->rounding, placeName(*meshes[index].file, 0, 1));
    const std::size_t count = pose->positions.size();
    Import one;
    one.keyframes = {out.keyframes.faces, {out.keyframes.keys[0]}, {}};
    one.scene.objects = out.scene.objects;
    if (Status added =
            KeyJoiner(one).add(pose->faces, {{"", 0, std::move(pose->positions)}}, where, pose->scene.objects);
        !added)
      return added.error();
    if (one.keyframes.vertexCount() != n)
      return vertexCountMismatch(where, static_cast<int>(index), count, static_cast<std::size_t>(n));
    return std::move(one.keyframes.keys[1].positions);
  };
  const FrameSource source{series.name, statedTimes(options, series.seconds), frame};
  const std::string where = std::string(baseName(meshes[0].file->name));
  if (Status sampled = sampleFrames(source, options, where, out, progress); !sampled) return sampled.error();
  const bool stated = source.seconds != series.seconds;
  if (!options.animationAsked())
    out.warnings.push_back(
        {"numbered-files",
         grouped(static_cast<std::int64_t>(meshes.size())) + " numbered files are used as frames of an animation" +
             (stated ? "" : ", 24 per second") + ". The keys are " + grouped(out.keyframes.keyCount()) +
             " evenly spaced frames. Choose other keys on the timeline (on the "
             "command line, with --sample).",
         static_cast<int>(meshes.size())});
  return out;
}

Result<Import> importCache(const MeshFile& mesh, const MeshFile& moves, const SourceFiles& files,
                           const ImportOptions& options, const StageProgress& progress) {
  const std::string where = placeName(*mesh.file, 0, 1), place = placeName(*moves.file, 0, 1);
  PoseReader reader{files, options};
  auto pose = reader.read(mesh, where);
  if (!pose) return pose.error();
  const auto cache = moves.kind == FileKind::Pc2 ? readPc2(*moves.file, place) : readMdd(*moves.file, place);
  if (!cache) return cache.error();
  if (cache->points != pose->positions.size())
    return Error{ErrorCode::VertexCountMismatch,
                 place + " has " + grouped(static_cast<std::int64_t>(cache->points)) + " points per frame, but " +
                     where + " has " + grouped(static_cast<std::int64_t>(pose->positions.size())) +
                     " vertices. Export both from the same object, with the same modifiers."};
  Import out;
  const bool writtenZUp = pose->writtenZUp;
  const Vec3 offset = pose->offset;
  if (Status added = addPose(std::move(*pose), "mesh", out, where); !added) return added.error();
  hintAtUpAxis(mesh.kind, writtenZUp, options, where, out);
  out.rounding = 0;  // only the faces of the mesh file are used
  const Axes axes = axesOf(*cache, movedBy(-offset, out.keyframes.keys[0].positions));
  const bool own = axes == Axes::Identity();
  const auto frame = [&](std::size_t index) -> Result<Positions> {
    Positions positions = cache->frame(index);
    out.noteRounding(options.unit * storedRounding(positions), place);
    // A cache in the axes of the mesh file is oriented like the mesh. Otherwise `axes` converts it.
    if (own) orient(positions, options.zUp, options.unit);
    else
      for (Vec3& p : positions) p = axes * p;
    return movedBy(offset, std::move(positions));
  };
  const FrameSource source{keyName(*moves.file), statedTimes(options, cache->seconds), frame};
  if (Status sampled = sampleFrames(source, options, place, out, progress); !sampled) return sampled.error();
  return out;
}

}  // namespace shapespline
