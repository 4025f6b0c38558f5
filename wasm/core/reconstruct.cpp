#include "core/reconstruct.h"

#include <algorithm>

namespace shapespline {

namespace {

Vec3 blend(const std::vector<Vec3>& columns, const PoseWeights& weights) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t c = 0; c < columns.size(); ++c) sum += weights.column[c] * columns[c];
  return sum;
}

}  // namespace

PoseWeights poseWeights(const Weights& w, const WeldedShape& shape) {
  const Columns columns{shape.keys};
  PoseWeights result;
  result.column.assign(w.data(), w.data() + shape.keys);
  result.column.resize(shape.columns(), 0);
  if (shape.startTangent >= 0) result.column[shape.startTangent] = w[columns.startTangent()];
  if (shape.endTangent >= 0) result.column[shape.endTangent] = w[columns.endTangent()];
  result.closing = w[columns.closing()];
  result.column[0] += result.closing;
  return result;
}

template <class Real>
Status Reconstructor<Real>::build(const WeldedShape& shape, LriCoordinates<Real> coordinates,
                                  const EncodingOptions& options, const StageProgress& onProgress) {
  shape_ = &shape;
  lri_ = std::move(coordinates);
  if (Status status = patchSystem_.build(lri_.patches, lri_.pairWeight, options.rootPatch); !status) return status;
  alignment_ = Alignment({lri_.patches, lri_.patchArea, lri_.rotation, shape, patchSystem_.order(), patchSystem_.parent()});
  patchesOf_.resize(lri_.pieces.count);
  for (int k = 0; k < lri_.patches.count; ++k) patchesOf_[lri_.patches.pieceOf[k]].push_back(k);
  pieceOfVertex_.assign(shape.vertexCount(), -1);
  for (int f = 0; f < shape.faceCount(); ++f)
    if (lri_.hasArea[f])
      for (int v : shape.faces[f]) pieceOfVertex_[v] = lri_.pieces.ofFace[f];

  const CotangentLaplacian laplacian =
      cotangentLaplacian(shape.faces, lri_.hasArea, lri_.pieces, shape.poses[shape.reference]);
  const Status status = poisson_.build(
      laplacian, options.precision, [&](double fraction) { onProgress("ordering", fraction); },
      [&](double fraction) { onProgress("factorising", fraction); });
  if (!status) return status;
  kernel_.build(shape, lri_, options.stretch, poisson_.slot(), poisson_.dump());
  solution_.resize(4 * static_cast<std::size_t>(poisson_.size()));
  shift_.resize(lri_.pieces.count);
  return {};
}

template <class Real>
void Reconstructor<Real>::solvePatches(const PoseWeights& weights, std::vector<Quaternion>& rotation) {
  const std::size_t pairs = lri_.patches.pairs.size();
  pair_.assign(pairs, Vec3::Zero());
  for (int c = 0; c < shape_->columns(); ++c)
    for (std::size_t p = 0; p < pairs; ++p) pair_[p] += weights.column[c] * lri_.pair[c][p];
  for (const Winding& winding : lri_.pairWinding) pair_[winding.index] += weights.closing * winding.difference;
  patchSystem_.solve(pair_, rotation);
}

template <class Real>
Quaternion Reconstructor<Real>::faceRotation(int face, const PoseWeights& weights,
                                             const std::vector<Quaternion>& rotation) const {
  Vec3 r = Vec3::Zero();
  for (int c = 0; c < shape_->columns(); ++c) r += weights.column[c] * lri_.face.rotation(face, c);
  for (const Winding& winding : lri_.faceWinding)
    if (winding.index == face) r += weights.closing * winding.difference;
  return rotation[lri_.patches.ofFace[face]] * expQuaternion(r);
}

// Each component keeps its rotation in its anchor face's R_f.
template <class Real>
void Reconstructor<Real>::hangComponents(const PoseWeights& weights, std::vector<Quaternion>& rotation) const {
  for (int piece : lri_.tree.order) {
    const ComponentHold& hold = lri_.hold[piece];
    if (hold.link.parent < 0) continue;
    const Quaternion anchor = rotation[lri_.patches.ofFace[hold.link.anchorFace]] * expQuaternion(blend(hold.anchorRotation, weights));
    const Quaternion wanted = anchor * expQuaternion(blend(hold.rotation, weights));
    const Quaternion turn = wanted * rotation[lri_.patches.ofFace[hold.link.contactFace]].conjugate();
    for (int k : patchesOf_[piece]) rotation[k] = (turn * rotation[k]).normalized();
  }
}

template <class Real>
void Reconstructor<Real>::patchRotations(const Weights& weights, std::vector<Quaternion>& rotation) {
  const PoseWeights w = poseWeights(weights, *shape_);
  solvePatches(w, rotation);
  hangComponents(w, rotation);
}

template <class Real>
Vec3 Reconstructor<Real>::meanPosition(const Weights& weights) const {
  return blend(lri_.meanPosition, poseWeights(weights, *shape_));
}

template <class Real>
int Reconstructor<Real>::solveVertices(const PoseWeights& weights, const std::vector<Quaternion>& rotation) {
  frames_.resize(9 * rotation.size());
  for (std::size_t k = 0; k < rotation.size(); ++k) {
    const Mat3 g = rotation[k].toRotationMatrix();
    for (int i = 0; i < 9; ++i) frames_[9 * k + i] = static_cast<Real>(g(i / 3, i % 3));
  }
  columnWeights_.resize(weights.column.size());
  std::transform(weights.column.begin(), weights.column.end(), columnWeights_.begin(),
                 [](double w) { return static_cast<Real>(w); });
  std::fill(solution_.begin(), solution_.end(), Real(0));
  const int lost = kernel_.accumulate(lri_.face, frames_, columnWeights_, solution_.data());
  if (weights.closing != 0)
    for (const Winding& winding : lri_.faceWinding)
      kernel_.accumulateShift(lri_.face, frames_, columnWeights_, winding.index, weights.closing * winding.difference,
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
void Reconstructor<Real>::placeComponents(const PoseWeights& weights, const std::vector<Quaternion>& rotation) {
  std::fill(shift_.begin(), shift_.end(), Vec3::Zero());
  for (int piece : lri_.tree.order) {
    const ComponentHold& hold = lri_.hold[piece];
    if (hold.link.parent < 0) continue;
    const Quaternion anchor = rotation[lri_.patches.ofFace[hold.link.anchorFace]] * expQuaternion(blend(hold.anchorRotation, weights));
    const Vec3 wanted = placedCentroid(hold.link.anchorFace) + anchor * blend(hold.offset, weights);
    shift_[piece] = wanted - placedCentroid(hold.link.contactFace);
  }
}

template <class Real>
void Reconstructor<Real>::writeVertices(const PoseWeights& weights, const std::vector<Quaternion>& rotation,
                                        std::vector<Real>& xyz) const {
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
                          faceRotation(loose.anchorFace, weights, rotation) * blend(loose.offset, weights));
  const Vec3 move = blend(lri_.meanPosition, weights) - sum / n;
  for (int v = 0; v < n; ++v)
    for (int i = 0; i < 3; ++i) xyz[3 * static_cast<std::size_t>(v) + i] += static_cast<Real>(move[i]);
}

template <class Real>
int Reconstructor<Real>::reconstruct(const Weights& weights, std::vector<Real>& xyz) {
  const PoseWeights w = poseWeights(weights, *shape_);
  solvePatches(w, rotation_);
  hangComponents(w, rotation_);
  const Quaternion turn = alignment_.at(weights, rotation_);
  for (Quaternion& g : rotation_) g = (turn * g).normalized();
  const int lost = solveVertices(w, rotation_);
  placeComponents(w, rotation_);
  writeVertices(w, rotation_, xyz);
  return lost;
}

template class Reconstructor<float>;
template class Reconstructor<double>;

}  // namespace shapespline
