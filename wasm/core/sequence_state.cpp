#include "core/sequence_state.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/metrics.h"

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

bool isLinear(Method method) { return method == Method::Geodesic || method == Method::Linear; }

}  // namespace

std::vector<double> timesOf(const Keyframes& keyframes) {
  std::vector<double> times;
  for (const Key& key : keyframes.keys) times.push_back(key.time);
  return times;
}

bool blendsVertices(Method method) { return method == Method::Linear || method == Method::CubicVertex; }

void blendVertices(const WeldedShape& shape, const Weights& weights, Positions& out) {
  const PoseWeights w = poseWeights(weights, shape);
  out.assign(shape.vertexCount(), Vec3::Zero());
  for (int c = 0; c < shape.columns(); ++c)
    for (std::size_t v = 0; v < out.size(); ++v) out[v] += w.column[c] * shape.poses[c][v];
}

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

// Leaves the shape in `placed`.
int Sequence::State::placedShape(const Weights& weights) {
  if (!blendsVertices(motion.method)) {
    ++stats.solves;
    return shapeMotion->at(weights, placed, stats, crew);
  }
  stats.facesMs = stats.solveMs = stats.placeMs = 0;
  blendVertices(shape, weights, weldedPositions);
  placed.move = Vec3::Zero();
  placed.places.resize(4 * weldedPositions.size());
  for (std::size_t v = 0; v < weldedPositions.size(); ++v)
    for (int k = 0; k < 3; ++k)
      placed.places[4 * static_cast<std::size_t>(shapeMotion->placeOf()[v]) + k] = static_cast<float>(weldedPositions[v][k]);
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

// From `placed` to what is drawn.
void Sequence::State::finish(const Global& global, Frame& frame) {
  Stopwatch watch;
  std::vector<float>& places = placed.places;
  if (global.moves) {
    for (std::size_t i = 0; i < places.size(); i += 4) {
      const Vec3 p = global.apply(Vec3(places[i], places[i + 1], places[i + 2]) + placed.move);
      for (int k = 0; k < 3; ++k) places[i + k] = static_cast<float>(p[k]);
    }
    placed.move = Vec3::Zero();
  }
  stats.placeMs += watch.lap();
  shading.draw(places, placed.move, frame.positions, frame.normals, crew);
  stats.normalsMs = watch.lap();
}

const Eigen::MatrixXd& Sequence::State::gramMatrix() {
  if (gram.size() == 0) gram = shapeMotion->gram(diagonal);
  return gram;
}

Eigen::MatrixXd Sequence::State::columnsToPoses() const {
  const int count = columns().count();
  Eigen::MatrixXd map(count, shape.columns());
  for (int c = 0; c < count; ++c) {
    const PoseWeights w = poseWeights(Eigen::VectorXd::Unit(count, c), shape);
    map.row(c) = Eigen::Map<const Eigen::RowVectorXd>(w.column.data(), shape.columns());
  }
  return map;
}

Eigen::VectorXd Sequence::State::poseWeightsAt(double t) const {
  const PoseWeights w = poseWeights(curve->weights(curve->wrap(t).time), shape);
  return Eigen::Map<const Eigen::VectorXd>(w.column.data(), static_cast<Eigen::Index>(w.column.size()));
}

}  // namespace shapespline
