#include "core/space/lri_space.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/mesh/measures.h"
#include "core/space/vertex_space.h"

namespace shapespline {

namespace {

// Squared longest edge over twice the area. Single precision can miss the keys only with more slender triangles.
constexpr double slender = 100;
constexpr double maxMissed = 1e-5;  // share of the diagonal

bool hasNeedles(const WeldedShape& shape) {
  for (int j = 0; j < shape.keys; ++j)
    for (const Triangle& f : shape.faces) {
      const Positions& p = shape.poses[j];
      const Vec3 a = p[f[1]] - p[f[0]], b = p[f[2]] - p[f[0]];
      const double longest = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
      const double twiceArea = a.cross(b).norm();
      if (twiceArea > 0 && longest > slender * twiceArea) return true;
    }
  return false;
}

}  // namespace

Result<LriSpace> LriSpace::create(const WeldedKeys& keys, const ShapeTopology& topology, const LriOptions& options,
                                  const StageProgress& progress, OrderSource order) {
  LriSpace space(keys, options);
  if (Status status = space.encodePatchesOrGhost(topology, options, progress); !status) return status.error();
  Status made = options.precision == Precision::Single
                    ? space.makeReconstructor<float>(topology, options, order, progress)
                    : space.makeReconstructor<double>(topology, options, order, progress);
  if (made && options.precision == Precision::Single && hasNeedles(keys.shape) && space.missesKeys()) {
    LriOptions exact = options;
    exact.precision = Precision::Exact;
    space.reconstructor_.reset();
    made = space.makeReconstructor<double>(topology, exact, nullptr, progress);
  }
  if (!made) return made.error();
  const Stage factorising{progress, "factorising"};
  Stopwatch watch;
  std::vector<int> places;
  places.reserve(keys.input.welding.weldedOfRaw.size());
  for (int w : keys.input.welding.weldedOfRaw) places.push_back(space.slotOf()[w]);
  space.normals_.emplace(keys.input.faces, keys.shadingGroup, keys.shadingGroups, places,
                         partOf(factorising, 0.95, 0.97));
  factorising(0.97);
  space.describeGhost();
  space.collectWarnings(options.ghostFaces);
  space.stats_.finishMs = watch.lap();
  return space;
}

Status LriSpace::encodePatchesOrGhost(const ShapeTopology& topology, const LriOptions& options,
                                      const StageProgress& progress) {
  if (options.ghostFaces > 0 && options.ghostFaces < topology.usedFaces()) {
    auto ghost = GhostMotion::create(
        keys_->shape, topology,
        {options.ghostFaces, options.optimalPlacement, options.patches, options.stretch, options.transfer}, progress);
    if (!ghost) return ghost.error();
    ghost_ = std::move(*ghost);
    return {};
  }
  const Stage encoding{progress, "encoding"};
  Stopwatch watch;
  auto coordinates = encodePatches(keys_->shape, topology, options.patches, partOf(encoding, 0, 0.6));
  if (!coordinates) return coordinates.error();
  auto patches = PatchMotion::create(keys_->shape, std::move(*coordinates));
  if (!patches) return patches.error();
  patches_ = std::move(*patches);
  stats_.encodeMs += watch.lap();
  return {};
}

template <class Real>
Status LriSpace::makeReconstructor(const ShapeTopology& topology, const LriOptions& options, OrderSource order,
                                   const StageProgress& progress) {
  const Stage encoding{progress, "encoding"};
  Stopwatch watch;
  const LocalFramePoses frames = localFramePoses();
  auto coordinates = encode<Real>(keys_->shape, topology, frames, options.stretch,
                                  ghost_ ? options.transfer : Transfer::Exact, partOf(encoding, ghost_ ? 0 : 0.6, 1));
  (ghost_ ? stats_.transferMs : stats_.encodeMs) += watch.lap();
  encoding(1);
  auto reconstructor =
      Reconstructor<Real>::create({keys_->shape, topology, frames.ofFace, options.stretch, options.precision, order},
                                  std::move(coordinates), progress);
  if (!reconstructor) return reconstructor.error();
  stats_.orderMs = reconstructor->times().order;
  stats_.factorMs = reconstructor->times().factor;
  stats_.arrangeMs = reconstructor->times().arrange;
  const CholeskyStats solver = reconstructor->solverStats();
  stats_.factorBytes = solver.factorBytes + solver.indexBytes;
  reconstructor_.emplace(std::move(*reconstructor));
  // The shape has one set of coordinates and one system, and its patches have a system. A ghost adds one of each.
  stats_.encodings = ghost_ ? 2 : 1;
  stats_.factorisations = stats_.encodings + 1;
  return {};
}

// Whether some key is reconstructed worse than single precision promises. With a ghost and the paper's transfer, keys
// are missed in any precision.
bool LriSpace::missesKeys() const {
  if (ghost_) return false;
  const Columns columns{keys_->shape.keys};
  std::vector<const Positions*> keys;
  for (int j = 0; j < columns.keys; ++j) keys.push_back(&keys_->shape.poses[j]);
  const double most = maxMissed * boundingDiagonal(keys);
  Scratch scratch;
  LocalFrames frames;
  Positions positions;
  for (int j = 0; j < columns.keys; ++j) {
    const CurvePoint point = blendedPoint(Weights::Unit(columns.count(), j), columns);
    localFramesAt(point, {}, scratch, frames);
    withReconstructor([&]<class Real>(const Reconstructor<Real>& r) {
      typename Reconstructor<Real>::Scratch own;
      r.reconstruct(point, frames, own, own.padded);
      r.positionsOf(own.padded, positions);
    });
    for (std::size_t v = 0; v < positions.size(); ++v)
      if (!((positions[v] - (*keys[j])[v]).norm() <= most)) return true;
  }
  return false;
}

void LriSpace::describeGhost() {
  const InputMesh& input = keys_->input;
  patchOfFace_ = patches().coordinates().patches.ofFace;
  if (ghost_) {
    const std::vector<int> patchOfGhostFace = std::move(patchOfFace_);
    patchOfFace_.clear();
    for (int c : ghost_->correspondence()) patchOfFace_.push_back(c >= 0 ? patchOfGhostFace[c] : -1);
    const GhostMesh& mesh = ghost_->mesh();
    ghostOfInput_.faces = mesh.faces;
    if (input.mirrored)
      for (Triangle& t : ghostOfInput_.faces) std::swap(t[1], t[2]);
    for (int v : mesh.vertexOf) ghostOfInput_.vertexOf.push_back(input.welding.rawOfWelded[v]);
    for (int w : input.welding.weldedOfRaw) ghostOfInput_.ghostVertexOf.push_back(mesh.ghostOf[w]);
    ghostOfInput_.ghostFaceOf = input.ofInputFaces(ghost_->correspondence());
    stats_.ghostFaces = ghost_->shape().faceCount();
    stats_.ghostVertices = ghost_->shape().vertexCount();
    stats_.joinedComponents = mesh.joinedComponents;
    stats_.simplifyMs = ghost_->times().simplify;
    stats_.encodeMs += ghost_->times().encode;
    stats_.transferMs += ghost_->times().match;
  }
  patchOfInputFace_ = input.ofInputFaces(patchOfFace_);
  stats_.patches = patches().coordinates().patches.count;
}

void LriSpace::collectWarnings(int wantedGhostFaces) {
  if (wantedGhostFaces > 0 && stats_.ghostFaces == 0)
    warnings_.push_back(
        {"ghost-off", "The shape has no more faces than the requested ghost mesh, so no ghost mesh is used."});
  if (stats_.ghostFaces > wantedGhostFaces)
    warnings_.push_back({"ghost-too-large",
                         "The ghost mesh is finer than requested. A coarser ghost mesh would flip faces or change the "
                         "topology.",
                         stats_.ghostFaces});
  if (stats_.joinedComponents > 0)
    warnings_.push_back({"ghost-joined-parts",
                         "Some components are too small to get faces of the ghost mesh, so they follow their "
                         "neighbours. Give the ghost mesh more faces.",
                         stats_.joinedComponents});
  if (const int pivots = withReconstructor([](const auto& r) { return r.solverStats().regularisedPivots; }); pivots > 0)
    warnings_.push_back(
        {"regularised", "The mesh has very thin triangles. Some of their vertices may be misplaced.", pivots});
}

void LriSpace::localFramesAt(const CurvePoint& point, const PatchTurns& turns, Scratch& scratch,
                             LocalFrames& frames) const {
  if (ghost_) ghost_->at(point, turns, scratch.ghost, frames);
  else patches_->at(point, turns, scratch.patches, frames);
}

HoldInput LriSpace::holdInput() const {
  return withReconstructor([&]<class Real>(const Reconstructor<Real>& r) {
    const LriCoordinates<Real>& lri = r.coordinates();
    const LocalFramePoses frames = localFramePoses();
    return HoldInput{{keys_->shape, frames.ofFace, lri.joints, lri.loose},
                     patchOfFace_,
                     frames.rotation,
                     std::is_same_v<Real, float> ? Precision::Single : Precision::Double};
  });
}

const std::vector<int>& LriSpace::slotOf() const {
  return withReconstructor([](const auto& r) -> const std::vector<int>& { return r.slotOf(); });
}

const std::vector<AmbiguousFaces>& LriSpace::ambiguousFaces() const {
  return withReconstructor(
      [](const auto& r) -> const std::vector<AmbiguousFaces>& { return r.coordinates().ambiguous; });
}

Eigen::MatrixXd LriSpace::gramMatrix() const {
  return shapespline::gramMatrix(poseCoordinates(), ledBy(), keys_->diagonal);
}

PoseCoordinates LriSpace::poseCoordinates() const {
  if (ghost_) return coordinatesOf(ghost_->patches().coordinates(), ghost_->coordinates());
  return withReconstructor([&](const auto& r) { return coordinatesOf(patches_->coordinates(), r.coordinates()); });
}

ShapeProducts LriSpace::productsOf(const Positions& positions, const Eigen::VectorXd& weights) const {
  const PoseCoordinates poses = poseCoordinates();
  const ShapeCoordinates shape =
      encodeShape(poses, ledBy(), stretch_, weights, ghost_ ? ghostOf(positions, weights) : positions);
  const Eigen::MatrixXd gram = shapespline::gramMatrix(poses, ledBy(), keys_->diagonal, &shape);
  const int columns = ledBy().columns();
  return {gram.col(columns).head(columns), gram(columns, columns)};
}

// A ghost vertex deviates from its blend as its shape vertex does.
Positions LriSpace::ghostOf(const Positions& positions, const Eigen::VectorXd& weights) const {
  const std::span<const double> w(weights.data(), static_cast<std::size_t>(weights.size()));
  Positions blend, ghost;
  blendVertices(keys_->shape, w, blend);
  blendVertices(ghost_->shape(), w, ghost);
  const std::vector<int>& vertexOf = ghost_->mesh().vertexOf;
  for (std::size_t v = 0; v < ghost.size(); ++v) ghost[v] += positions[vertexOf[v]] - blend[vertexOf[v]];
  return ghost;
}

Eigen::MatrixXd LriSpace::faceColumns(int inputFace) const {
  const std::vector<int>& inputFaceOf = keys_->input.inputFaceOf;
  const auto found = std::find(inputFaceOf.begin(), inputFaceOf.end(), inputFace);
  assert(found != inputFaceOf.end() && patchOfInputFace_[inputFace] >= 0);
  return weldedFaceColumns(static_cast<int>(found - inputFaceOf.begin()));
}

Eigen::MatrixXd LriSpace::weldedFaceColumns(int face) const {
  return withReconstructor([&](const auto& r) {
    const int columns = keys_->shape.columns();
    Eigen::MatrixXd numbers(numbersPerFace, columns);
    for (int c = 0; c < columns; ++c)
      for (int k = 0; k < numbersPerFace; ++k) numbers(k, c) = static_cast<double>(r.coordinates().face.at(face, c, k));
    return numbers;
  });
}

Eigen::VectorXd LriSpace::patchStretch(int patch) const {
  const WeldedShape& shape = keys_->shape;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(shape.columns());
  double total = 0;
  for (int face = 0; face < shape.faceCount(); ++face) {
    if (patchOfFace_[face] != patch) continue;
    const double area = referenceFrame(shape, face).area;
    const Eigen::MatrixXd numbers = weldedFaceColumns(face);
    for (int c = 0; c < shape.columns(); ++c) sum[c] += area / 2 * (numbers(3, c) + numbers(5, c));
    total += area;
  }
  return sum / total;
}

}  // namespace shapespline
