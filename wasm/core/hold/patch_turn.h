// How patches turn when a shape is pulled, and what turns them further: a limb bends then instead of shearing.
#pragma once

#include <array>
#include <vector>

#include "core/hold/hold_system.h"

namespace shapespline {

/// One step of as-rigid-as-possible deformation (Sorkine and Alexa 2007) with a rotation per patch instead of one per
/// vertex, over-relaxed. Immutable.
class PatchTurn {
 public:
  /// patchOfFace: -1 without area. The faces must outlive it.
  PatchTurn(const HoldMesh& mesh, const std::vector<int>& patchOfFace);

  using Scratch = std::vector<Mat3>;

  /// Adds what pulls the vertices of `shape` so that its patches turn as far as they did on the way to `pulled`, and
  /// further, to a right-hand side of the hold system. Nothing where nothing was pulled.
  void addTo(const Positions& shape, const Positions& pulled, const std::vector<int>& slot, Scratch& turn,
             std::vector<double>& xyzp) const;

 private:
  void findTurns(const Positions& shape, const Positions& pulled, Scratch& turn) const;

  const std::vector<Triangle>& faces_;
  std::vector<int> patchOf_;
  int patches_ = 0;
  std::vector<std::array<float, 3>> stiffness_;  // of the side opposite each corner
};

}  // namespace shapespline
