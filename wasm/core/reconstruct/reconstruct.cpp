#include "core/reconstruct/reconstruct.h"

#include <algorithm>
#include <cassert>

#include "core/base/permutation.h"
#include "core/base/simd.h"
#include "core/base/stopwatch.h"

namespace shapespline {

namespace {

// Sum of `count` positions, in runs short enough for the precision.
template <class Real>
Vec3 sumOf(const Real* xyzp, std::size_t count) {
  constexpr std::size_t run = 64;
  Vec3 sum = Vec3::Zero();
  for (std::size_t begin = 0; begin < count; begin += run) {
    auto part = Lanes<Real>::zero();
    for (std::size_t i = begin; i < std::min(count, begin + run); ++i) part = part + Lanes<Real>::load(xyzp + 4 * i);
    alignas(32) Real number[4];
    part.store(number);
    sum += Vec3(number[0], number[1], number[2]);
  }
  return sum;
}

Mat3 frameMatrix(const LocalFrames& frames, std::size_t frame) {
  return frames.gradient.empty() ? frames.rotation[frame].toRotationMatrix() : frames.gradient[frame];
}

template <class Real>
const Real* matricesOf(const LocalFrames& frames, std::vector<Real>& matrices) {
  const std::size_t count = frames.rotation.size();
  matrices.resize(numbersPerFrame * count);
  for (std::size_t k = 0; k < count; ++k) {
    const Mat3 g = frameMatrix(frames, k);
    for (int i = 0; i < numbersPerFrame; ++i)
      matrices[numbersPerFrame * k + i] = i % 4 < 3 ? static_cast<Real>(g(i % 4, i / 4)) : Real(0);
  }
  return matrices.data();
}

}  // namespace

template <class Real>
Result<Reconstructor<Real>> Reconstructor<Real>::create(const Input& in, LriCoordinates<Real> coordinates,
                                                        const StageProgress& onProgress) {
  const Stage ordering{onProgress, "ordering"}, factorising{onProgress, "factorising"};
  Stopwatch watch;
  const CotangentLaplacian laplacian = cotangentLaplacian(in.shape.faces, in.topology.hasArea, in.topology.solved,
                                                          in.shape.poses[in.shape.reference], partOf(ordering, 0, 0.1));
  const double laplacianMs = watch.lap();
  auto poisson =
      PoissonSystem::create(laplacian, in.precision, in.order, partOf(ordering, 0.1, 1), partOf(factorising, 0, 0.8));
  if (!poisson) return poisson.error();
  const PoissonSystem::Times times = poisson->times();
  watch.lap();
  Reconstructor reconstructor(in, std::move(coordinates), std::move(*poisson), factorising);
  reconstructor.times_ = {laplacianMs + times.order, times.factor, watch.lap()};
  return reconstructor;
}

template <class Real>
Reconstructor<Real>::Reconstructor(const Input& in, LriCoordinates<Real> coordinates, PoissonSystem poisson,
                                   const FractionReport& onProgress)
    : shape_(&in.shape),
      precision_(in.precision),
      stretch_(in.stretch),
      localFrameOf_(in.localFrameOf.begin(), in.localFrameOf.end()),
      lri_(std::move(coordinates)),
      poisson_(std::move(poisson)),
      kernel_(in.shape, in.topology, localFrameOf_, in.stretch, poisson_.slot(), poisson_.trashSlot(),
              partOf(onProgress, 0.8, 0.93)),
      componentOfVertex_(in.shape.vertexCount(), -1) {
  lri_.face.reorder(kernel_.order(), partOf(onProgress, 0.93, 0.95));
  const Positions* reference = &shape_->poses[shape_->reference];
  extent_ = boundingDiagonal({&reference, 1});
  for (int f = 0; f < shape_->faceCount(); ++f)
    if (in.topology.hasArea[f])
      for (int v : shape_->faces[f]) componentOfVertex_[v] = in.topology.solved.ofFace[f];
  const auto components = static_cast<std::size_t>(in.topology.solved.count);
  verticesOfComponent_.assign(components, 0);
  for (int component : componentOfVertex_)
    if (component >= 0) ++verticesOfComponent_[component];
  slotOf_ = poisson_.slot();
  int next = poisson_.unknowns();
  for (int& slot : slotOf_)
    if (slot == poisson_.trashSlot()) slot = next++;
  assert(isPermutation(slotOf_));
  componentAt_.assign(components > 1 ? slotOf_.size() : 0, 0);
  for (std::size_t v = 0; v < componentAt_.size(); ++v) componentAt_[slotOf_[v]] = std::max(0, componentOfVertex_[v]);
}

template <class Real>
auto Reconstructor<Real>::weightsAt(const CurvePoint& point, const Turning& turning) const -> FrameWeights {
  FrameWeights weights{poseWeights(point.position(), shape_->roles()), {}, {}};
  if (!turning.frames || turning.frames->part.empty()) {
    weights.parts.push_back(poseWeights(point, shape_->roles()));
    return weights;
  }
  weights.partOf = turning.frames->part;
  for (const CurvePoint& part : point.parts->ofPart) weights.parts.push_back(poseWeights(part, shape_->roles()));
  return weights;
}

template <class Real>
Quaternion Reconstructor<Real>::faceRotation(int face, int frame, const FrameWeights& weights,
                                             const Turning& turning) const {
  if (turning.faces) return rotationOf(*turning.faces, lri_.face.slot(face));
  const std::vector<double>& column = weights.of(frame).column;
  Vec3 r = Vec3::Zero();
  for (int c = 0; c < lri_.face.columns(); ++c)
    if (column[c] != 0) r += column[c] * lri_.face.rotation(face, c);
  return turning.frames->rotation[frame] * expQuaternion(r);
}

template <class Real>
void Reconstructor<Real>::faceRotations(const CurvePoint& point, const LocalFrames& frames,
                                        std::vector<Quaternion>& rotation) const {
  const FrameWeights w = weightsAt(point, {&frames});
  rotation.resize(shape_->faceCount());
  for (int f = 0; f < shape_->faceCount(); ++f)
    rotation[f] = localFrameOf_[f] >= 0 ? faceRotation(f, localFrameOf_[f], w, {&frames}) : Quaternion::Identity();
}

template <class Real>
IndefiniteFaces Reconstructor<Real>::assemble(const FrameWeights& weights, const Turning& turning, Scratch& scratch,
                                              Real* x, ForkJoin* forkJoin) const {
  FaceTurns<Real> turns;
  if (turning.faces) turns.faces = turning.faces->data();
  else turns.frames = matricesOf(*turning.frames, scratch.matrices);
  std::fill_n(x, 4 * static_cast<std::size_t>(poisson_.size()), Real(0));
  const IndefiniteFaces found =
      kernel_.accumulate(lri_.face, turns, lri_.face.weights(weights.parts, weights.partOf), x, forkJoin);
  addTornFaces(weights, turning, x);
  return found;
}

template <class Real>
void Reconstructor<Real>::addTornFaces(const FrameWeights& weights, const Turning& turning, Real* x) const {
  for (const TornFace& torn : lri_.torn) {
    const Mat3 turn = turning.faces ? faceRotation(torn.anchorFace, torn.frame, weights, turning).toRotationMatrix()
                                    : frameMatrix(*turning.frames, static_cast<std::size_t>(torn.frame));
    const TornFace::Columns& columns = turning.faces ? torn.inAnchor : torn.inFrame;
    const Vec3 first = turn * blend(columns.first, weights.of(torn.frame)),
               second = turn * blend(columns.second, weights.of(torn.frame));
    const Vec3 corner[] = {first, second, -first - second};
    for (int k = 0; k < 3; ++k) {
      Real* const at = x + 4 * static_cast<std::size_t>(poisson_.slot()[torn.corners[k]]);
      for (int i = 0; i < 3; ++i) at[i] += static_cast<Real>(corner[k][i]);
    }
  }
}

// Refinement starts from the key with the largest weight, so a frame depends only on its weights, not on other frames.
template <class Real>
void Reconstructor<Real>::startFromKey(const FrameWeights& weights, Scratch& scratch, Real* x) const {
  const auto first = weights.parts.front().column.begin();
  const Positions& key = shape_->poses[std::max_element(first, first + shape_->keys) - first];
  scratch.rightHandSide.assign(x, x + 4 * static_cast<std::size_t>(poisson_.size()));
  std::vector<Vec3> pinned(verticesOfComponent_.size(), Vec3::Zero());
  for (std::size_t v = 0; v < key.size(); ++v)
    if (componentOfVertex_[v] >= 0 && poisson_.slot()[v] == poisson_.trashSlot())
      pinned[componentOfVertex_[v]] = key[v];
  for (std::size_t v = 0; v < key.size(); ++v) {
    if (poisson_.slot()[v] == poisson_.trashSlot()) continue;
    const Vec3 p = key[v] - pinned[componentOfVertex_[v]];
    for (int i = 0; i < 3; ++i) x[4 * static_cast<std::size_t>(poisson_.slot()[v]) + i] = static_cast<Real>(p[i]);
  }
  for (int i = 0; i < 4; ++i) x[4 * static_cast<std::size_t>(poisson_.trashSlot()) + i] = 0;
}

template <class Real>
void Reconstructor<Real>::solve(const FrameWeights& weights, Scratch& scratch, Real* x, ForkJoin* forkJoin) const {
  if constexpr (std::is_same_v<Real, double>) {
    if (precision_ == Precision::Exact) {
      startFromKey(weights, scratch, x);
      poisson_.refine(scratch.rightHandSide.data(), x, extent_, scratch.refinement, forkJoin);
      return;
    }
  }
  poisson_.solve(x, forkJoin);
}

template <class Real>
Vec3 Reconstructor<Real>::shiftedVertex(int v, const Scratch& scratch, const Real* x) const {
  const Real* p = x + 4 * static_cast<std::size_t>(poisson_.slot()[v]);
  return Vec3(p[0], p[1], p[2]) + scratch.shift[componentOfVertex_[v]];
}

template <class Real>
Vec3 Reconstructor<Real>::shiftedCentroid(int face, const Scratch& scratch, const Real* x) const {
  const Triangle& t = shape_->faces[face];
  return (shiftedVertex(t[0], scratch, x) + shiftedVertex(t[1], scratch, x) + shiftedVertex(t[2], scratch, x)) / 3;
}

// Each component keeps its offset in the R_f of its anchor face.
template <class Real>
void Reconstructor<Real>::moveComponents(const FrameWeights& weights, const Turning& turning, Scratch& scratch,
                                         const Real* x) const {
  scratch.shift.assign(verticesOfComponent_.size(), Vec3::Zero());
  for (const ComponentJoint& joint : lri_.joints) {
    const Quaternion anchor = faceRotation(joint.anchorFace, joint.anchorFrame, weights, turning);
    const Quaternion contact = faceRotation(joint.contactFace, joint.contactFrame, weights, turning);
    const Vec3 wanted =
        shiftedCentroid(joint.anchorFace, scratch, x) + anchor * blend(joint.offset, weights.of(joint.anchorFrame));
    scratch.shift[joint.component] = wanted - (shiftedCentroid(joint.contactFace, scratch, x) + contact * joint.pivot);
  }
}

template <class Real>
void Reconstructor<Real>::moveLoose(const FrameWeights& weights, const Turning& turning, Scratch& scratch,
                                    const Real* x) const {
  scratch.loose.clear();
  for (const LooseVertex& loose : lri_.loose) {
    const Quaternion anchor = faceRotation(loose.anchorFace, loose.anchorFrame, weights, turning);
    scratch.loose.push_back(shiftedCentroid(loose.anchorFace, scratch, x) +
                            anchor * blend(loose.offset, weights.of(loose.anchorFrame)));
  }
}

// The translation that moves the mean of all vertices to its position in the coordinates.
template <class Real>
Vec3 Reconstructor<Real>::meanMove(const FrameWeights& weights, const Scratch& scratch, const Real* x) const {
  Vec3 sum = sumOf(x, static_cast<std::size_t>(poisson_.unknowns()));
  for (std::size_t p = 0; p < scratch.shift.size(); ++p) sum += verticesOfComponent_[p] * scratch.shift[p];
  for (const Vec3& p : scratch.loose) sum += p;
  return blend(lri_.meanPosition, weights.position) - sum / shape_->vertexCount();
}

// The solver's slots come first, moved by the shifts of their components. Vertices without a slot follow.
template <class Real>
void Reconstructor<Real>::applyShifts(Scratch& scratch, Real* x) const {
  using L = Lanes<Real>;
  const std::size_t unknowns = static_cast<std::size_t>(poisson_.unknowns());
  std::fill(x + 4 * unknowns, x + 4 * slotOf_.size(), Real(0));  // pinned vertices are zero
  scratch.shiftLanes.assign(4 * scratch.shift.size(), Real(0));
  for (std::size_t p = 0; p < scratch.shift.size(); ++p)
    for (int k = 0; k < 3; ++k) scratch.shiftLanes[4 * p + k] = static_cast<Real>(scratch.shift[p][k]);
  for (std::size_t i = 0; i < componentAt_.size(); ++i)
    (L::load(x + 4 * i) + L::load(&scratch.shiftLanes[4 * static_cast<std::size_t>(componentAt_[i])])).store(x + 4 * i);
  for (std::size_t i = 0; i < scratch.loose.size(); ++i)
    for (int k = 0; k < 3; ++k)
      x[4 * static_cast<std::size_t>(slotOf_[lri_.loose[i].vertex]) + k] = static_cast<Real>(scratch.loose[i][k]);
}

template <class Real>
Reconstruction Reconstructor<Real>::reconstruct(const CurvePoint& point, const LocalFrames& frames, Scratch& scratch,
                                                PaddedShape<Real>& shape, ForkJoin* forkJoin) const {
  return reconstruct(point, Turning{.frames = &frames}, scratch, shape, forkJoin);
}

template <class Real>
Reconstruction Reconstructor<Real>::reconstruct(const CurvePoint& point, const RotationBlocks<Real>& rotations,
                                                Scratch& scratch, PaddedShape<Real>& shape, ForkJoin* forkJoin) const {
  return reconstruct(point, Turning{.faces = &rotations}, scratch, shape, forkJoin);
}

template <class Real>
Reconstruction Reconstructor<Real>::reconstruct(const CurvePoint& point, const Turning& turning, Scratch& scratch,
                                                PaddedShape<Real>& shape, ForkJoin* forkJoin) const {
  Stopwatch watch;
  Reconstruction result;
  const FrameWeights w = weightsAt(point, turning);
  shape.xyzp.resize(4 * std::max(static_cast<std::size_t>(poisson_.size()), slotOf_.size()));
  Real* const x = shape.xyzp.data();
  const IndefiniteFaces indefinite = assemble(w, turning, scratch, x, forkJoin);
  result.indefiniteFaces = indefinite.count;
  if (indefinite.slot >= 0) result.indefiniteFace = kernel_.order()[indefinite.slot];
  result.facesMs = watch.lap();
  solve(w, scratch, x, forkJoin);
  result.solveMs = watch.lap();
  moveComponents(w, turning, scratch, x);
  moveLoose(w, turning, scratch, x);
  shape.move = meanMove(w, scratch, x);
  applyShifts(scratch, x);
  result.positionsMs = watch.lap();
  return result;
}

template <class Real>
Reconstruction Reconstructor<Real>::reconstruct(const CurvePoint& point, const LocalFrames& frames, Scratch& scratch,
                                                Positions& positions) const {
  const Reconstruction result = reconstruct(point, frames, scratch, scratch.padded);
  positionsOf(scratch.padded, positions);
  return result;
}

template <class Real>
void Reconstructor<Real>::positionsOf(const PaddedShape<Real>& shape, Positions& positions) const {
  positions.resize(slotOf_.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Real* p = &shape.xyzp[4 * static_cast<std::size_t>(slotOf_[v])];
    positions[v] = Vec3(p[0], p[1], p[2]) + shape.move;
  }
}

template <class Real>
void Reconstructor<Real>::stretchesAt(const CurvePoint& point, std::vector<Real>& stretch) const {
  kernel_.stretches(lri_.face, lri_.face.weights(poseWeights(point, shape_->roles())), stretch);
}

template class Reconstructor<float>;
template class Reconstructor<double>;

}  // namespace shapespline
