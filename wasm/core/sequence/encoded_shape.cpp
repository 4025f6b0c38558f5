#include "core/sequence/encoded_shape.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/base/centroid.h"
#include "core/base/format.h"
#include "core/base/stopwatch.h"
#include "core/mesh/canonical_order.h"
#include "core/rotation/rigid_fit.h"
#include "core/sequence/mirrored_keys.h"

namespace shapespline {

namespace {

constexpr int leastGhostFaces = 4;
// Poses closer than this, over the diagonal, are the same up to rounding and a modeller's noise.
constexpr double samePose = 1e-4;

Status checkEncoding(const EncodingOptions& o, const Keyframes& k) {
  const auto invalid = [](std::string message) { return Error{ErrorCode::InvalidOption, std::move(message)}; };
  if (o.reference < 0 || o.reference >= k.keyCount())
    return invalid("The reference is key " + std::to_string(o.reference + 1) + ", but there are " +
                   std::to_string(k.keyCount()) + " keys.");
  if (o.patches < 0)
    return invalid("The number of patches is " + grouped(o.patches) + ". Use 0 for the default, or a positive number.");
  if (o.ghostFaces < 0 || (o.ghostFaces > 0 && o.ghostFaces < leastGhostFaces))
    return invalid("A ghost mesh needs at least " + std::to_string(leastGhostFaces) + " faces, but " +
                   grouped(o.ghostFaces) + " are asked for. Use 0 to work without one.");
  for (const auto* tangent : {&o.startTangent, &o.endTangent}) {
    if (!*tangent) continue;
    if (static_cast<int>((*tangent)->size()) != k.vertexCount())
      return Error{ErrorCode::VertexCountMismatch,
                   "A tangent shape has " + grouped(static_cast<std::int64_t>((*tangent)->size())) +
                       " vertices, but the keys have " + grouped(k.vertexCount()) + ". Use a pose of the same mesh."};
    for (std::size_t v = 0; v < (*tangent)->size(); ++v)
      if (!(**tangent)[v].allFinite())
        return Error{ErrorCode::NotFinite,
                     "A tangent shape's vertex " + grouped(static_cast<std::int64_t>(v)) + " is not finite.", -1,
                     static_cast<int>(v)};
  }
  return {};
}

// The motion that takes the first key to the last, where it takes all of it there.
std::optional<RigidMotion> closingOf(const WeldedShape& shape, double diagonal) {
  const Positions &first = shape.poses.front(), &last = shape.poses[shape.keys - 1];
  const RigidFit fit = fitRigid(first, last);
  if (fit.largestDistance > samePose * diagonal) return {};
  const Quaternion rotation(fit.rotation);
  return RigidMotion{rotation, centroidOf(last) - rotation * centroidOf(first)};
}

// Puts the welded mesh into its canonical order.
void putInOrder(WeldedShape& shape, InputMesh& input, const FractionReport& onProgress) {
  // Where a loop's last key is its first one again, it must not count twice: any key could be the first.
  Positions repeated;
  const auto last = shape.poses.begin() + (shape.keys - 1);
  if (shape.closing) repeated = std::move(*last), shape.poses.erase(last);
  const MeshOrder order = canonicalOrder(shape.faces, shape.poses, onProgress);
  if (shape.closing) shape.poses.insert(shape.poses.begin() + (shape.keys - 1), std::move(repeated));
  shape.faces = order.apply(shape.faces);
  for (Positions& pose : shape.poses) pose = order.apply(pose);
  input.welding = order.apply(input.welding);
  input.inputFaceOf = order.oldFaces();
}

}  // namespace

Result<EncodedShape> EncodedShape::build(Keyframes keyframes, const EncodingOptions& options,
                                         const StageProgress& progress) {
  const Stage welding{progress, "welding"}, factorising{progress, "factorising"};
  welding(0);
  if (Status status = validate(keyframes); !status) return status.error();
  if (Status status = checkEncoding(options, keyframes); !status) return status.error();
  EncodedShape encoded;
  encoded.stretch_ = options.stretch;
  Stopwatch watch;
  const Positions normals = std::move(keyframes.normals);
  encoded.weldKeys(std::move(keyframes), options, welding);
  encoded.stats_.weldMs = watch.lap();
  welding(1);
  if (Status status = encoded.encodePoses(options, progress); !status) return status.error();
  watch.lap();
  encoded.prepareNormals(normals, partOf(factorising, 0.95, 0.97));
  factorising(0.97);
  encoded.describeGhost();
  encoded.numberComponents();
  encoded.collectWarnings(options.ghostFaces);
  encoded.stats_.finishMs = watch.lap();
  return encoded;
}

void EncodedShape::weldKeys(Keyframes keyframes, const EncodingOptions& options, const FractionReport& onProgress) {
  std::vector<const Positions*> poses;
  for (const Key& key : keyframes.keys) poses.push_back(&key.positions);
  WeldedShape shape;
  shape.keys = keyframes.keyCount();
  shape.reference = options.reference;
  if (options.startTangent)
    shape.startTangent = static_cast<int>(poses.size()), poses.push_back(&*options.startTangent);
  if (options.endTangent) shape.endTangent = static_cast<int>(poses.size()), poses.push_back(&*options.endTangent);
  for (const Positions* pose : poses) diagonal_ = std::max(diagonal_, boundingDiagonal({&pose, 1}));
  input_.faces = std::move(keyframes.faces);
  input_.welding = weld(poses, weldTolerances(poses), partOf(onProgress, 0, 0.5));
  shape.faces = weldFaces(input_.faces, input_.welding);
  for (const Positions* pose : poses) shape.poses.push_back(weldPositions(*pose, input_.welding));
  keyframes.keys.clear();  // what follows takes the most memory, and works on the welded poses
  shape.closing = closingOf(shape, diagonal_);
  putInOrder(shape, input_, partOf(onProgress, 0.55, 1));
  stats_.weldedVertices = input_.welding.count;
  shape_ = std::make_unique<const WeldedShape>(std::move(shape));
}

Status EncodedShape::encodePoses(const EncodingOptions& options, const StageProgress& progress) {
  const bool wantsGhost = options.ghostFaces > 0;
  const Stage simplifying{progress, "simplifying"}, encoding{progress, "encoding"};
  Stopwatch joining;
  const ShapeTopology topology = topologyOf(*shape_, wantsGhost ? partOf(simplifying, 0, 0) : partOf(encoding, 0, 0.2));
  stats_.joinMs = joining.lap();
  if (topology.components.count == 0)
    return Error{ErrorCode::NoArea,
                 "No triangle has area in every key. Use poses in which the shape is not collapsed."};
  stats_.components = topology.components.count;
  const auto usedFaces = std::count(topology.hasArea.begin(), topology.hasArea.end(), 1);
  if (wantsGhost && options.ghostFaces < usedFaces) {
    auto ghost = GhostMotion::create(
        *shape_, topology,
        {options.ghostFaces, options.optimalPlacement, options.patches, options.stretch, options.transfer}, progress);
    if (!ghost) return ghost.error();
    ghost_ = std::move(*ghost);
  } else {
    Stopwatch watch;
    auto coordinates = encodePatches(*shape_, topology, options.patches, partOf(encoding, 0.2, 0.7));
    if (!coordinates) return coordinates.error();
    auto patches = PatchMotion::create(*shape_, std::move(*coordinates));
    if (!patches) return patches.error();
    patches_ = std::move(*patches);
    stats_.encodeMs += watch.lap();
  }
  return options.precision == Precision::Single ? makeReconstructor<float>(topology, options, progress)
                                                : makeReconstructor<double>(topology, options, progress);
}

template <class Real>
Status EncodedShape::makeReconstructor(const ShapeTopology& topology, const EncodingOptions& options,
                                       const StageProgress& progress) {
  const Stage encoding{progress, "encoding"};
  Stopwatch watch;
  const FramePoses frames = framePoses();
  auto coordinates = encode<Real>(*shape_, topology, frames, options.stretch,
                                  ghost_ ? options.transfer : Transfer::Exact, partOf(encoding, ghost_ ? 0 : 0.7, 1));
  (ghost_ ? stats_.transferMs : stats_.encodeMs) += watch.lap();
  encoding(1);
  auto reconstructor = Reconstructor<Real>::create(
      {*shape_, topology, frames.ofFace, options.stretch, options.precision}, std::move(coordinates), progress);
  if (!reconstructor) return reconstructor.error();
  stats_.orderMs = reconstructor->times().order;
  stats_.factorMs = reconstructor->times().factor;
  stats_.arrangeMs = reconstructor->times().arrange;
  const CholeskyStats solver = reconstructor->solverStats();
  stats_.factorBytes = solver.factorBytes + solver.indexBytes;
  reconstructor_.emplace(std::move(*reconstructor));
  // One of the shape's own coordinates and systems, and one more of a ghost's; one system of its patches.
  stats_.encodings = ghost_ ? 2 : 1;
  stats_.factorisations = stats_.encodings + 1;
  return {};
}

void EncodedShape::prepareNormals(const Positions& keyNormals, const FractionReport& onProgress) {
  const bool given = keyNormals.size() == static_cast<std::size_t>(input_.vertexCount());
  int groups = 0;
  const std::vector<int> group = shadingGroups(input_.welding, given ? keyNormals : Positions(), groups);
  std::vector<int> places;
  places.reserve(input_.welding.weldedOfRaw.size());
  reportFraction(onProgress, 0.1);
  for (int w : input_.welding.weldedOfRaw) places.push_back(placeOf()[w]);
  normals_.emplace(input_.faces, group, groups, places, partOf(onProgress, 0.2, 1));
}

void EncodedShape::describeGhost() {
  patchOfFace_ = patches().coordinates().patches.ofFace;
  if (ghost_) {
    const std::vector<int> patchOfGhostFace = std::move(patchOfFace_);
    patchOfFace_.clear();
    for (int c : ghost_->correspondence()) patchOfFace_.push_back(c >= 0 ? patchOfGhostFace[c] : -1);
    const GhostMesh& mesh = ghost_->mesh();
    ghostOfInput_.faces = mesh.faces;
    for (int v : mesh.vertexOf) ghostOfInput_.vertexOf.push_back(input_.welding.rawOfWelded[v]);
    for (int w : input_.welding.weldedOfRaw) ghostOfInput_.ghostVertexOf.push_back(mesh.ghostOf[w]);
    ghostOfInput_.ghostFaceOf = input_.ofInputFaces(ghost_->correspondence());
    stats_.ghostFaces = ghost_->shape().faceCount();
    stats_.ghostVertices = ghost_->shape().vertexCount();
    stats_.joinedComponents = mesh.joinedComponents;
    stats_.simplifyMs = ghost_->times().simplify;
    stats_.encodeMs += ghost_->times().encode;
    stats_.transferMs += ghost_->times().match;
  }
  patchOfInputFace_ = input_.ofInputFaces(patchOfFace_);
  stats_.patches = patches().coordinates().patches.count;
}

void EncodedShape::numberComponents() {
  const std::vector<int>& componentOfFace =
      withReconstructor([](const auto& r) -> const std::vector<int>& { return r.componentOfFace(); });
  const std::vector<int>& inputFaceOf = input_.inputFaceOf;
  std::vector<int> faceOfInput(inputFaceOf.size()), number(inputFaceOf.size(), -1);
  for (std::size_t f = 0; f < inputFaceOf.size(); ++f) faceOfInput[inputFaceOf[f]] = static_cast<int>(f);
  for (const int face : faceOfInput) {
    const int component = componentOfFace[face];
    if (component >= 0 && number[component] < 0) {
      number[component] = static_cast<int>(firstFaceOf_.size());
      firstFaceOf_.push_back(face);
    }
    componentOfInputFace_.push_back(component < 0 ? -1 : number[component]);
  }
}

void EncodedShape::collectWarnings(int wantedGhostFaces) {
  for (int key : mirroredKeys(*shape_))
    warnings_.push_back(
        {"mirrored-key",
         "Key " + std::to_string(key + 1) +
             " is a mirror image of the surface in the other keys: its faces point "
             "inwards, and no motion leads there. Mirror it back (a negative scale does that), or leave it out.",
         0,
         key,
         -1,
         {}});
  if (wantedGhostFaces > 0 && stats_.ghostFaces == 0)
    warnings_.push_back(
        {"ghost-off", "The shape has no more faces than were asked for the ghost mesh: it moves without one."});
  if (stats_.ghostFaces > wantedGhostFaces)
    warnings_.push_back({"ghost-too-large",
                         "The ghost mesh could not be made as coarse as asked for without turning faces over "
                         "or changing the topology.",
                         stats_.ghostFaces});
  if (stats_.joinedComponents > 0)
    warnings_.push_back({"ghost-joined-parts",
                         "Some components are too small for a share of the ghost mesh's faces: they follow their "
                         "neighbours. Give the ghost mesh more faces.",
                         stats_.joinedComponents});
  if (const int pivots = withReconstructor([](const auto& r) { return r.solverStats().regularisedPivots; }); pivots > 0)
    warnings_.push_back(
        {"regularised", "The mesh has triangles so thin that the solver had to fix some of their vertices.", pivots});
}

void EncodedShape::framesAt(const CurvePoint& point, const PatchTurns& turns, FramesScratch& scratch,
                            Frames& frames) const {
  if (ghost_) ghost_->at(point, turns, scratch.ghost, frames);
  else patches_->at(point, turns, scratch.patches, frames);
}

HoldInput EncodedShape::holdInput() const {
  return withReconstructor([&]<class Real>(const Reconstructor<Real>& r) {
    const LriCoordinates<Real>& lri = r.coordinates();
    const FramePoses frames = framePoses();
    return HoldInput{{*shape_, frames.ofFace, lri.places, lri.loose},
                     patchOfFace_,
                     frames.rotation,
                     std::is_same_v<Real, float> ? Precision::Single : Precision::Double};
  });
}

const std::vector<Vec3>& EncodedShape::meanPosition() const {
  return withReconstructor([](const auto& r) -> const std::vector<Vec3>& { return r.coordinates().meanPosition; });
}

const std::vector<int>& EncodedShape::placeOf() const {
  return withReconstructor([](const auto& r) -> const std::vector<int>& { return r.placeOf(); });
}

const std::vector<AmbiguousFaces>& EncodedShape::ambiguousFaces() const {
  return withReconstructor(
      [](const auto& r) -> const std::vector<AmbiguousFaces>& { return r.coordinates().ambiguous; });
}

std::vector<AddedTurns> EncodedShape::turnsOfPatchComponents(std::vector<AddedTurns> turns) const {
  for (AddedTurns& t : turns)
    if (t.component >= 0)
      t.component = patches().coordinates().patches.componentOf[patchOfFace_[firstFaceOf_[t.component]]];
  return turns;
}

PatchTurns EncodedShape::turnsOfPatches(std::vector<AddedTurns> turns) const {
  return patches().addedTurns(ghost_ ? ghost_->shape() : *shape_, turnsOfPatchComponents(std::move(turns)));
}

Eigen::MatrixXd EncodedShape::gramMatrix() const {
  if (ghost_) return shapespline::gramMatrix(poseCoordinates(), ghost_->shape(), diagonal_);
  return shapespline::gramMatrix(poseCoordinates(), *shape_, diagonal_);
}

PoseCoordinates EncodedShape::poseCoordinates() const {
  if (ghost_) return coordinatesOf(ghost_->patches().coordinates(), ghost_->coordinates());
  return withReconstructor([&](const auto& r) { return coordinatesOf(patches_->coordinates(), r.coordinates()); });
}

ShapeProducts EncodedShape::vertexBlendProducts(const Eigen::VectorXd& weights) const {
  const WeldedShape& shape = ghost_ ? ghost_->shape() : *shape_;
  const PoseCoordinates poses = poseCoordinates();
  const ShapeCoordinates blend = encodeVertexBlend(poses, shape, stretch_, weights);
  const Eigen::MatrixXd gram = shapespline::gramMatrix(poses, shape, diagonal_, &blend);
  return {gram.col(shape.columns()).head(shape.columns()), gram(shape.columns(), shape.columns())};
}

Eigen::MatrixXd EncodedShape::faceColumns(int inputFace) const {
  const auto found = std::find(input_.inputFaceOf.begin(), input_.inputFaceOf.end(), inputFace);
  assert(found != input_.inputFaceOf.end() && patchOfInputFace_[inputFace] >= 0);
  return weldedFaceColumns(static_cast<int>(found - input_.inputFaceOf.begin()));
}

Eigen::MatrixXd EncodedShape::weldedFaceColumns(int face) const {
  return withReconstructor([&](const auto& r) {
    Eigen::MatrixXd numbers(numbersPerFace, shape_->columns());
    for (int c = 0; c < shape_->columns(); ++c)
      for (int k = 0; k < numbersPerFace; ++k) numbers(k, c) = static_cast<double>(r.coordinates().face.at(face, c, k));
    return numbers;
  });
}

Eigen::VectorXd EncodedShape::patchStretch(int patch) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(shape_->columns());
  double total = 0;
  for (int face = 0; face < shape_->faceCount(); ++face) {
    if (patchOfFace_[face] != patch) continue;
    const double area = referenceFrame(*shape_, face).area;
    const Eigen::MatrixXd numbers = weldedFaceColumns(face);
    for (int c = 0; c < shape_->columns(); ++c) sum[c] += area / 2 * (numbers(3, c) + numbers(5, c));
    total += area;
  }
  return sum / total;
}

}  // namespace shapespline
