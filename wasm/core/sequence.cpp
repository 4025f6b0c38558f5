#include "core/sequence.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "core/mesh.h"
#include "core/metrics.h"
#include "core/sequence_stages.h"
#include "core/shading.h"
#include "core/shape_motion.h"
#include "core/spline.h"
#include "core/text.h"
#include "core/weld.h"

namespace shapespline {

namespace {

// Poses closer than this, over the diagonal, are the same up to rounding and a modeller's noise.
constexpr double samePose = 1e-4;
// Above this the keys leave open which way and how often a part turned between them.
constexpr double ambiguousTurn = 150 * std::numbers::pi / 180;
// Times at which the mean rotation's condition is sampled, as an upper bound.
constexpr int conditionSamples = 240;
// The slider reaches this far beyond the ends, as a share of the key range.
constexpr double margin = 0.4;
constexpr int leastGhostFaces = 4;

std::vector<double> timesOf(const Keyframes& keyframes) {
  std::vector<double> times;
  for (const Key& key : keyframes.keys) times.push_back(key.time);
  return times;
}

Status checkEncoding(const EncodingOptions& o, const Keyframes& k) {
  const auto invalid = [](std::string message) { return Error{ErrorCode::InvalidOption, std::move(message)}; };
  if (o.reference < 0 || o.reference >= k.keyCount())
    return invalid("The reference is key " + std::to_string(o.reference + 1) + ", but there are " +
                   std::to_string(k.keyCount()) + " keys.");
  if (o.patches < 0) return invalid("The number of patches is " + grouped(o.patches) + ". Use 0 for the default, or more.");
  if (o.ghostFaces < 0 || (o.ghostFaces > 0 && o.ghostFaces < leastGhostFaces))
    return invalid("A ghost mesh needs at least " + std::to_string(leastGhostFaces) + " faces, but " + grouped(o.ghostFaces) +
                   " are asked for. Use 0 to work without one.");
  if (o.rootPatch < 0) return invalid("The root patch must not be negative.");
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

Status checkTurns(const std::vector<AddedTurns>& turns, int keyCount) {
  for (const AddedTurns& t : turns)
    if (t.key < 1 || t.key >= keyCount || std::abs(t.turns) > 1000)
      return Error{ErrorCode::InvalidOption, "Whole turns can be added to keys 2 to " + std::to_string(keyCount) +
                                                 ", up to 1000 each; got " + std::to_string(t.turns) + " for key " +
                                                 std::to_string(t.key + 1) + "."};
  return {};
}

bool isLinear(Method method) { return method == Method::Geodesic || method == Method::Linear; }
bool blendsVertices(Method method) { return method == Method::Linear || method == Method::CubicVertex; }

// The baselines: every vertex on its own.
void blendVertices(const WeldedShape& shape, const Weights& weights, Positions& out) {
  const PoseWeights w = poseWeights(weights, shape);
  out.assign(shape.vertexCount(), Vec3::Zero());
  for (int c = 0; c < shape.columns(); ++c)
    for (std::size_t v = 0; v < out.size(); ++v) out[v] += w.column[c] * shape.poses[c][v];
}

}  // namespace

struct Sequence::State {
  Keyframes raw;
  MotionOptions motion;
  int wantedGhostFaces = 0;
  Ghost ghost;
  Welding welding;
  WeldedShape shape;
  Shading shading;
  double diagonal = 0;
  Closing closing = Closing::Extra;
  Quaternion closingRotation = Quaternion::Identity();  // of the rigid motion from the first key to the last
  std::unique_ptr<ShapeMotion> shapeMotion;
  std::optional<Curve> curve;
  SequenceStats stats;
  std::vector<Warning> warnings;
  Eigen::MatrixXd gram;  // made when it is first asked for
  Crew* crew = nullptr;
  std::vector<float> places;  // scratch, as the rest
  Positions weldedPositions, ghostPositions;

  Columns columns() const { return {shape.keys}; }

  void weldKeys(const EncodingOptions& encoding, const FractionReport& onProgress);
  void prepareShading(const FractionReport& onProgress);
  void findClosing();
  void decideAlignment(const FractionReport& onProgress);
  CurveOptions curveOptions(const MotionOptions& options) const;
  void describeGhost();
  void collectWarnings();
  // How far and how the whole shape is moved after its reconstruction at a wrapped time.
  struct Global {
    Mat3 rotation = Mat3::Identity();
    Vec3 pivot = Vec3::Zero(), translation = Vec3::Zero();
    bool moves = false;
    Vec3 apply(const Vec3& p) const { return rotation * (p - pivot) + pivot + translation; }
  };
  Global globalMotion(double t, const WrappedTime& wrapped, const Weights& weights) const;
  Vec3 meanPosition(const Weights& weights) const;
  int weldedShape(const Weights& weights, Positions& out);
  int placedShape(const Weights& weights);
  void fill(const Weights& weights, const Global& global, Frame& frame);
  void finish(const Global& global, Frame& frame);
  void fill(const Weights& weights, const Global& global, Positions& positions);
  const Eigen::MatrixXd& gramMatrix();
  Eigen::VectorXd poseWeightsAt(double t) const;
};

void Sequence::State::weldKeys(const EncodingOptions& encoding, const FractionReport& onProgress) {
  std::vector<const Positions*> poses;
  for (const Key& key : raw.keys) poses.push_back(&key.positions);
  shape.keys = raw.keyCount();
  shape.reference = encoding.reference;
  if (encoding.startTangent) shape.startTangent = static_cast<int>(poses.size()), poses.push_back(&*encoding.startTangent);
  if (encoding.endTangent) shape.endTangent = static_cast<int>(poses.size()), poses.push_back(&*encoding.endTangent);
  diagonal = boundingDiagonal(poses);
  welding = weld(poses, weldTolerance * diagonal, partOf(onProgress, 0, 0.8));
  shape.faces = weldFaces(raw.faces, welding);
  for (const Positions* pose : poses) shape.poses.push_back(weldPositions(*pose, welding));
}

void Sequence::State::prepareShading(const FractionReport& onProgress) {
  int groups = 0;
  const std::vector<int> group = shadingGroups(welding, raw.normals, groups);
  std::vector<int> placeOf;
  placeOf.reserve(welding.weldedOfRaw.size());
  reportFraction(onProgress, 0.1);
  for (int w : welding.weldedOfRaw) placeOf.push_back(shapeMotion->placeOf()[w]);
  shading = Shading(raw.faces, group, groups, placeOf, partOf(onProgress, 0.2, 1));
}

void Sequence::State::findClosing() {
  const RigidFit fit = fitRigid(shape.poses.front(), shape.poses[shape.keys - 1]);
  if (fit.largestDistance > samePose * diagonal) return;
  closing = Closing::LastKey;
  closingRotation = Quaternion(fit.rotation);
}

// Whether the mean rotation can be trusted is asked once, at the keys and at fixed times between and beyond them: asked for
// every frame, the shape would jump while the time is dragged.
void Sequence::State::decideAlignment(const FractionReport& onProgress) {
  const std::vector<double> times = timesOf(raw);
  const double span = times.back() - times.front();
  const int samples = std::min(conditionSamples, 8 * shape.keys);
  std::vector<std::vector<Quaternion>> sampled;
  for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Periodic}) {
    const auto curveFit = Curve::fit(times, {.boundary = boundary, .closing = closing});
    if (!curveFit) continue;
    for (int i = 0; i <= samples; ++i) {
      const double t = times.front() + span * (-margin + (1 + 2 * margin) * i / samples);
      reportFraction(onProgress, static_cast<double>(sampled.size()) / (2 * samples + 2));
      sampled.emplace_back();
      shapeMotion->patchMotion().unaligned(curveFit->weights(curveFit->wrap(t).time), sampled.back());
    }
  }
  shapeMotion->patchMotion().alignment().decide(sampled);
}

CurveOptions Sequence::State::curveOptions(const MotionOptions& o) const {
  return {.linear = isLinear(o.method),
          .boundary = o.boundary,
          .startSpeed = o.startSpeed,
          .endSpeed = o.endSpeed,
          .startShape = shape.startTangent >= 0,
          .endShape = shape.endTangent >= 0,
          .closing = closing,
          .period = o.period,
          .tension = o.tension,
          .bias = o.bias};
}

void Sequence::State::collectWarnings() {
  warnings.clear();
  if (shapeMotion->patchMotion().alignment().largestIncrement() > ambiguousTurn)
    warnings.push_back({"ambiguous-turn",
                        "Between two keys the whole shape turns by more than 150 degrees. The keys alone do not say which "
                        "way and how often: add whole turns to a key, or a key in between."});
  if (shapeMotion->patchMotion().coordinates().largestPairTurn > ambiguousTurn)
    warnings.push_back({"ambiguous-part-turn",
                        "Between two keys neighbouring parts turn by more than 150 degrees against each other. Add a key in "
                        "between if they go the wrong way."});
  if (motion.boundary == BoundaryKind::Periodic && closing == Closing::Extra && shapeMotion->hasWinding())
    warnings.push_back({"winding", "Some parts turn on by a whole turn in each period. Their motion is continuous where "
                                   "the loop closes, but its speed may jump there."});
  if (wantedGhostFaces > 0 && stats.ghostFaces == 0)
    warnings.push_back({"ghost-off", "The shape has no more faces than the ghost mesh was to have: it moves without one."});
  if (stats.ghostFaces > wantedGhostFaces)
    warnings.push_back({"ghost-too-large", "The ghost mesh could not be made as coarse as asked for without turning faces over "
                                           "or changing the topology.", stats.ghostFaces});
  if (stats.joinedComponents > 0)
    warnings.push_back({"ghost-joined-parts", "Some parts are too small for a share of the ghost mesh: they follow their "
                                              "neighbours. Give the ghost more faces.", stats.joinedComponents});
  if (const int pivots = shapeMotion->solverStats().regularisedPivots; pivots > 0)
    warnings.push_back({"regularised", "The mesh has places so thin that the solver had to hold them in place.", pivots});
}

void Sequence::State::describeGhost() {
  const GhostMotion* motion = shapeMotion->ghost();
  if (!motion) return;
  const GhostMesh& mesh = motion->mesh();
  ghost.faces = mesh.faces;
  for (int v : mesh.vertexOf) ghost.vertexOf.push_back(welding.rawOfWelded[v]);
  for (int w : welding.weldedOfRaw) ghost.ghostVertexOf.push_back(mesh.ghostOf[w]);
  ghost.ghostFaceOf = motion->correspondence();
}

Vec3 Sequence::State::meanPosition(const Weights& weights) const {
  const PoseWeights w = poseWeights(weights, shape);
  Vec3 sum = Vec3::Zero();
  for (int c = 0; c < shape.columns(); ++c) sum += w.column[c] * shapeMotion->meanPosition()[c];
  return sum;
}

Sequence::State::Global Sequence::State::globalMotion(double t, const WrappedTime& wrapped, const Weights& weights) const {
  Global global;
  const auto& mean = shapeMotion->meanPosition();
  const Vec3 travel = mean[shape.keys - 1] - mean[0];
  const bool closesOnLast = closing == Closing::LastKey && curve->end() <= raw.keys.back().time;
  if (wrapped.periods != 0 && closesOnLast) {
    // One more period is one more of the rigid motion that takes the first key to the last.
    const Eigen::AngleAxisd once(closingRotation);
    global.rotation = Eigen::AngleAxisd(once.angle() * wrapped.periods, once.axis()).toRotationMatrix();
    global.pivot = meanPosition(weights);
    global.translation = wrapped.periods * travel;
    global.moves = true;
  }
  if (motion.inPlace && (!curve->periodic() || closesOnLast)) {
    const double span = raw.keys.back().time - raw.keys.front().time;
    global.translation -= (t - raw.keys.front().time) / span * travel;
    global.moves = true;
  }
  return global;
}

int Sequence::State::weldedShape(const Weights& weights, Positions& out) {
  if (blendsVertices(motion.method)) return blendVertices(shape, weights, out), 0;
  ++stats.solves;
  return shapeMotion->at(weights, out);
}

// Leaves the shape in `places`, (x, y, z, pad) of each welded vertex.
int Sequence::State::placedShape(const Weights& weights) {
  if (!blendsVertices(motion.method)) {
    ++stats.solves;
    return shapeMotion->at(weights, places, stats, crew);
  }
  stats.facesMs = stats.solveMs = stats.placeMs = 0;
  blendVertices(shape, weights, weldedPositions);
  places.resize(4 * weldedPositions.size());
  for (std::size_t v = 0; v < weldedPositions.size(); ++v)
    for (int k = 0; k < 3; ++k)
      places[4 * static_cast<std::size_t>(shapeMotion->placeOf()[v]) + k] = static_cast<float>(weldedPositions[v][k]);
  return 0;
}

void Sequence::State::fill(const Weights& weights, const Global& global, Positions& positions) {
  weldedShape(weights, weldedPositions);
  if (global.moves)
    for (Vec3& p : weldedPositions) p = global.apply(p);
  positions.resize(welding.weldedOfRaw.size());
  for (std::size_t v = 0; v < positions.size(); ++v) positions[v] = weldedPositions[welding.weldedOfRaw[v]];
}

void Sequence::State::fill(const Weights& weights, const Global& global, Frame& frame) {
  frame.lostDefiniteness = placedShape(weights);
  finish(global, frame);
}

// From the welded vertices in `places` to what is drawn.
void Sequence::State::finish(const Global& global, Frame& frame) {
  Stopwatch watch;
  if (global.moves)
    for (std::size_t i = 0; i < places.size(); i += 4) {
      const Vec3 p = global.apply({places[i], places[i + 1], places[i + 2]});
      for (int k = 0; k < 3; ++k) places[i + k] = static_cast<float>(p[k]);
    }
  stats.placeMs += watch.lap();
  shading.draw(places, frame.positions, frame.normals, crew);
  stats.normalsMs = watch.lap();
}

const Eigen::MatrixXd& Sequence::State::gramMatrix() {
  if (gram.size() == 0) gram = shapeMotion->gram(diagonal);
  return gram;
}

Eigen::VectorXd Sequence::State::poseWeightsAt(double t) const {
  const PoseWeights w = poseWeights(curve->weights(curve->wrap(t).time), shape);
  return Eigen::Map<const Eigen::VectorXd>(w.column.data(), static_cast<Eigen::Index>(w.column.size()));
}

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
  s.findClosing();
  report("factorising", 0.97);
  s.decideAlignment([&](double fraction) { report("factorising", 0.97 + 0.03 * fraction); });

  s.stats.patches = s.shapeMotion->patchMotion().coordinates().patches.count;
  s.stats.weldedVertices = s.welding.count;
  s.stats.factorBytes = s.shapeMotion->solverStats().factorBytes;
  s.stats.alignedByPatches = s.shapeMotion->patchMotion().alignment().byPatches();

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
  if (Status status = checkTurns(motion.turns, s.shape.keys); !status) return status;
  Result<Curve> curve = Curve::fit(keyTimes, s.curveOptions(motion));
  if (!curve) return curve.error();
  s.curve = std::move(*curve);
  s.motion = motion;
  for (int j = 0; j < s.shape.keys; ++j) s.raw.keys[j].time = keyTimes[j];
  s.shapeMotion->patchMotion().alignment().setTurns(motion.turns);
  s.collectWarnings();
  return {};
}

namespace {

Status checkTime(double t) {
  if (std::isfinite(t)) return {};
  return Error{ErrorCode::InvalidOption, "The time is not a finite number."};
}

}  // namespace

Status Sequence::evaluate(double t, Frame& frame) {
  if (Status status = checkTime(t); !status) return status;
  const WrappedTime wrapped = state_->curve->wrap(t);
  const Weights weights = state_->curve->weights(wrapped.time);
  state_->fill(weights, state_->globalMotion(t, wrapped, weights), frame);
  return {};
}

Status Sequence::preview(double t, Frame& frame) {
  if (Status status = checkTime(t); !status) return status;
  State& s = *state_;
  const WrappedTime wrapped = s.curve->wrap(t);
  const Weights weights = s.curve->weights(wrapped.time);
  if (blendsVertices(s.motion.method)) return evaluate(t, frame);
  frame.lostDefiniteness = 0;
  s.stats.facesMs = s.stats.solveMs = s.stats.placeMs = 0;
  if (Status status = s.shapeMotion->previewAt(weights, s.places); !status) return status;
  s.finish(s.globalMotion(t, wrapped, weights), frame);
  return {};
}

Status Sequence::evaluate(double t, Positions& positions) {
  if (Status status = checkTime(t); !status) return status;
  const WrappedTime wrapped = state_->curve->wrap(t);
  const Weights weights = state_->curve->weights(wrapped.time);
  state_->fill(weights, state_->globalMotion(t, wrapped, weights), positions);
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
  state_->fill(weights, {}, frame);
  return {};
}

Status Sequence::evaluateGhost(double t, std::vector<float>& positions) {
  if (Status status = checkTime(t); !status) return status;
  State& s = *state_;
  GhostMotion* ghost = s.shapeMotion->ghost();
  if (!ghost) return Error{ErrorCode::InvalidOption, "This sequence has no ghost mesh. Create it with ghost faces."};
  const WrappedTime wrapped = s.curve->wrap(t);
  const Weights weights = s.curve->weights(wrapped.time);
  const State::Global global = s.globalMotion(t, wrapped, weights);
  if (blendsVertices(s.motion.method)) blendVertices(ghost->shape(), weights, s.ghostPositions);
  else ghost->positions(weights, s.ghostPositions);
  positions.clear();
  for (const Vec3& p : s.ghostPositions)
    for (const double x : global.apply(p)) positions.push_back(static_cast<float>(x));
  return {};
}

const Ghost& Sequence::ghost() const { return state_->ghost; }

const Keyframes& Sequence::keyframes() const { return state_->raw; }
const MotionOptions& Sequence::motion() const { return state_->motion; }
SequenceStats Sequence::stats() const { return state_->stats; }
const std::vector<Warning>& Sequence::warnings() const { return state_->warnings; }
std::pair<double, double> Sequence::range() const { return {state_->curve->start(), state_->curve->end()}; }
const std::vector<int>& Sequence::patchOfFace() const { return state_->shapeMotion->patchOfFace(); }

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
