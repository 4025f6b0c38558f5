#include "core/sequence/encoded_shape.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/base/format.h"
#include "core/base/stopwatch.h"
#include "core/sequence/mirrored_keys.h"

namespace shapespline {

Result<EncodedShape> EncodedShape::build(Keyframes keyframes, const EncodingOptions& options,
                                         const StageProgress& progress, OrderSource order) {
  const Stage welding{progress, "welding"}, factorising{progress, "factorising"};
  Stopwatch watch;
  const Positions normals = std::move(keyframes.normals);
  auto keys = weldKeys(std::move(keyframes), options, welding);
  if (!keys) return keys.error();
  EncodedShape encoded(std::move(*keys), options.stretch);
  encoded.stats_.weldMs = watch.lap();
  if (Status status = encoded.encodePoses(options, order, progress); !status) return status.error();
  watch.lap();
  encoded.prepareNormals(normals, partOf(factorising, 0.95, 0.97));
  factorising(0.97);
  encoded.describeGhost();
  encoded.numberComponents();
  encoded.collectWarnings(options.ghostFaces);
  encoded.stats_.finishMs = watch.lap();
  return encoded;
}

EncodedShape::EncodedShape(WeldedKeys keys, Stretch stretch)
    : input_(std::move(keys.input)),
      shape_(std::make_unique<const WeldedShape>(std::move(keys.shape))),
      diagonal_(keys.diagonal),
      stretch_(stretch) {
  stats_.weldedVertices = input_.welding.count;
}

Status EncodedShape::encodePoses(const EncodingOptions& options, OrderSource order, const StageProgress& progress) {
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
  return options.precision == Precision::Single ? makeReconstructor<float>(topology, options, order, progress)
                                                : makeReconstructor<double>(topology, options, order, progress);
}

template <class Real>
Status EncodedShape::makeReconstructor(const ShapeTopology& topology, const EncodingOptions& options, OrderSource order,
                                       const StageProgress& progress) {
  const Stage encoding{progress, "encoding"};
  Stopwatch watch;
  const FramePoses frames = framePoses();
  auto coordinates = encode<Real>(*shape_, topology, frames, options.stretch,
                                  ghost_ ? options.transfer : Transfer::Exact, partOf(encoding, ghost_ ? 0 : 0.7, 1));
  (ghost_ ? stats_.transferMs : stats_.encodeMs) += watch.lap();
  encoding(1);
  auto reconstructor = Reconstructor<Real>::create(
      {*shape_, topology, frames.ofFace, options.stretch, options.precision, order}, std::move(coordinates), progress);
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
