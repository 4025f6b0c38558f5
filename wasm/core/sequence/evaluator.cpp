#include "core/sequence/evaluator.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/stopwatch.h"

namespace shapespline {

namespace {

CurvePoint pointAt(const Motion& motion, double t) {
  assert(std::isfinite(t));
  return motion.at(t);
}

bool moves(const RigidMotion& motion) { return motion.rotation.w() != 1 || motion.translation != Vec3::Zero(); }

}  // namespace

// welded_: the shape at `point` with frames_.
void Evaluator::hold(const EncodedShape& encoded, const Motion& motion, double t, const CurvePoint& point) {
  const Vec3 move = motion.loopMove(encoded, point);
  const Vec3 mean =
      shapespline::blend(encoded.meanPosition(), poseWeights(point.position(), encoded.shape().roles())) + move;
  const bool moved = move != Vec3::Zero();
  if (moved) moveBy(move, welded_);
  const double time = motion.curve().wrap(t).time;
  if (motion.held()) motion.held()->apply(time, frames_.rotation, mean, welded_, heldScratch_, forkJoin_);
  if (motion.pinned()) motion.pinned()->apply(time, frames_.rotation, mean, welded_, pinnedScratch_, forkJoin_);
  if (moved) moveBy(-move, welded_);
}

void Evaluator::frame(const EncodedShape& encoded, const Motion& motion, double t, Frame& frame) {
  const CurvePoint point = pointAt(motion, t);
  reconstruct(encoded, motion, point, frame);
  holdShape(encoded, motion, t, point, padded_);
  draw(encoded, motion, motion.globalMotion(encoded, t, point), frame);
}

void Evaluator::blend(const EncodedShape& encoded, const Motion& motion, const std::vector<double>& blend,
                      Frame& frame) {
  const Columns columns{encoded.shape().keys};
  assert(blend.size() == static_cast<std::size_t>(columns.keys));
  Weights weights = Weights::Zero(columns.count());
  weights.head(columns.keys) = Eigen::Map<const Eigen::VectorXd>(blend.data(), columns.keys);
  reconstruct(encoded, motion, blendedPoint(weights, columns), frame);
  draw(encoded, motion, {}, frame);
}

// Stores the shape in `padded_`.
void Evaluator::reconstruct(const EncodedShape& encoded, const Motion& motion, const CurvePoint& point, Frame& frame) {
  const Reconstruction found = reconstruct(encoded, motion, point, padded_, forkJoin_);
  stats_.facesMs = found.facesMs;
  stats_.solveMs = found.solveMs;
  stats_.positionsMs = found.positionsMs;
  frame.indefiniteFaces = found.indefiniteFaces;
  frame.indefiniteFace = found.indefiniteFaces > 0 ? encoded.input().inputFaceOf[found.indefiniteFace] : -1;
}

void Evaluator::holdShape(const EncodedShape& encoded, const Motion& motion, double t, const CurvePoint& point,
                          PaddedShape<float>& padded) {
  if (!motion.corrects()) return;
  Stopwatch watch;
  readXyzp(padded.xyzp, encoded.lri().slotOf(), padded.move, welded_);
  hold(encoded, motion, t, point);
  writeXyzp(welded_, encoded.lri().slotOf(), padded.move, padded.xyzp);
  stats_.positionsMs += watch.lap();
}

// Stores the shape in `padded`.
Reconstruction Evaluator::reconstruct(const EncodedShape& encoded, const Motion& motion, const CurvePoint& point,
                                      PaddedShape<float>& padded, ForkJoin* forkJoin) {
  stats_.localFramesMs = 0;
  if (motion.blendsVertices()) return blendKeys(encoded, point, padded);
  return encoded.lri().withReconstructor([&]<class Real>(const Reconstructor<Real>& reconstructor) {
    if constexpr (std::is_same_v<Real, float>) {
      return solve(encoded, motion, point, reconstructor, padded, forkJoin);
    } else {
      const Reconstruction found = solve(encoded, motion, point, reconstructor, double_.padded, forkJoin);
      padded.xyzp.assign(double_.padded.xyzp.begin(), double_.padded.xyzp.end());
      padded.move = double_.padded.move;
      return found;
    }
  });
}

template <class Real>
Reconstruction Evaluator::solve(const EncodedShape& encoded, const Motion& motion, const CurvePoint& point,
                                const Reconstructor<Real>& reconstructor, PaddedShape<Real>& padded,
                                ForkJoin* forkJoin) {
  ++stats_.solves;
  Solved<Real>& own = solved(reconstructor);
  Stopwatch watch;
  if (motion.options().method == Method::RotationStrain) {
    encoded.rotationStrain().rotationsAt(point, own.rotations, forkJoin);
    stats_.localFramesMs = watch.lap();
    return reconstructor.reconstruct(point, own.rotations, own.scratch, padded, forkJoin);
  }
  encoded.lri().localFramesAt(point, motion.turns(), framesScratch_, frames_);
  stats_.localFramesMs = watch.lap();
  const Reconstruction found = reconstructor.reconstruct(point, frames_, own.scratch, padded, forkJoin);
  if (motion.options().method != Method::Rimd) return found;
  return encoded.rimd().improve(point, reconstructor, rimdScratch_, own.scratch, padded, forkJoin);
}

Reconstruction Evaluator::blendKeys(const EncodedShape& encoded, const CurvePoint& point, PaddedShape<float>& padded) {
  encoded.vertices().positions(point, welded_);
  padded.move = Vec3::Zero();
  padded.xyzp.resize(4 * welded_.size());
  for (std::size_t v = 0; v < welded_.size(); ++v)
    for (int k = 0; k < 3; ++k) padded.xyzp[4 * v + k] = static_cast<float>(welded_[v][k]);
  return {};
}

void Evaluator::unmoved(const EncodedShape& encoded, const Motion& motion, const CurvePoint& point,
                        Positions& positions) {
  if (motion.blendsVertices()) return encoded.vertices().positions(point, positions);
  encoded.lri().withReconstructor([&](const auto& r) {
    auto& padded = solved(r).padded;
    solve(encoded, motion, point, r, padded, nullptr);
    r.positionsOf(padded, positions);
  });
}

void Evaluator::positions(const EncodedShape& encoded, const Motion& motion, double t, Positions& positions) {
  const CurvePoint point = pointAt(motion, t);
  unmoved(encoded, motion, point, welded_);
  if (motion.corrects()) hold(encoded, motion, t, point);
  const RigidMotion global = motion.globalMotion(encoded, t, point);
  if (moves(global))
    for (Vec3& p : welded_) p = global(p);
  const std::vector<int>& weldedOf = encoded.input().welding.weldedOfRaw;
  positions.resize(weldedOf.size());
  for (std::size_t v = 0; v < positions.size(); ++v) positions[v] = welded_[weldedOf[v]];
}

// Draws the shape in `padded_`.
void Evaluator::draw(const EncodedShape& encoded, const Motion& motion, const RigidMotion& global, Frame& frame) {
  Stopwatch watch;
  std::vector<float>& xyzp = padded_.xyzp;
  if (moves(global)) {
    for (std::size_t i = 0; i < xyzp.size(); i += 4) {
      const Vec3 p = global(Vec3(xyzp[i], xyzp[i + 1], xyzp[i + 2]) + padded_.move);
      for (int k = 0; k < 3; ++k) xyzp[i + k] = static_cast<float>(p[k]);
    }
    padded_.move = Vec3::Zero();
  }
  stats_.positionsMs += watch.lap();
  const VertexNormals& normals = motion.blendsVertices() ? encoded.vertices().normals() : encoded.lri().normals();
  normals.draw(xyzp, padded_.move, normalsScratch_, frame.positions, frame.normals, forkJoin_);
  stats_.normalsMs = watch.lap();
}

void Evaluator::ghost(const EncodedShape& encoded, const Motion& motion, double t, std::vector<float>& positions) {
  assert(encoded.lri().ghostMotion());
  Stopwatch watch;
  const GhostMotion& ghost = *encoded.lri().ghostMotion();
  const CurvePoint point = pointAt(motion, t);
  if (motion.blendsVertices()) blendVertices(ghost.shape(), encoded.meanPosition(), point, welded_);
  else ghost.positions(point, motion.turns(), framesScratch_.ghost, welded_);
  if (motion.corrects()) moveGhost(encoded, motion, t, point);
  stats_.ghostMs = watch.lap();
  const RigidMotion global = motion.globalMotion(encoded, t, point);
  positions.clear();
  for (const Vec3& p : welded_)
    for (const double x : global(p)) positions.push_back(static_cast<float>(x));
}

// Moves the ghost in `welded_` with the vertices that collapsed to it.
void Evaluator::moveGhost(const EncodedShape& encoded, const Motion& motion, double t, const CurvePoint& point) {
  Positions ghost = std::move(welded_);
  PaddedShape<float> shape;
  reconstruct(encoded, motion, point, shape, nullptr);
  PaddedShape<float> held = shape;
  holdShape(encoded, motion, t, point, held);
  const std::vector<int>& vertexOf = encoded.lri().ghostMotion()->mesh().vertexOf;
  for (std::size_t v = 0; v < ghost.size(); ++v) {
    const std::size_t at = 4 * static_cast<std::size_t>(encoded.lri().slotOf()[vertexOf[v]]);
    for (int k = 0; k < 3; ++k) ghost[v][k] += held.xyzp[at + k] - shape.xyzp[at + k];
  }
  welded_ = std::move(ghost);
}

void Evaluator::patchRotations(const EncodedShape& encoded, const Motion& motion, double t,
                               std::vector<Quaternion>& rotations) {
  const CurvePoint point = pointAt(motion, t);
  encoded.lri().patches().at(point, motion.turns(), framesScratch_.patches, frames_);
  const Quaternion turn = motion.globalMotion(encoded, t, point).rotation;
  rotations.clear();
  for (const Quaternion& g : frames_.rotation) rotations.push_back(turn * g);
}

}  // namespace shapespline
