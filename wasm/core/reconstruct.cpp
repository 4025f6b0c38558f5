#include "core/reconstruct.h"

#include <algorithm>

namespace shapespline {

template <class Real>
Status Reconstructor<Real>::build(const Input& in, LriCoordinates<Real> coordinates, const StageProgress& onProgress) {
  const WeldedShape& shape = in.shape;
  shape_ = &shape;
  source_ = &in.frames;
  lri_ = std::move(coordinates);
  frameOf_.assign(in.frameOf.begin(), in.frameOf.end());
  pieceOfVertex_.assign(shape.vertexCount(), -1);
  for (int f = 0; f < shape.faceCount(); ++f)
    if (in.parts.hasArea[f])
      for (int v : shape.faces[f]) pieceOfVertex_[v] = in.parts.pieces.ofFace[f];

  const CotangentLaplacian laplacian =
      cotangentLaplacian(shape.faces, in.parts.hasArea, in.parts.pieces, shape.poses[shape.reference]);
  const Status status = poisson_.build(
      laplacian, in.precision, [&](double fraction) { onProgress("ordering", fraction); },
      [&](double fraction) { onProgress("factorising", fraction); });
  if (!status) return status;
  kernel_.build(shape, frameOf_, in.stretch, poisson_.slot(), poisson_.dump());
  solution_.resize(4 * static_cast<std::size_t>(poisson_.size()));
  shift_.resize(in.parts.pieces.count);
  return {};
}

template <class Real>
Quaternion Reconstructor<Real>::faceRotation(int face, int frame, const PoseWeights& weights) const {
  Vec3 r = Vec3::Zero();
  const int columns = lri_.face.columns();
  for (int c = 0; c < columns && columns > 1; ++c) r += weights.column[c] * lri_.face.rotation(face, c);
  for (const Winding& winding : lri_.faceWinding)
    if (winding.index == face) r += weights.closing * winding.difference;
  return frames_.rotation[frame] * expQuaternion(r);
}

template <class Real>
void Reconstructor<Real>::faceRotations(const Weights& weights, std::vector<Quaternion>& rotation) {
  const PoseWeights w = poseWeights(weights, *shape_);
  source_->at(weights, frames_);
  rotation.resize(shape_->faceCount());
  for (int f = 0; f < shape_->faceCount(); ++f)
    rotation[f] = frameOf_[f] >= 0 ? faceRotation(f, frameOf_[f], w) : Quaternion::Identity();
}

template <class Real>
int Reconstructor<Real>::solveVertices(const PoseWeights& weights) {
  const std::size_t count = frames_.rotation.size();
  matrices_.resize(9 * count);
  for (std::size_t k = 0; k < count; ++k) {
    const Mat3 g = frames_.gradient.empty() ? frames_.rotation[k].toRotationMatrix() : frames_.gradient[k];
    for (int i = 0; i < 9; ++i) matrices_[9 * k + i] = static_cast<Real>(g(i / 3, i % 3));
  }
  columnWeights_.assign(1, Real(1));  // of faces that rest in their frames
  if (lri_.face.columns() > 1) columnWeights_.assign(weights.column.begin(), weights.column.end());
  std::fill(solution_.begin(), solution_.end(), Real(0));
  const int lost = kernel_.accumulate(lri_.face, matrices_, columnWeights_, solution_.data());
  if (weights.closing != 0)
    for (const Winding& winding : lri_.faceWinding)
      kernel_.accumulateShift(lri_.face, matrices_, columnWeights_, winding.index, weights.closing * winding.difference,
                              solution_.data());
  poisson_.solve(solution_.data());
  return lost;
}

template <class Real>
Vec3 Reconstructor<Real>::placedVertex(int v) const {
  const Real* x = solution_.data() + 4 * static_cast<std::size_t>(poisson_.slot()[v]);
  return Vec3(x[0], x[1], x[2]) + shift_[pieceOfVertex_[v]];
}

template <class Real>
Vec3 Reconstructor<Real>::placedCentroid(int face) const {
  const Triangle& t = shape_->faces[face];
  return (placedVertex(t[0]) + placedVertex(t[1]) + placedVertex(t[2])) / 3;
}

// Each component keeps its offset in its anchor face's R_f.
template <class Real>
void Reconstructor<Real>::placeComponents(const PoseWeights& weights) {
  std::fill(shift_.begin(), shift_.end(), Vec3::Zero());
  for (const ComponentPlace& place : lri_.places) {
    const Quaternion anchor = frames_.rotation[place.anchorFrame] * expQuaternion(blend(place.anchorRotation, weights));
    const Vec3 wanted = placedCentroid(place.anchorFace) + anchor * blend(place.offset, weights);
    shift_[place.piece] = wanted - placedCentroid(place.contactFace);
  }
}

template <class Real>
void Reconstructor<Real>::writeVertices(const PoseWeights& weights, std::vector<Real>& xyz) const {
  const int n = shape_->vertexCount();
  xyz.resize(3 * static_cast<std::size_t>(n));
  Vec3 sum = Vec3::Zero();
  const auto set = [&](int v, const Vec3& p) {
    for (int i = 0; i < 3; ++i) xyz[3 * static_cast<std::size_t>(v) + i] = static_cast<Real>(p[i]);
    sum += p;
  };
  for (int v = 0; v < n; ++v)
    if (pieceOfVertex_[v] >= 0) set(v, placedVertex(v));
  for (const LooseVertex& loose : lri_.loose)
    set(loose.vertex, placedCentroid(loose.anchorFace) +
                          faceRotation(loose.anchorFace, loose.anchorFrame, weights) * blend(loose.offset, weights));
  const Vec3 move = blend(lri_.meanPosition, weights) - sum / n;
  for (int v = 0; v < n; ++v)
    for (int i = 0; i < 3; ++i) xyz[3 * static_cast<std::size_t>(v) + i] += static_cast<Real>(move[i]);
}

template <class Real>
int Reconstructor<Real>::reconstruct(const Weights& weights, std::vector<Real>& xyz) {
  const PoseWeights w = poseWeights(weights, *shape_);
  source_->at(weights, frames_);
  const int lost = solveVertices(w);
  placeComponents(w);
  writeVertices(w, xyz);
  return lost;
}

template class Reconstructor<float>;
template class Reconstructor<double>;

}  // namespace shapespline
