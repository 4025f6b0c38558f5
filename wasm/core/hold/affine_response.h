// The response of a shape to a pull at its pins, predicted without a solve: as if each pin moved by an affine field.
#pragma once

#include <span>
#include <vector>

#include "core/hold/hold_input.h"
#include "core/hold/hold_system.h"

namespace shapespline {

/// One vertex that is held, and how firmly.
struct HeldVertex {
  int vertex, pin;
  double weight;
  bool operator==(const HeldVertex&) const = default;
};

/// Immutable.
class AffineResponse {
 public:
  /// Solves the system for four modes per pin. held: by pin.
  AffineResponse(const HoldInput& input, const HoldSystem& system, std::span<const HeldVertex> held, int pins);

  /// The affine fields nearest to the displacements of the held vertices: four vectors per pin.
  void fit(std::span<const Vec3> displacement, std::vector<Vec3>& mode) const;

  /// What a held vertex moves by.
  Vec3 moved(std::size_t held, const std::vector<Vec3>& mode) const;

  /// The mean gradient of what the vertices of a patch move by, over the patch in the reference pose.
  Mat3 gradient(std::size_t patch, const std::vector<Vec3>& mode) const;

  /// The mean over a patch of what projects on its faces' planes; zero without area.
  const std::vector<Mat3>& planes() const { return planes_; }

  /// Whether pulls turn a patch so little beside others that it may be left as it is.
  bool hardlyTurns(std::size_t patch) const { return little_[patch]; }

 private:
  void findFields(const Positions& reference);
  void addGradients(const HoldInput& input, const Positions& moved, std::size_t first);

  std::size_t modes_;
  std::vector<HeldVertex> held_;
  std::vector<double> field_;     // of each held vertex, its pin's modes there
  std::vector<double> fit_;       // of each held vertex, what its way adds to its pin's modes
  std::vector<double> response_;  // of each held vertex, what a mode moves it by
  std::vector<Mat3> planes_;
  std::vector<Vec3> gradient_;  // of each patch, of each mode
  std::vector<char> little_;    // of each patch
};

}  // namespace shapespline
