#include "core/patch_motion.h"

namespace shapespline {

Status PatchMotion::build(const WeldedShape& shape, PatchCoordinates coordinates, int rootPatch) {
  shape_ = &shape;
  patches_ = std::move(coordinates);
  const Patches& patches = patches_.patches;
  if (Status status = system_.build(patches, patches_.pairWeight, rootPatch); !status) return status;
  alignment_ = Alignment({patches, patches_.area, patches_.rotation, shape, system_.order(), system_.parent()});
  for (int k = 0; k < patches.count; ++k) {
    const auto piece = static_cast<std::size_t>(patches.pieceOf[k]);
    if (patchesOf_.size() <= piece) patchesOf_.resize(piece + 1);
    patchesOf_[piece].push_back(k);
  }
  return {};
}

// Each component keeps its rotation in its anchor face's R_f.
void PatchMotion::hangComponents(const PoseWeights& weights, std::vector<Quaternion>& rotation) const {
  for (const ComponentTurn& turn : patches_.turns) {
    const Quaternion anchor = rotation[turn.anchorPatch] * expQuaternion(blend(turn.anchorRotation, weights));
    const Quaternion wanted = anchor * expQuaternion(blend(turn.rotation, weights));
    const Quaternion by = wanted * rotation[turn.contactPatch].conjugate();
    for (int k : patchesOf_[turn.piece]) rotation[k] = (by * rotation[k]).normalized();
  }
}

void PatchMotion::unaligned(const Weights& weights, std::vector<Quaternion>& rotation) {
  const PoseWeights w = poseWeights(weights, *shape_);
  const std::size_t pairs = patches_.patches.pairs.size();
  pair_.assign(pairs, Vec3::Zero());
  for (int c = 0; c < shape_->columns(); ++c)
    for (std::size_t p = 0; p < pairs; ++p) pair_[p] += w.column[c] * patches_.pair[c][p];
  for (const Winding& winding : patches_.pairWinding) pair_[winding.index] += w.closing * winding.difference;
  system_.solve(pair_, rotation);
  hangComponents(w, rotation);
}

void PatchMotion::at(const Weights& weights, Frames& frames) {
  unaligned(weights, frames.rotation);
  frames.gradient.clear();
  const Quaternion turn = alignment_.at(weights, frames.rotation);
  for (Quaternion& g : frames.rotation) g = (turn * g).normalized();
}

}  // namespace shapespline
