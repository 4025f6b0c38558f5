// Predicts the response of a shape to a pull at its pins without a solve, as if each pin moved by an affine field.
#pragma once

#include <span>
#include <vector>

#include "core/hold/hold_input.h"
#include "core/hold/hold_system.h"

namespace shapespline {

/// A pinned vertex and its stiffness.
struct HeldVertex {
  int vertex, pin;
  double weight;
  bool operator==(const HeldVertex&) const = default;
};

/// Immutable.
class AffineResponse {
 public:
  /// Solves the system for four modes per pin. held: vertices, grouped by pin.
  AffineResponse(const HoldInput& input, const HoldSystem& system, std::span<const HeldVertex> held, int pins);

  /// Fits an affine field to the displacements of each pin's vertices: four vectors per pin.
  void fit(std::span<const Vec3> displacement, std::vector<Vec3>& mode) const;

  /// Displacement of a held vertex.
  Vec3 moved(std::size_t held, const std::vector<Vec3>& mode) const;

  /// Mean gradient of the displacements over a patch, in the reference pose.
  Mat3 gradient(std::size_t patch, const std::vector<Vec3>& mode) const;

  /// Mean over a patch of the projections onto its faces' planes; zero without area.
  const std::vector<Mat3>& planes() const { return planes_; }

  /// Whether pulls rotate a patch so little, relative to other patches, that its rotation can be ignored.
  bool hardlyTurns(std::size_t patch) const { return little_[patch]; }

 private:
  void findFields(const Positions& reference);
  void addGradients(const HoldInput& input, const Positions& moved, std::size_t first);

  std::size_t modes_;
  std::vector<HeldVertex> held_;
  std::vector<double> field_;     // values of its pin's modes at each held vertex
  std::vector<double> fit_;       // contribution of each held vertex's displacement to its pin's modes
  std::vector<double> response_;  // displacement of each held vertex per mode
  std::vector<Mat3> planes_;
  std::vector<Vec3> gradient_;  // per patch and mode
  std::vector<char> little_;    // per patch
};

}  // namespace shapespline
