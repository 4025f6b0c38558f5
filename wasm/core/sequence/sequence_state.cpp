#include "core/sequence/sequence_state.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/canonical_order.h"
#include "core/sequence/gram_matrix.h"
#include "core/sequence/mirrored_keys.h"
#include "core/sequence/turn_warnings.h"

namespace shapespline {

namespace {

// Poses closer than this, over the diagonal, are the same up to rounding and a modeller's noise.
constexpr double samePose = 1e-4;

Vec3 meanPosition(const Positions& positions) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : positions) sum += p;
  return sum / static_cast<double>(positions.size());
}

bool moves(const RigidMotion& motion) { return motion.rotation.w() != 1 || motion.translation != Vec3::Zero(); }

bool isLinear(Method method) { return method == Method::Geodesic || method == Method::Linear; }

}  // namespace

std::vector<double> timesOf(const Keyframes& keyframes) {
  std::vector<double> times;
  for (const Key& key : keyframes.keys) times.push_back(key.time);
  return times;
}

bool blendsVertices(Method method) { return method == Method::Linear || method == Method::CubicVertex; }

void blendVertices(const WeldedShape& shape, const CurvePoint& point, Positions& out) {
  const PoseWeights w = poseWeights(point, shape);
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
  for (const Positions* pose : poses) diagonal = std::max(diagonal, boundingDiagonal({&pose, 1}));
  welding = weld(poses, weldTolerances(poses), partOf(onProgress, 0, 0.5));
  shape.faces = weldFaces(raw.faces, welding);
  for (const Positions* pose : poses) shape.poses.push_back(weldPositions(*pose, welding));
  findClosing();
  orderShape(partOf(onProgress, 0.55, 1));
}

void Sequence::State::orderShape(const FractionReport& onProgress) {
  // Where a loop's last key is its first one again, it must not count twice: any key could be the first.
  Positions repeated;
  const auto last = shape.poses.begin() + (shape.keys - 1);
  if (shape.closing) repeated = std::move(*last), shape.poses.erase(last);
  const MeshOrder order = canonicalOrder(shape.faces, shape.poses, onProgress);
  if (shape.closing) shape.poses.insert(shape.poses.begin() + (shape.keys - 1), std::move(repeated));
  shape.faces = order.apply(shape.faces);
  for (Positions& pose : shape.poses) pose = order.apply(pose);
  welding = order.apply(welding);
  rawOfFace = order.oldFaces();
}

std::vector<int> Sequence::State::ofRawFaces(const std::vector<int>& ofFaces) const {
  std::vector<int> result(ofFaces.size());
  for (std::size_t f = 0; f < ofFaces.size(); ++f) result[rawOfFace[f]] = ofFaces[f];
  return result;
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
  const Positions &first = shape.poses.front(), &last = shape.poses[shape.keys - 1];
  const RigidFit fit = fitRigid(first, last);
  if (fit.largestDistance > samePose * diagonal) return;
  const Quaternion rotation(fit.rotation);
  shape.closing = {rotation, meanPosition(last) - rotation * meanPosition(first)};
}

CurveOptions Sequence::State::curveOptions(const MotionOptions& o) const {
  return {.linear = isLinear(o.method),
          .boundary = o.boundary,
          .startSpeed = o.startSpeed,
          .endSpeed = o.endSpeed,
          .startShape = shape.startTangent >= 0,
          .endShape = shape.endTangent >= 0,
          .closing = shape.closing ? Closing::LastKey : Closing::Extra,
          .period = o.period,
          .tension = o.tension,
          .bias = o.bias};
}

void Sequence::State::findMirroredKeys() {
  for (int key : mirroredKeys(shape))
    shapeWarnings.push_back({"mirrored-key",
                             "Key " + std::to_string(key + 1) + " is a mirror image of the surface in the other keys: its faces look "
                             "inwards, and no motion leads there. Mirror it back (a negative scale does that), or leave it out.",
                             0, key, -1, {}});
}

void Sequence::State::collectWarnings() {
  const bool closes = motion.boundary == BoundaryKind::Periodic && !curve->closesOnLastKey();
  warnings = shapeWarnings;
  if (!blendsVertices(motion.method))
    for (Warning& w : turnWarnings(shape, shapeMotion->patchMotion(), shapeMotion->ambiguousFaces(), shapeMotion->patchOfFace(), turnsOfPatchPieces(), closes)) {
      if (w.face >= 0) w.face = rawOfFace[w.face];
      warnings.push_back(std::move(w));
    }
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

void Sequence::State::numberComponents() {
  const std::vector<int>& pieceOfFace = shapeMotion->componentOfFace();
  std::vector<int> faceOfRaw(rawOfFace.size()), number(rawOfFace.size(), -1);
  for (std::size_t f = 0; f < rawOfFace.size(); ++f) faceOfRaw[rawOfFace[f]] = static_cast<int>(f);
  for (const int face : faceOfRaw) {
    const int piece = pieceOfFace[face];
    if (piece >= 0 && number[piece] < 0) {
      number[piece] = static_cast<int>(firstFaceOf.size());
      firstFaceOf.push_back(face);
    }
    componentOfRawFace.push_back(piece < 0 ? -1 : number[piece]);
  }
}

// With a ghost the patches are its own, and so are the pieces that they are in.
std::vector<AddedTurns> Sequence::State::turnsOfPatchPieces() const {
  std::vector<AddedTurns> turns = motion.turns;
  for (AddedTurns& t : turns)
    if (t.component >= 0)
      t.component = shapeMotion->patchMotion().coordinates().patches.pieceOf[shapeMotion->patchOfFace()[firstFaceOf[t.component]]];
  return turns;
}

void Sequence::State::describeGhost() {
  const GhostMotion* motion = shapeMotion->ghost();
  if (!motion) return;
  const GhostMesh& mesh = motion->mesh();
  ghost.faces = mesh.faces;
  for (int v : mesh.vertexOf) ghost.vertexOf.push_back(welding.rawOfWelded[v]);
  for (int w : welding.weldedOfRaw) ghost.ghostVertexOf.push_back(mesh.ghostOf[w]);
  ghost.ghostFaceOf = ofRawFaces(motion->correspondence());
}

// What the shape is moved by after its reconstruction. Every period of a loop that ends elsewhere is one more of the rigid motion that
// takes the first key to the last; so are the keys of other periods that the curve feels.
RigidMotion Sequence::State::globalMotion(double t, const WrappedTime& wrapped, const CurvePoint& point) const {
  RigidMotion global;
  const auto& mean = shapeMotion->meanPosition();
  if (curve->closesOnLastKey()) {
    for (const KeyWeight& k : point.unrolled)
      if (k.period != 0) global.translation += k.weight * (shape.closing->power(k.period)(mean[k.key]) - mean[k.key]);
    double exponent = wrapped.periods;
    if (motion.inPlace) exponent -= (t - curve->start()) / (curve->end() - curve->start());
    const RigidMotion further = shape.closing->power(exponent);
    return {further.rotation, further(global.translation)};
  }
  if (motion.inPlace && !curve->periodic()) {
    const double span = raw.keys.back().time - raw.keys.front().time;
    global.translation -= (t - raw.keys.front().time) / span * (mean[shape.keys - 1] - mean[0]);
  }
  return global;
}

int Sequence::State::weldedShape(const CurvePoint& point, Positions& out) {
  if (blendsVertices(motion.method)) return blendVertices(shape, point, out), 0;
  ++stats.solves;
  return shapeMotion->at(point, out);
}

// Leaves the shape in `placed`.
int Sequence::State::placedShape(const CurvePoint& point) {
  if (!blendsVertices(motion.method)) {
    ++stats.solves;
    return shapeMotion->at(point, placed, stats, crew);
  }
  stats.framesMs = stats.facesMs = stats.solveMs = stats.placeMs = 0;
  blendVertices(shape, point, weldedPositions);
  placed.move = Vec3::Zero();
  placed.places.resize(4 * weldedPositions.size());
  for (std::size_t v = 0; v < weldedPositions.size(); ++v)
    for (int k = 0; k < 3; ++k)
      placed.places[4 * static_cast<std::size_t>(shapeMotion->placeOf()[v]) + k] = static_cast<float>(weldedPositions[v][k]);
  return 0;
}

void Sequence::State::fill(const CurvePoint& point, const RigidMotion& global, Positions& positions) {
  weldedShape(point, weldedPositions);
  if (moves(global))
    for (Vec3& p : weldedPositions) p = global(p);
  positions.resize(welding.weldedOfRaw.size());
  for (std::size_t v = 0; v < positions.size(); ++v) positions[v] = weldedPositions[welding.weldedOfRaw[v]];
}

void Sequence::State::fill(const CurvePoint& point, const RigidMotion& global, Frame& frame) {
  frame.lostDefiniteness = placedShape(point);
  frame.lostFace = frame.lostDefiniteness > 0 ? rawOfFace[stats.indefiniteFace] : -1;
  finish(global, frame);
}

// From `placed` to what is drawn.
void Sequence::State::finish(const RigidMotion& global, Frame& frame) {
  Stopwatch watch;
  std::vector<float>& places = placed.places;
  if (moves(global)) {
    for (std::size_t i = 0; i < places.size(); i += 4) {
      const Vec3 p = global(Vec3(places[i], places[i + 1], places[i + 2]) + placed.move);
      for (int k = 0; k < 3; ++k) places[i + k] = static_cast<float>(p[k]);
    }
    placed.move = Vec3::Zero();
  }
  stats.placeMs += watch.lap();
  shading.draw(places, placed.move, frame.positions, frame.normals, crew);
  stats.normalsMs = watch.lap();
}

// Over the raw vertices, which are what is seen.
PreviewError Sequence::State::distance(const PlacedShape<float>& exact, const PlacedShape<float>& about) const {
  const auto at = [](const PlacedShape<float>& shape, int place) -> Vec3 {
    const float* p = &shape.places[4 * static_cast<std::size_t>(place)];
    return Vec3(p[0], p[1], p[2]) + shape.move;
  };
  PreviewError error;
  for (int w : welding.weldedOfRaw) {
    const int place = shapeMotion->placeOf()[w];
    const double distance = (at(exact, place) - at(about, place)).norm();
    error.mean += distance / static_cast<double>(welding.weldedOfRaw.size());
    error.largest = std::max(error.largest, distance);
  }
  const Positions* reference = &shape.poses[shape.reference];
  const double size = boundingDiagonal({&reference, 1});
  return {error.mean / size, error.largest / size};
}

const Eigen::MatrixXd& Sequence::State::gramMatrix() {
  if (gram.size() == 0) gram = shapeMotion->gram(diagonal);
  return gram;
}

Eigen::MatrixXd Sequence::State::columnsToPoses() const {
  const int count = columns().count();
  Eigen::MatrixXd map(count, shape.columns());
  for (int c = 0; c < count; ++c) {
    const PoseWeights w = poseWeights(blendedPoint(Eigen::VectorXd::Unit(count, c), columns()), shape);
    map.row(c) = Eigen::Map<const Eigen::RowVectorXd>(w.column.data(), shape.columns());
  }
  return map;
}

Eigen::VectorXd Sequence::State::poseWeightsAt(double t) const {
  const PoseWeights w = poseWeights(curve->at(curve->wrap(t).time), shape);
  return Eigen::Map<const Eigen::VectorXd>(w.column.data(), static_cast<Eigen::Index>(w.column.size()));
}

}  // namespace shapespline
