#include "core/hold/patch_turn.h"

#include <algorithm>
#include <cmath>

#include "core/hold/fade.h"
#include "core/rotation/rotation.h"

namespace shapespline {

namespace {

// A solve without turns takes part of the way that patches would turn: so many times that, and never further than the
// most. A patch that seems to turn nearly half around says nothing.
constexpr double further = 3, mostTurn = 1.6, hardlyMeant = 1, notMeant = 2.6;  // radians
// Keeps a patch that is a line from spinning about itself, as a share of its size.
constexpr double patchInertia = 1e-3;

// What is left of a patch that is crushed says nothing either: of its extent in two directions, over what it was.
constexpr double crushed = 0.2, whole = 1;

double extent(const Mat3& m) { return (m.trace() * m.trace() - m.squaredNorm()) / 2; }

Mat3 furtherTurn(const Mat3& moved, const Mat3& before) {
  const Mat3 found = projectToRotation(moved + patchInertia * moved.norm() * Mat3::Identity());
  const Vec3 turn = logRotation(found);
  const double angle = turn.norm(), most = mostTurn / further;
  const double was = std::max(extent(before), 1e-300);
  const double meant =
      fade(extent(found.transpose() * moved), crushed * was, whole * was) * (1 - fade(angle, hardlyMeant, notMeant));
  return expRotation(meant * further / std::sqrt(1 + angle * angle / (most * most)) * turn);
}

}  // namespace

PatchTurn::PatchTurn(const HoldMesh& mesh, const std::vector<int>& patchOfFace)
    : faces_(mesh.shape.faces), patchOf_(patchOfFace) {
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    std::array<float, 3>& side = stiffness_.emplace_back();
    if (mesh.frameOf[f] < 0) patchOf_[f] = -1;
    if (patchOf_[f] < 0) continue;
    patches_ = std::max(patches_, patchOf_[f] + 1);
    for (int c = 0; c < 3; ++c) side[c] = static_cast<float>(sideStiffness(mesh, f, c));
  }
}

// Sum of area times gradient of `pulled` times that of `shape`, transposed, over each patch: what turns best.
void PatchTurn::findTurns(const Positions& shape, const Positions& pulled, Scratch& turn) const {
  turn.assign(2 * static_cast<std::size_t>(patches_), Mat3::Zero());  // and those of `shape` itself
  for (std::size_t f = 0; f < patchOf_.size(); ++f) {
    if (patchOf_[f] < 0) continue;
    const Triangle& t = faces_[f];
    for (int c = 0; c < 3; ++c) {
      const int i = t[(c + 1) % 3], j = t[(c + 2) % 3];
      const Vec3 from = static_cast<double>(stiffness_[f][c]) * (shape[i] - shape[j]);
      turn[patchOf_[f]].noalias() += (pulled[i] - pulled[j]) * from.transpose();
      turn[patches_ + patchOf_[f]].noalias() += (shape[i] - shape[j]) * from.transpose();
    }
  }
  for (int p = 0; p < patches_; ++p) turn[p] = furtherTurn(turn[p], turn[patches_ + p]) - Mat3::Identity();
}

void PatchTurn::addTo(const Positions& shape, const Positions& pulled, const std::vector<int>& slot, Scratch& turn,
                      std::vector<double>& xyzp) const {
  findTurns(shape, pulled, turn);
  for (std::size_t f = 0; f < patchOf_.size(); ++f) {
    if (patchOf_[f] < 0) continue;
    const Triangle& t = faces_[f];
    for (int c = 0; c < 3; ++c) {
      const int i = t[(c + 1) % 3], j = t[(c + 2) % 3];
      const Vec3 pull = static_cast<double>(stiffness_[f][c]) * (turn[patchOf_[f]] * (shape[i] - shape[j]));
      for (int k = 0; k < 3; ++k) {
        xyzp[4 * static_cast<std::size_t>(slot[i]) + k] += pull[k];
        xyzp[4 * static_cast<std::size_t>(slot[j]) + k] -= pull[k];
      }
    }
  }
}

}  // namespace shapespline
