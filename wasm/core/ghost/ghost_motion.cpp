#include "core/ghost/ghost_motion.h"

#include <algorithm>

namespace shapespline {

namespace {

// A patch of fewer faces of the ghost says little about how it turns.
constexpr int facesPerPatch = 16;

// As many patches as the shape would have, where the ghost has the faces for them: coarser ones turn further against each other.
int ghostPatchCount(int shapeFaces, int ghostFaces) {
  return std::max(defaultPatchCount(ghostFaces), std::min(defaultPatchCount(shapeFaces), ghostFaces / facesPerPatch));
}

}  // namespace

Status GhostMotion::build(const WeldedShape& full, const ShapeParts& parts, const EncodingOptions& options,
                          SequenceStats& stats, const StageProgress& progress) {
  Stopwatch watch;
  transfer_ = options.transfer;
  mesh_ = simplify(full, parts, {options.ghostFaces, options.optimalPlacement}, Stage{progress, "simplifying"});
  shape_ = full.withMesh(mesh_.faces, mesh_.poses);
  stats.ghostFaces = shape_.faceCount();
  stats.ghostVertices = shape_.vertexCount();
  stats.joinedComponents = mesh_.joinedPieces;
  stats.simplifyMs = watch.lap();
  const int patches = options.patches > 0 ? options.patches : ghostPatchCount(full.faceCount(), shape_.faceCount());
  if (Status status = buildMotion(options, patches, stats); !status) return status;
  stats.encodeMs += watch.lap();

  faceOf_ = correspondingFaces(full, parts, mesh_, Stage{progress, "matching"});
  for (int c = 0; c < shape_.columns(); ++c) {
    rotation_.emplace_back();
    for (int f = 0; f < shape_.faceCount(); ++f) rotation_.back().push_back(rotationOf(shape_, f, c));
  }
  stats.transferMs += watch.lap();
  return {};
}

Status GhostMotion::buildMotion(const EncodingOptions& options, int wantedPatches, SequenceStats& stats) {
  const ShapeParts parts = partsOf(shape_);
  auto patches = encodePatches(shape_, parts, wantedPatches);
  if (!patches) return patches.error();
  Status status = patches_.build(shape_, std::move(*patches));
  if (!status) return status;
  auto coordinates = encode<double>(shape_, parts, patches_.poses(), options.stretch, Transfer::Exact);
  ++stats.encodings;
  SequenceStats ownStats;  // the whole counts as encoding
  status = reconstructor_.build({shape_, parts, patches_.poses().ofFace, patches_, options.stretch, Precision::Double},
                                std::move(coordinates), ownStats, [](const char*, double) {});
  stats.factorisations += 2;  // one a system
  return status;
}

void GhostMotion::at(const CurvePoint& point, Frames& frames) {
  reconstructor_.faceRotations(point, frames.rotation);
  frames.gradient.clear();
  if (transfer_ == Transfer::Exact) return;
  reconstructor_.reconstruct(point, positions_);
  for (int f = 0; f < shape_.faceCount(); ++f) frames.gradient.push_back(gradient(f, frames.rotation[f].toRotationMatrix()));
}

// [e1 e2 n] [e1~ e2~ n~]^-1 of the ghost as it lies in positions_. A face that has collapsed takes its normal from R_f.
Mat3 GhostMotion::gradient(int face, const Mat3& rotation) const {
  const FaceFrame frame = referenceFrame(shape_, face);
  const Triangle& t = shape_.faces[face];
  const Vec3 e1 = positions_[t[1]] - positions_[t[0]], e2 = positions_[t[2]] - positions_[t[0]];
  const Vec3 cross = e1.cross(e2);
  const double area = cross.norm();
  const Mat2& e = frame.edges;  // upper triangular
  const Vec3 first = e1 / e(0, 0), second = (e2 - e(0, 1) * first) / e(1, 1);
  Mat3 deformed;
  deformed << first, second, area > 0 ? Vec3(cross / area) : Vec3(rotation * frame.basis.col(2));
  return deformed * frame.basis.transpose();
}

int GhostMotion::positions(const CurvePoint& point, Positions& positions) {
  return reconstructor_.reconstruct(point, positions);
}

}  // namespace shapespline
