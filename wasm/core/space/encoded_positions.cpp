#include "core/space/encoded_positions.h"

#include "core/rotation/rotation.h"

namespace shapespline {

ShapeCoordinates encodeShape(const PoseCoordinates& poses, const WeldedShape& shape, Stretch stretch,
                             const Eigen::VectorXd& weights, const Positions& positions) {
  const Patches& patches = poses.patches.patches;
  const std::vector<double>& area = poses.patches.faceArea;
  ShapeCoordinates out{{}, {}, Vec3::Zero()};
  out.face.resize(shape.faceCount());
  std::vector<FaceDeformation> deformed(shape.faceCount());
  std::vector<RotationMean> mean(patches.count);
  for (int f = 0; f < shape.faceCount(); ++f) {
    if (area[f] == 0) continue;
    const Triangle& t = shape.faces[f];
    const auto deformedFrom = [&](int column) {
      return deformation(frameIn(shape, f, column), positions[t[0]], positions[t[1]], positions[t[2]]);
    };
    deformed[f] = deformedFrom(shape.reference);
    mean[patches.ofFace[f]].add(Quaternion(deformedFrom(poses.patches.origin).rotation), area[f]);
  }
  std::vector<Quaternion> rotation;
  for (std::size_t k = 0; k < mean.size(); ++k)
    rotation.push_back(mean[k].mean() * poses.patches.rotation[poses.patches.origin][k]);
  for (int f = 0; f < shape.faceCount(); ++f) {
    if (area[f] == 0) continue;
    Vec3 near = Vec3::Zero();
    for (int c = 0; c < shape.columns(); ++c)
      for (int k = 0; k < 3; ++k) near[k] += weights[c] * poses.number(f, c, k);
    const Quaternion turn = rotation[patches.ofFace[f]].conjugate() * Quaternion(deformed[f].rotation);
    const Vec3 r = nearestRepresentative(logRotation(turn), near);
    const Mat2 s = stretch == Stretch::Log ? logSymmetric(deformed[f].stretch) : deformed[f].stretch;
    out.face[f] = {r.x(), r.y(), r.z(), s(0, 0), (s(0, 1) + s(1, 0)) / 2, s(1, 1)};
  }
  for (const PatchPair& p : patches.pairs) {
    Vec3 near = Vec3::Zero();
    for (int c = 0; c < shape.columns(); ++c) near += weights[c] * poses.patches.pair[c][out.pair.size()];
    const Quaternion turn = rotation[p.first].conjugate() * rotation[p.second];
    out.pair.push_back(nearestRepresentative(logRotation(turn), near));
  }
  for (int c = 0; c < shape.columns(); ++c) out.meanPosition += weights[c] * poses.meanPosition[c];
  return out;
}

}  // namespace shapespline
