#include "core/sequence/sequence.h"

#include <algorithm>
#include <cmath>

#include "core/spline/discrete_spline.h"
#include "core/sequence/gram_matrix.h"
#include "core/sequence/build_progress.h"
#include "core/sequence/sequence_state.h"
#include "core/base/format.h"

namespace shapespline {

namespace {

constexpr int leastGhostFaces = 4;
constexpr int mostTurns = 1000;

Status checkEncoding(const EncodingOptions& o, const Keyframes& k) {
  const auto invalid = [](std::string message) { return Error{ErrorCode::InvalidOption, std::move(message)}; };
  if (o.reference < 0 || o.reference >= k.keyCount())
    return invalid("The reference is key " + std::to_string(o.reference + 1) + ", but there are " +
                   std::to_string(k.keyCount()) + " keys.");
  if (o.patches < 0) return invalid("The number of patches is " + grouped(o.patches) + ". Use 0 for the default, or more.");
  if (o.ghostFaces < 0 || (o.ghostFaces > 0 && o.ghostFaces < leastGhostFaces))
    return invalid("A ghost mesh needs at least " + std::to_string(leastGhostFaces) + " faces, but " + grouped(o.ghostFaces) +
                   " are asked for. Use 0 to work without one.");
  for (const auto* tangent : {&o.startTangent, &o.endTangent}) {
    if (!*tangent) continue;
    if (static_cast<int>((*tangent)->size()) != k.vertexCount())
      return Error{ErrorCode::VertexCountMismatch, "A tangent shape has " + grouped(static_cast<std::int64_t>((*tangent)->size())) +
                                                       " vertices, but the keys have " + grouped(k.vertexCount()) +
                                                       ". Use a pose of the same mesh."};
    for (std::size_t v = 0; v < (*tangent)->size(); ++v)
      if (!(**tangent)[v].allFinite())
        return Error{ErrorCode::NotFinite, "A tangent shape's vertex " + grouped(static_cast<std::int64_t>(v)) + " is not finite.", -1, static_cast<int>(v)};
  }
  return {};
}

Status checkTurns(const std::vector<AddedTurns>& turns, int keyCount, int components) {
  const auto number = [](int index) { return std::to_string(static_cast<std::int64_t>(index) + 1); };  // counted from 1
  for (const AddedTurns& t : turns) {
    if (t.key < 1 || t.key >= keyCount || t.turns < -mostTurns || t.turns > mostTurns)
      return Error{ErrorCode::InvalidOption, "Whole turns can be added to keys 2 to " + std::to_string(keyCount) + ", up to " +
                                                 grouped(mostTurns) + " each; got " + std::to_string(t.turns) + " for key " + number(t.key) + "."};
    if (t.component < -1 || t.component >= components)
      return Error{ErrorCode::InvalidOption, "Whole turns are added to component " + number(t.component) + ", but the shape has " +
                                                 grouped(components) + "."};
  }
  return {};
}

Status checkTime(double t) {
  if (std::isfinite(t)) return {};
  return Error{ErrorCode::InvalidOption, "The time is not a finite number."};
}

}  // namespace

Result<Sequence> Sequence::create(Keyframes keyframes, const EncodingOptions& encoding, const MotionOptions& motion,
                                  const Progress& progress) {
  double reached = 0;
  const auto report = [&, withGhost = encoding.ghostFaces > 0](const char* stage, double fraction) {
    reached = std::max(reached, wholeProgress(stage, fraction, withGhost));
    if (progress) progress(stage, reached);
  };
  report("welding", 0);
  if (Status status = validate(keyframes); !status) return status.error();
  if (Status status = checkEncoding(encoding, keyframes); !status) return status.error();
  if (keyframes.normals.size() != static_cast<std::size_t>(keyframes.vertexCount())) keyframes.normals.clear();

  auto state = std::make_unique<State>();
  State& s = *state;
  s.raw = std::move(keyframes);
  Stopwatch watch;
  report("welding", 0);
  s.weldKeys(encoding, [&](double fraction) { report("welding", fraction); });
  s.stats.weldMs = watch.lap();
  report("welding", 1);
  auto shapeMotion = ShapeMotion::create(s.shape, encoding, s.stats, report);
  if (!shapeMotion) return shapeMotion.error();
  s.shapeMotion = std::move(*shapeMotion);
  s.wantedGhostFaces = encoding.ghostFaces;
  s.prepareShading([&](double fraction) { report("factorising", 0.95 + 0.02 * fraction); });
  report("factorising", 0.97);
  s.describeGhost();
  s.numberComponents();
  s.findMirroredKeys();

  s.patchOfRawFace = s.ofRawFaces(s.shapeMotion->patchOfFace());
  s.stats.patches = s.shapeMotion->patchMotion().coordinates().patches.count;
  s.stats.weldedVertices = s.welding.count;
  const CholeskyStats solver = s.shapeMotion->solverStats();
  s.stats.factorBytes = solver.factorBytes + solver.indexBytes;

  Sequence sequence(std::move(state));
  if (Status status = sequence.update(motion, timesOf(s.raw)); !status) return status.error();
  report("factorising", 1);
  return sequence;
}

Sequence::Sequence(std::unique_ptr<State> state) : state_(std::move(state)) {}
Sequence::Sequence(Sequence&&) noexcept = default;
Sequence& Sequence::operator=(Sequence&&) noexcept = default;
Sequence::~Sequence() = default;

void Sequence::setCrew(Crew* crew) { state_->crew = crew; }

Status Sequence::update(const MotionOptions& motion, const std::vector<double>& keyTimes) {
  State& s = *state_;
  if (Status status = validateTimes(keyTimes, s.shape.keys); !status) return status;
  if (Status status = checkTurns(motion.turns, s.shape.keys, static_cast<int>(s.firstFaceOf.size())); !status) return status;
  Result<Curve> curve = Curve::fit(keyTimes, s.curveOptions(motion));
  if (!curve) return curve.error();
  s.curve = std::move(*curve);
  s.motion = motion;
  for (int j = 0; j < s.shape.keys; ++j) s.raw.keys[j].time = keyTimes[j];
  s.shapeMotion->patchMotion().setTurns(s.turnsOfPatchPieces());
  s.collectWarnings();
  return {};
}

Status Sequence::evaluate(double t, Frame& frame) {
  if (Status status = checkTime(t); !status) return status;
  const WrappedTime wrapped = state_->curve->wrap(t);
  const CurvePoint point = state_->curve->at(wrapped.time);
  state_->fill(point, state_->globalMotion(t, wrapped, point), frame);
  return {};
}

Status Sequence::preview(double t, Frame& frame) {
  if (Status status = checkTime(t); !status) return status;
  State& s = *state_;
  const WrappedTime wrapped = s.curve->wrap(t);
  const CurvePoint point = s.curve->at(wrapped.time);
  if (blendsVertices(s.motion.method)) return evaluate(t, frame);
  frame.lostDefiniteness = 0;
  frame.lostFace = -1;
  s.stats.framesMs = s.stats.facesMs = s.stats.solveMs = s.stats.placeMs = 0;
  if (Status status = s.shapeMotion->previewAt(point, s.placed); !status) return status;
  s.finish(s.globalMotion(t, wrapped, point), frame);
  return {};
}

Result<PreviewError> Sequence::previewError(double t) {
  if (Status status = checkTime(t); !status) return status.error();
  State& s = *state_;
  if (blendsVertices(s.motion.method)) return PreviewError{};
  const CurvePoint point = s.curve->at(s.curve->wrap(t).time);
  PlacedShape<float> exact, about;
  SequenceStats unused;  // those of the last frame stay
  ++s.stats.solves;
  s.shapeMotion->at(point, exact, unused, nullptr);
  if (Status status = s.shapeMotion->previewAt(point, about); !status) return status.error();
  return s.distance(exact, about);
}

Status Sequence::evaluate(double t, Positions& positions) {
  if (Status status = checkTime(t); !status) return status;
  const WrappedTime wrapped = state_->curve->wrap(t);
  const CurvePoint point = state_->curve->at(wrapped.time);
  state_->fill(point, state_->globalMotion(t, wrapped, point), positions);
  return {};
}

Status Sequence::evaluateBlend(const std::vector<double>& blend, Frame& frame) {
  const Columns columns = state_->columns();
  if (static_cast<int>(blend.size()) != columns.keys)
    return Error{ErrorCode::InvalidOption, "There are " + grouped(static_cast<std::int64_t>(blend.size())) +
                                               " weights for " + grouped(columns.keys) + " keys. Give one a key."};
  Weights weights = Weights::Zero(columns.count());
  weights.head(columns.keys) = Eigen::Map<const Eigen::VectorXd>(blend.data(), columns.keys);
  if (!weights.allFinite() || std::abs(weights.sum() - 1) > 1e-6)
    return Error{ErrorCode::InvalidOption, "The weights must be finite and sum to 1."};
  state_->fill(blendedPoint(weights, columns), {}, frame);
  return {};
}

Status Sequence::evaluateGhost(double t, std::vector<float>& positions) {
  if (Status status = checkTime(t); !status) return status;
  State& s = *state_;
  GhostMotion* ghost = s.shapeMotion->ghost();
  if (!ghost) return Error{ErrorCode::InvalidOption, "This sequence has no ghost mesh. Create it with ghost faces."};
  Stopwatch watch;
  const WrappedTime wrapped = s.curve->wrap(t);
  const CurvePoint point = s.curve->at(wrapped.time);
  const RigidMotion global = s.globalMotion(t, wrapped, point);
  if (blendsVertices(s.motion.method)) blendVertices(ghost->shape(), point, s.ghostPositions);
  else ghost->positions(point, s.ghostPositions);
  s.stats.ghostMs = watch.lap();
  positions.clear();
  for (const Vec3& p : s.ghostPositions)
    for (const double x : global(p)) positions.push_back(static_cast<float>(x));
  return {};
}

const Ghost& Sequence::ghost() const { return state_->ghost; }

const Keyframes& Sequence::keyframes() const { return state_->raw; }
const MotionOptions& Sequence::motion() const { return state_->motion; }
SequenceStats Sequence::stats() const { return state_->stats; }
const std::vector<Warning>& Sequence::warnings() const { return state_->warnings; }
std::pair<double, double> Sequence::range() const { return {state_->curve->start(), state_->curve->end()}; }
const std::vector<int>& Sequence::patchOfFace() const { return state_->patchOfRawFace; }
const std::vector<int>& Sequence::componentOfFace() const { return state_->componentOfRawFace; }

Status Sequence::patchRotations(double t, std::vector<Quaternion>& rotations) {
  if (Status status = checkTime(t); !status) return status;
  State& s = *state_;
  const WrappedTime wrapped = s.curve->wrap(t);
  const CurvePoint point = s.curve->at(wrapped.time);
  Frames frames;
  s.shapeMotion->patchMotion().at(point, frames);
  const Quaternion turn = s.globalMotion(t, wrapped, point).rotation;
  rotations.clear();
  for (const Quaternion& g : frames.rotation) rotations.push_back(turn * g);
  return {};
}

ShapePlane Sequence::shapePlane(const std::vector<double>& times) {
  State& s = *state_;
  const PrincipalPlane plane(s.gramMatrix(), s.shape.keys);
  ShapePlane result;
  result.explained = plane.explained();
  const auto append = [](std::vector<double>& list, const Vec2& p) { list.insert(list.end(), {p.x(), p.y()}); };
  for (int j = 0; j < s.shape.keys; ++j) append(result.keys, plane.project(Eigen::VectorXd::Unit(s.shape.columns(), j)));
  for (double t : times) append(result.curve, plane.project(s.poseWeightsAt(t)));
  return result;
}

Result<DiscretePath> Sequence::discretePath(int samples) {
  State& s = *state_;
  const Result<DiscreteSpline> spline = DiscreteSpline::fit(timesOf(s.raw), s.motion.boundary, *s.curve, samples);
  if (!spline) return spline.error();
  const Eigen::MatrixXd& gram = s.gramMatrix();
  const PrincipalPlane plane(gram, s.shape.keys);
  const Eigen::MatrixXd toPoses = s.columnsToPoses(), columnGram = toPoses * gram * toPoses.transpose();
  Eigen::MatrixXd curve(samples, toPoses.rows());
  DiscretePath path;
  path.times = spline->times();
  for (int i = 0; i < samples; ++i) {
    curve.row(i) = s.curve->weights(path.times[i]).transpose();
    const Eigen::VectorXd weights = (spline->weights().row(i) * toPoses).transpose();
    path.weights.insert(path.weights.end(), weights.begin(), weights.end());
    const Vec2 p = plane.project(weights);
    path.plane.insert(path.plane.end(), {p.x(), p.y()});
  }
  path.energy = spline->energy(spline->weights(), columnGram);
  path.curveEnergy = spline->energy(curve, columnGram);
  return path;
}

std::vector<double> Sequence::bendingEnergy(const std::vector<double>& times) {
  State& s = *state_;
  const Eigen::MatrixXd& gram = s.gramMatrix();
  const auto energy = [&](const Eigen::VectorXd& w) { return std::max(0.0, w.dot(gram * w)); };
  double average = 0;
  for (int j = 1; j < s.shape.keys; ++j) {
    Eigen::VectorXd step = Eigen::VectorXd::Zero(s.shape.columns());
    step[j] = 1, step[j - 1] = -1;
    average += energy(step) / (s.shape.keys - 1);
  }
  const double h = (s.curve->end() - s.curve->start()) / 100;
  std::vector<double> result;
  for (double t : times) {
    const Eigen::VectorXd second =
        (s.poseWeightsAt(t - h) - 2 * s.poseWeightsAt(t) + s.poseWeightsAt(t + h)) / (h * h);
    result.push_back(average > 0 ? energy(second) / average : 0);
  }
  return result;
}

}  // namespace shapespline
