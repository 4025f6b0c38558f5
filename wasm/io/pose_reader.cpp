#include "io/pose_reader.h"

#include <utility>

#include "io/base/objects.h"
#include "io/base/stored_rounding.h"
#include "io/polygon/polygon_readers.h"

namespace shapespline {

namespace {

Result<PolygonMesh> readPolygons(const MeshFile& mesh, const SourceFiles& files, const ImportOptions& options,
                                 const std::string& where, const FractionReport& onProgress) {
  if (mesh.kind == FileKind::Obj) return readObj(*mesh.file, files, options.objects, where, onProgress);
  if (Status known = checkObjects(options.objects, {}, where); !known) return known.error();
  return mesh.kind == FileKind::Ply ? readPly(*mesh.file, where, onProgress) : readOff(*mesh.file, where, onProgress);
}

}  // namespace

void orient(Positions& positions, bool zUp, double scale) {
  for (Vec3& p : positions) p = scale * (zUp ? Vec3(p.x(), p.z(), -p.y()) : p);
}

Result<PoseFile> PoseReader::read(const MeshFile& mesh, const std::string& where, const FractionReport& onProgress) {
  if (mesh.kind == FileKind::Gltf) return readGltfPose(*mesh.file, files, options, where, onProgress);
  auto polygons = readPolygons(mesh, files, options, where, partOf(onProgress, 0, 0.8));
  if (!polygons) return polygons.error();
  placeUnused(*polygons);
  const double rounding = options.unit * storedRounding(polygons->positions);
  if (polygons->offset != Vec3::Zero())
    for (Vec3& p : polygons->positions) p += polygons->offset;
  orient(polygons->positions, options.zUp, options.unit);
  orient(polygons->normals, options.zUp, 1);
  if (!cuts) cuts = options.like.empty() ? cutPolygons(*polygons) : cutPolygonsLike(*polygons, options.like);
  reportFraction(onProgress, 0.85);
  PoseFile pose;
  pose.faces = trianglesOf(*polygons, *cuts);
  polygons->scene.seams.faces = drawnTrianglesOf(*polygons, *cuts);
  polygons->scene.groups = triangleGroups(*polygons);
  polygons->scene.objects = triangleObjects(*polygons);
  polygons->scene.polygons = trianglesPerPolygon(*polygons);
  reportFraction(onProgress, 0.95);
  pose.positions = std::move(polygons->positions);
  pose.normals = std::move(polygons->normals);
  pose.scene = std::move(polygons->scene);
  pose.warnings = std::move(polygons->warnings);
  pose.objects = std::move(polygons->objects);
  pose.writtenZUp = polygons->writtenZUp;
  Positions offset = {polygons->offset};
  orient(offset, options.zUp, options.unit);
  pose.offset = offset[0];
  pose.rounding = rounding;
  return pose;
}

}  // namespace shapespline
