#include "core/sequence/encoded_shape.h"

#include <utility>

#include "core/base/stopwatch.h"
#include "core/sequence/mirrored_keys.h"
#include "core/sequence/weld_keys.h"

namespace shapespline {

Result<EncodedShape> EncodedShape::build(Keyframes keyframes, const EncodingOptions& options,
                                         const StageProgress& progress) {
  const Stage welding{progress, "welding"};
  Stopwatch watch;
  auto keys = weldKeys(std::move(keyframes), options, partOf(welding, 0, 0.6));
  if (!keys) return keys.error();
  EncodedShape encoded(std::move(*keys), options);
  encoded.stats_.weldedVertices = encoded.input().welding.count;
  encoded.stats_.weldMs = watch.lap();
  encoded.topology_ = topologyOf(encoded.shape(), partOf(welding, 0.6, 1));
  encoded.stats_.joinMs = watch.lap();
  encoded.stats_.components = encoded.topology_->solved.count;
  if (encoded.stats_.components == 0)
    return Error{ErrorCode::NoArea,
                 "No triangle has area in every key. Use poses in which the shape is not collapsed."};
  encoded.numberComponents();
  encoded.findMirroredKeys();
  return encoded;
}

Status EncodedShape::makeLri(const StageProgress& progress, OrderSource order) {
  if (lri_) return {};
  auto made = LriSpace::create(*keys_, *topology_, options_, progress, order);
  if (!made) return made.error();
  lri_ = std::make_unique<const LriSpace>(std::move(*made));
  topology_.reset();
  return {};
}

void EncodedShape::makeVertices() {
  if (!vertices_) vertices_.emplace(*keys_);
}

Status EncodedShape::checkStretches() const {
  if (!lri().ghostMotion() || options_.transfer != Transfer::Paper) return {};
  return Error{ErrorCode::InvalidOption,
               "Motions that rotate every face separately need the stretch of each face. The paper's transfer from a "
               "ghost mesh does not keep it. Choose the exact transfer, or no ghost mesh."};
}

Status EncodedShape::makeFaceSpace(Method method) {
  if (Status status = checkStretches(); !status) return status;
  if (method == Method::Rimd && !rimd_) rimd_ = std::make_unique<const RimdSpace>(*keys_, lri());
  if (method == Method::RotationStrain && !rotationStrain_)
    rotationStrain_ = std::make_unique<const RotationStrainSpace>(*keys_, lri());
  return {};
}

void EncodedShape::numberComponents() {
  const ShapeTopology& topology = *topology_;
  // A component that torn faces divide rotates with the part that comes first in the tree.
  std::vector<int> rank(topology.components.count), first(topology.solved.count, -1);
  for (int i = 0; i < topology.components.count; ++i) rank[topology.tree.order[i]] = i;
  topology.eachUsedFace([&](int f) {
    int& best = first[topology.solved.ofFace[f]];
    if (best < 0 || rank[topology.components.ofFace[f]] < rank[topology.components.ofFace[best]]) best = f;
  });
  const std::vector<int>& inputFaceOf = input().inputFaceOf;
  std::vector<int> faceOfInput(inputFaceOf.size()), number(inputFaceOf.size(), -1);
  for (std::size_t f = 0; f < inputFaceOf.size(); ++f) faceOfInput[inputFaceOf[f]] = static_cast<int>(f);
  for (const int face : faceOfInput) {
    const int component = topology.solved.ofFace[face];
    if (component >= 0 && number[component] < 0) {
      number[component] = static_cast<int>(firstFaceOf_.size());
      firstFaceOf_.push_back(first[component]);
    }
    componentOfInputFace_.push_back(component < 0 ? -1 : number[component]);
  }
}

void EncodedShape::findMirroredKeys() {
  for (int key : mirroredKeys(shape()))
    warnings_.push_back({"mirrored-key",
                         "is a mirror image of the surface in the other keys: its faces point "
                         "inwards, so no motion can reach it. Mirror it back with a negative scale, or remove the key.",
                         0,
                         key,
                         -1,
                         {},
                         "Key"});
}

std::vector<AddedTurns> EncodedShape::turnsOfPatchComponents(std::vector<AddedTurns> turns) const {
  for (AddedTurns& t : turns)
    if (t.component >= 0)
      t.component = lri().patches().coordinates().patches.componentOf[lri().patchOfFace()[firstFaceOf_[t.component]]];
  return turns;
}

PatchTurns EncodedShape::turnsOfPatches(std::vector<AddedTurns> turns) const {
  return lri().patches().addedTurns(lri().ledBy(), turnsOfPatchComponents(std::move(turns)));
}

BuildStats EncodedShape::stats() const {
  BuildStats stats = stats_;
  if (lri_) static_cast<LriStats&>(stats) = lri_->stats();
  return stats;
}

}  // namespace shapespline
