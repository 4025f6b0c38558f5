#include "core/ghost/ghost_motion.h"

#include <algorithm>

#include "core/base/stopwatch.h"

namespace shapespline {

namespace {

// In patches with fewer ghost faces, the rotation is poorly determined.
constexpr int facesPerPatch = 16;

// The shape's own number of patches, if the ghost has enough faces. Fewer and larger patches rotate more relative to
// each other.
int ghostPatchCount(int shapeFaces, int ghostFaces) {
  return std::max(defaultPatchCount(ghostFaces), std::min(defaultPatchCount(shapeFaces), ghostFaces / facesPerPatch));
}

}  // namespace

Result<GhostMotion> GhostMotion::create(const WeldedShape& full, const ShapeTopology& fullParts, const Options& options,
                                        const StageProgress& progress) {
  Stopwatch watch;
  Times times;
  GhostMesh mesh = simplify(full, fullParts, {options.faces, options.optimalPlacement}, Stage{progress, "simplifying"});
  auto shape = std::make_unique<const WeldedShape>(full.withMesh(mesh.faces, mesh.poses));
  times.simplify = watch.lap();

  const ShapeTopology topology = topologyOf(*shape);
  const int wanted = options.patches > 0 ? options.patches : ghostPatchCount(full.faceCount(), shape->faceCount());
  auto coordinates = encodePatches(*shape, topology, wanted);
  if (!coordinates) return coordinates.error();
  auto patches = PatchMotion::create(*shape, std::move(*coordinates));
  if (!patches) return patches.error();
  auto reconstructor = Reconstructor<double>::create(
      {*shape, topology, patches->poses().ofFace, options.stretch, Precision::Double},
      encode<double>(*shape, topology, patches->poses(), options.stretch, Transfer::Exact));
  if (!reconstructor) return reconstructor.error();
  GhostMotion ghost(options, std::move(mesh), std::move(shape), std::move(*patches), std::move(*reconstructor));
  times.encode = watch.lap();

  ghost.faceOf_ = correspondingFaces(full, fullParts, ghost.mesh_, Stage{progress, "matching"});
  const LocalFramePoses poses = ghost.patches_.poses();
  const auto patchRotation = [&](int f, int c) { return poses.rotation[c][poses.ofFace[f]]; };
  for (int c = 0; c < ghost.shape_->columns(); ++c) {
    ghost.rotation_.emplace_back();
    for (int f = 0; f < ghost.shape_->faceCount(); ++f)
      ghost.rotation_.back().push_back(topology.turns[f] ? rotationOf(*ghost.shape_, f, c) : patchRotation(f, c));
  }
  times.match = watch.lap();
  ghost.times_ = times;
  return ghost;
}

GhostMotion::GhostMotion(const Options& options, GhostMesh mesh, std::unique_ptr<const WeldedShape> shape,
                         PatchMotion patches, Reconstructor<double> reconstructor)
    : transfer_(options.transfer),
      mesh_(std::move(mesh)),
      shape_(std::move(shape)),
      patches_(std::move(patches)),
      reconstructor_(std::move(reconstructor)) {}

void GhostMotion::at(const CurvePoint& point, const PatchTurns& turns, Scratch& scratch, LocalFrames& frames) const {
  patches_.at(point, turns, scratch.patches, scratch.frames);
  reconstructor_.faceRotations(point, scratch.frames, frames.rotation);
  frames.gradient.clear();
  frames.part.clear();
  if (!scratch.frames.part.empty())
    for (const int patch : patches_.poses().ofFace) frames.part.push_back(patch < 0 ? 0 : scratch.frames.part[patch]);
  if (transfer_ == Transfer::Exact) return;
  reconstructor_.reconstruct(point, scratch.frames, scratch.shape, scratch.positions);
  for (int f = 0; f < shape_->faceCount(); ++f)
    frames.gradient.push_back(gradient(f, frames.rotation[f].toRotationMatrix(), scratch.positions));
}

// [e1 e2 n] [e1~ e2~ n~]^-1 of the ghost at `positions`. A collapsed face takes its normal from R_f.
Mat3 GhostMotion::gradient(int face, const Mat3& rotation, const Positions& positions) const {
  const FaceFrame frame = referenceFrame(*shape_, face);
  const Triangle& t = shape_->faces[face];
  const Vec3 e1 = positions[t[1]] - positions[t[0]], e2 = positions[t[2]] - positions[t[0]];
  const Vec3 cross = e1.cross(e2);
  const double area = cross.norm();
  const Mat2& e = frame.edges;  // upper triangular
  const Vec3 first = e1 / e(0, 0), second = (e2 - e(0, 1) * first) / e(1, 1);
  Mat3 deformed;
  deformed << first, second, area > 0 ? Vec3(cross / area) : Vec3(rotation * frame.basis.col(2));
  return deformed * frame.basis.transpose();
}

void GhostMotion::positions(const CurvePoint& point, const PatchTurns& turns, Scratch& scratch,
                            Positions& positions) const {
  patches_.at(point, turns, scratch.patches, scratch.frames);
  reconstructor_.reconstruct(point, scratch.frames, scratch.shape, positions);
}

}  // namespace shapespline
