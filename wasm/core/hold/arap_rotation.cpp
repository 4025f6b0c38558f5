#include "core/hold/arap_rotation.h"

#include <algorithm>
#include <cmath>

#include "core/base/compressed_rows.h"
#include "core/hold/smoothstep.h"
#include "core/rotation/rotation.h"

namespace shapespline {

namespace {

// A solve without rotations finds part of the required rotation. That part is multiplied by this factor, up to the
// limit.
constexpr double further = 3, maxTurn = 1.6;  // maxTurn in radians

// Shares of a patch's original extent in two directions. A crushed patch does not determine a rotation.
constexpr double crushed = 0.2, whole = 1;

double extent(const Mat3& m) { return (m.trace() * m.trace() - m.squaredNorm()) / 2; }

// planes: mean projection of a patch (affine_response.h). gradient: gradient of its displacements, relative to the
// patch. Returns the rotation that minimises shear, to first order. The length of `turn` is the sine of the angle for
// large rotations, and may exceed 1 under large stretches.
Mat3 furtherTurn(const Mat3& planes, const Mat3& gradient) {
  const Vec3 curl(gradient(2, 1) - gradient(1, 2), gradient(0, 2) - gradient(2, 0), gradient(1, 0) - gradient(0, 1));
  const Mat3 stiff = planes.trace() * Mat3::Identity() - planes;
  const Vec3 across = stiff.col(1).cross(stiff.col(2));
  const Vec3 turn =
      (curl.x() * across + curl.y() * stiff.col(2).cross(stiff.col(0)) + curl.z() * stiff.col(0).cross(stiff.col(1))) /
      across.dot(stiff.col(0));
  const double most = maxTurn / further, was = extent(planes);
  const double square = turn.squaredNorm(),
               sine = 1 / std::sqrt(std::sqrt(std::sqrt(1 + square * square * square * square)));
  const Mat3 left = expRotation(-sine * turn) * (planes + gradient);
  const double meant = smoothstep2(extent(left), crushed * was, whole * was);
  return expRotation(meant * further / std::sqrt(1 + turn.squaredNorm() / (most * most)) * turn);
}

}  // namespace

ArapRotation::ArapRotation(const HoldInput& input, const AffineResponse& modes) {
  const std::vector<double> area = faceAreas(input.mesh);
  const std::size_t frames = input.rotation.front().size();
  patchOfFrame_.assign(frames, -1);
  frameShare_.assign(frames, 0.0);
  std::vector<double> patchArea(modes.planes().size(), 0.0);
  for (std::size_t f = 0; f < area.size(); ++f)
    if (const int frame = input.mesh.localFrameOf[f], patch = input.patchOfFace[f]; frame >= 0 && patch >= 0) {
      patchOfFrame_[frame] = patch;
      frameShare_[frame] += area[f];
      patchArea[patch] += area[f];
    }
  for (std::size_t k = 0; k < frames; ++k)
    if (patchOfFrame_[k] >= 0) frameShare_[k] /= patchArea[patchOfFrame_[k]];
  const WeldedShape& shape = input.mesh.shape;
  const Positions& p = shape.poses[shape.reference];
  const CompressedRows<std::size_t> facesOf = compressedRows<std::size_t>(shape.vertexCount(), [&](auto add) {
    for (std::size_t f = 0; f < shape.faces.size(); ++f)
      for (int c = 0; c < 3 && input.mesh.localFrameOf[f] >= 0; ++c) add(shape.faces[f][c], f);
  });
  for (int v = 0; v < facesOf.count(); ++v) {
    const std::size_t first = pulls_.size();
    for (const std::size_t f : facesOf.of(v)) {
      const int patch = input.patchOfFace[f];
      if (patch < 0 || modes.hardlyTurns(patch)) continue;
      std::size_t at = first;
      while (at < pulls_.size() && pulls_[at].patch != patch) ++at;
      if (at == pulls_.size()) pulls_.push_back({v, patch, {}});
      for (int c = 0; c < 3; ++c) {
        const int i = shape.faces[f][(c + 1) % 3], j = shape.faces[f][(c + 2) % 3];
        if (i != v && j != v) continue;
        const Vec3 pull = sideStiffness(input.mesh, f, c) * (p[v] - p[i == v ? j : i]);
        for (int k = 0; k < 3; ++k) pulls_[at].at[k] += static_cast<float>(pull[k]);
      }
    }
  }
}

// Each patch keeps its shape from the reference pose, rotated by the mean of its frames.
void ArapRotation::find(const AffineResponse& modes, const std::vector<Vec3>& mode,
                        const std::vector<Quaternion>& frames, std::vector<Mat3>& turn) const {
  turn.assign(modes.planes().size(), Mat3::Zero());
  for (std::size_t k = 0; k < frames.size(); ++k)
    if (patchOfFrame_[k] >= 0) turn[patchOfFrame_[k]] += frameShare_[k] * frames[k].toRotationMatrix();
  for (std::size_t p = 0; p < turn.size(); ++p)
    if (!modes.hardlyTurns(p))
      turn[p] *= furtherTurn(modes.planes()[p], turn[p].transpose() * modes.gradient(p, mode)) - Mat3::Identity();
}

}  // namespace shapespline
