#include "core/reconstruct/reconstruct.h"

#include <algorithm>

#include "core/base/lanes.h"

namespace shapespline {

namespace {

// The sum of `count` places, by runs that are short enough for the precision.
template <class Real>
Vec3 sumOf(const Real* places, std::size_t count) {
  constexpr std::size_t run = 64;
  Vec3 sum = Vec3::Zero();
  for (std::size_t begin = 0; begin < count; begin += run) {
    auto part = Lanes<Real>::zero();
    for (std::size_t i = begin; i < std::min(count, begin + run); ++i) part = part + Lanes<Real>::load(places + 4 * i);
    alignas(32) Real number[4];
    part.store(number);
    sum += Vec3(number[0], number[1], number[2]);
  }
  return sum;
}

}  // namespace

template <class Real>
Status Reconstructor<Real>::build(const Input& in, LriCoordinates<Real> coordinates, SequenceStats& stats,
                                  const StageProgress& onProgress) {
  Stopwatch watch;
  const WeldedShape& shape = in.shape;
  shape_ = &shape;
  source_ = &in.frames;
  lri_ = std::move(coordinates);
  precision_ = in.precision;
  stretch_ = in.stretch;
  const Positions* reference = &shape.poses[shape.reference];
  extent_ = boundingDiagonal({&reference, 1});
  frameOf_.assign(in.frameOf.begin(), in.frameOf.end());
  pieceOfVertex_.assign(shape.vertexCount(), -1);
  pieceOfFace_ = in.parts.pieces.ofFace;
  for (int f = 0; f < shape.faceCount(); ++f)
    if (in.parts.hasArea[f])
      for (int v : shape.faces[f]) pieceOfVertex_[v] = in.parts.pieces.ofFace[f];

  const Stage ordering{onProgress, "ordering"}, factorising{onProgress, "factorising"};
  const CotangentLaplacian laplacian = cotangentLaplacian(shape.faces, in.parts.hasArea, in.parts.pieces,
                                                          shape.poses[shape.reference], partOf(ordering, 0, 0.1));
  if (Status status = poisson_.order(laplacian, in.precision, partOf(ordering, 0.1, 1)); !status) return status;
  stats.orderMs += watch.lap();
  onProgress("ordering", 1);
  if (Status status = poisson_.factorise(laplacian, partOf(factorising, 0, 0.8)); !status) return status;
  stats.factorMs += watch.lap();
  faceAt_ = kernel_.build(shape, frameOf_, in.stretch, poisson_.slot(), poisson_.dump(), partOf(factorising, 0.8, 0.93));
  lri_.face.reorder(faceAt_, partOf(factorising, 0.93, 0.95));
  shift_.resize(in.parts.pieces.count);
  shiftLanes_.resize(4 * shift_.size());
  verticesOfPiece_.assign(shift_.size(), 0);
  for (int piece : pieceOfVertex_)
    if (piece >= 0) ++verticesOfPiece_[piece];
  placeOf_ = poisson_.slot();
  int next = poisson_.unknowns();
  for (int& place : placeOf_)
    if (place == poisson_.dump()) place = next++;
  pieceAt_.assign(shift_.size() > 1 ? placeOf_.size() : 0, 0);
  for (std::size_t v = 0; v < pieceAt_.size(); ++v) pieceAt_[placeOf_[v]] = std::max(0, pieceOfVertex_[v]);
  stats.arrangeMs += watch.lap();
  return {};
}

template <class Real>
Quaternion Reconstructor<Real>::faceRotation(int face, int frame, const PoseWeights& weights) const {
  Vec3 r = Vec3::Zero();
  for (int c = 0; c < lri_.face.columns(); ++c)
    if (weights.column[c] != 0) r += weights.column[c] * lri_.face.rotation(face, c);
  return frames_.rotation[frame] * expQuaternion(r);
}

template <class Real>
void Reconstructor<Real>::faceRotations(const CurvePoint& point, std::vector<Quaternion>& rotation) {
  const PoseWeights w = poseWeights(point, *shape_);
  source_->at(point, frames_);
  rotation.resize(shape_->faceCount());
  for (int f = 0; f < shape_->faceCount(); ++f)
    rotation[f] = frameOf_[f] >= 0 ? faceRotation(f, frameOf_[f], w) : Quaternion::Identity();
}

template <class Real>
int Reconstructor<Real>::assemble(const PoseWeights& weights, Real* x, Crew* crew) {
  const std::size_t count = frames_.rotation.size();
  matrices_.resize(numbersPerFrame * count);
  for (std::size_t k = 0; k < count; ++k) {
    const Mat3 g = frames_.gradient.empty() ? frames_.rotation[k].toRotationMatrix() : frames_.gradient[k];
    for (int i = 0; i < numbersPerFrame; ++i)
      matrices_[numbersPerFrame * k + i] = i % 4 < 3 ? static_cast<Real>(g(i % 4, i / 4)) : Real(0);
  }
  const ColumnWeights<Real> columnWeights = lri_.face.weights(weights);
  std::fill_n(x, 4 * static_cast<std::size_t>(poisson_.size()), Real(0));
  const IndefiniteFaces indefinite = kernel_.accumulate(lri_.face, matrices_, columnWeights, x, crew);
  indefiniteFace_ = indefinite.slot >= 0 ? faceAt_[indefinite.slot] : -1;
  return indefinite.count;
}

// Refinement starts from the key with the largest weight: a frame depends on its weights alone, never on another frame.
template <class Real>
void Reconstructor<Real>::startFromKey(const PoseWeights& weights, Real* x) {
  const auto first = weights.column.begin();
  const Positions& key = shape_->poses[std::max_element(first, first + shape_->keys) - first];
  rightHandSide_.assign(x, x + 4 * static_cast<std::size_t>(poisson_.size()));
  std::vector<Vec3> tied(shift_.size(), Vec3::Zero());
  for (std::size_t v = 0; v < key.size(); ++v)
    if (pieceOfVertex_[v] >= 0 && poisson_.slot()[v] == poisson_.dump()) tied[pieceOfVertex_[v]] = key[v];
  for (std::size_t v = 0; v < key.size(); ++v) {
    if (poisson_.slot()[v] == poisson_.dump()) continue;
    const Vec3 p = key[v] - tied[pieceOfVertex_[v]];
    for (int i = 0; i < 3; ++i) x[4 * static_cast<std::size_t>(poisson_.slot()[v]) + i] = static_cast<Real>(p[i]);
  }
  for (int i = 0; i < 4; ++i) x[4 * static_cast<std::size_t>(poisson_.dump()) + i] = 0;
}

template <class Real>
void Reconstructor<Real>::solve(const PoseWeights& weights, Real* x, Crew* crew) {
  if constexpr (std::is_same_v<Real, double>) {
    if (precision_ == Precision::Exact) {
      startFromKey(weights, x);
      poisson_.refine(rightHandSide_.data(), x, extent_, crew);
      return;
    }
  }
  poisson_.solve(x, crew);
}

template <class Real>
Vec3 Reconstructor<Real>::placedVertex(int v, const Real* x) const {
  const Real* p = x + 4 * static_cast<std::size_t>(poisson_.slot()[v]);
  return Vec3(p[0], p[1], p[2]) + shift_[pieceOfVertex_[v]];
}

template <class Real>
Vec3 Reconstructor<Real>::placedCentroid(int face, const Real* x) const {
  const Triangle& t = shape_->faces[face];
  return (placedVertex(t[0], x) + placedVertex(t[1], x) + placedVertex(t[2], x)) / 3;
}

// Each component keeps its offset in its anchor face's R_f.
template <class Real>
void Reconstructor<Real>::placeComponents(const PoseWeights& weights, const Real* x) {
  std::fill(shift_.begin(), shift_.end(), Vec3::Zero());
  for (const ComponentPlace& place : lri_.places) {
    const Quaternion anchor = faceRotation(place.anchorFace, place.anchorFrame, weights);
    const Quaternion contact = faceRotation(place.contactFace, place.contactFrame, weights);
    const Vec3 wanted = placedCentroid(place.anchorFace, x) + anchor * blend(place.offset, weights);
    shift_[place.piece] = wanted - (placedCentroid(place.contactFace, x) + contact * place.pivot);
  }
}

template <class Real>
void Reconstructor<Real>::placeLoose(const PoseWeights& weights, const Real* x) {
  loose_.clear();
  for (const LooseVertex& loose : lri_.loose) {
    const Quaternion anchor = faceRotation(loose.anchorFace, loose.anchorFrame, weights);
    loose_.push_back(placedCentroid(loose.anchorFace, x) + anchor * blend(loose.offset, weights));
  }
}

// What everything has to be moved by, so that the mean of all vertices lies where the coordinates have it.
template <class Real>
Vec3 Reconstructor<Real>::meanMove(const PoseWeights& weights, const Real* x) const {
  Vec3 sum = sumOf(x, static_cast<std::size_t>(poisson_.unknowns()));
  for (std::size_t p = 0; p < shift_.size(); ++p) sum += verticesOfPiece_[p] * shift_[p];
  for (const Vec3& p : loose_) sum += p;
  return blend(lri_.meanPosition, weights) - sum / shape_->vertexCount();
}

// The solver's slots come first among the places; each piece is moved by its shift, and the vertices without a slot follow.
template <class Real>
void Reconstructor<Real>::slotsToPlaces(Real* x) {
  using L = Lanes<Real>;
  const std::size_t unknowns = static_cast<std::size_t>(poisson_.unknowns());
  std::fill(x + 4 * unknowns, x + 4 * placeOf_.size(), Real(0));  // tied to zero
  for (std::size_t p = 0; p < shift_.size(); ++p)
    for (int k = 0; k < 3; ++k) shiftLanes_[4 * p + k] = static_cast<Real>(shift_[p][k]);
  for (std::size_t i = 0; i < pieceAt_.size(); ++i)
    (L::load(x + 4 * i) + L::load(&shiftLanes_[4 * static_cast<std::size_t>(pieceAt_[i])])).store(x + 4 * i);
  for (std::size_t i = 0; i < loose_.size(); ++i)
    for (int k = 0; k < 3; ++k) x[4 * static_cast<std::size_t>(placeOf_[lri_.loose[i].vertex]) + k] = static_cast<Real>(loose_[i][k]);
}

template <class Real>
int Reconstructor<Real>::reconstruct(const CurvePoint& point, PlacedShape<Real>& shape, SequenceStats* stats, Crew* crew) {
  Stopwatch watch;
  const PoseWeights w = poseWeights(point, *shape_);
  source_->at(point, frames_);
  const double framesMs = watch.lap();
  shape.places.resize(4 * std::max(static_cast<std::size_t>(poisson_.size()), placeOf_.size()));
  Real* const x = shape.places.data();
  const int lost = assemble(w, x, crew);
  const double facesMs = watch.lap();
  solve(w, x, crew);
  const double solveMs = watch.lap();
  placeComponents(w, x);
  placeLoose(w, x);
  shape.move = meanMove(w, x);
  slotsToPlaces(x);
  if (stats) stats->indefiniteFace = indefiniteFace_, stats->framesMs = framesMs, stats->facesMs = facesMs, stats->solveMs = solveMs, stats->placeMs = watch.lap();
  return lost;
}

template <class Real>
int Reconstructor<Real>::reconstruct(const CurvePoint& point, Positions& positions) {
  const int lost = reconstruct(point, placed_);
  positions.resize(placeOf_.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Real* p = &placed_.places[4 * static_cast<std::size_t>(placeOf_[v])];
    positions[v] = Vec3(p[0], p[1], p[2]) + placed_.move;
  }
  return lost;
}

template <class Real>
Status Reconstructor<Real>::embed(const FramePoses& poses) {
  std::vector<int> faceOfVertex(shape_->vertexCount(), -1);
  for (int f = 0; f < shape_->faceCount(); ++f)
    if (frameOf_[f] >= 0)
      for (int v : shape_->faces[f])
        if (faceOfVertex[v] < 0) faceOfVertex[v] = f;
  std::vector<int> loose;
  for (const LooseVertex& l : lri_.loose) {
    faceOfVertex[l.vertex] = l.anchorFace;
    loose.push_back(l.vertex);
  }
  const auto turn = [&](int f, int c) { return lri_.face.rotation(f, c); };
  std::vector<EmbeddedPlace> anchors;
  for (const ComponentPlace& place : lri_.places) {
    anchors.push_back({place.anchorFace, place.contactFace, {}});
    for (int c = 0; c < shape_->columns(); ++c) {
      const Quaternion anchor = poses.rotation[c][place.anchorFrame] * expQuaternion(turn(place.anchorFace, c));
      anchors.back().pivot.push_back(centroidOf(shape_->poses[c], shape_->faces[place.anchorFace]) + anchor * place.offset[c]);
    }
  }
  Embedding embedding;
  const Status status = embedding.build(
      {*shape_, placeOf_, faceOfVertex, loose, frameOf_, pieceOfFace_, poses.rotation, turn, std::move(anchors), stretch_ == Stretch::Log});
  if (status) embedding_ = std::move(embedding);
  return status;
}

template <class Real>
Status Reconstructor<Real>::preview(const CurvePoint& point, const FramePoses& poses, PlacedShape<float>& shape) {
  if (!embedding_)
    if (Status status = embed(poses); !status) return status;
  source_->at(point, frames_);
  embedding_->at(poseWeights(point, *shape_), frames_.rotation, shape.places);
  shape.move = Vec3::Zero();
  return {};
}

template class Reconstructor<float>;
template class Reconstructor<double>;

}  // namespace shapespline
