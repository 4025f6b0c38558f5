// Rotations at one time in groups of four, such as R_f of each face for the face kernel.
#pragma once

#include <cstddef>
#include <vector>

#include "core/lri/face_coordinates.h"
#include "core/rotation/rotation.h"

namespace shapespline {

/// Unit quaternions: [block][x, y, z, w][lane]. The faces have the blocks and lanes of FaceCoordinates.
template <class Real>
using RotationBlocks = std::vector<Real>;

inline constexpr int rotationBlock = 4 * faceLanes;

constexpr std::size_t rotationNumbers(int count) {
  return static_cast<std::size_t>(rotationBlock) * ((count + faceLanes - 1) / faceLanes);
}

/// Index of number k of the rotation in a slot.
constexpr std::size_t rotationAt(int slot, int k) {
  return static_cast<std::size_t>(slot / faceLanes) * rotationBlock + k * faceLanes + slot % faceLanes;
}

template <class Real>
Quaternion rotationOf(const RotationBlocks<Real>& rotations, int slot) {
  const auto at = [&](int k) { return static_cast<double>(rotations[rotationAt(slot, k)]); };
  return {at(3), at(0), at(1), at(2)};
}

template <class Real>
void setRotation(RotationBlocks<Real>& rotations, int slot, const Quaternion& q) {
  for (int k = 0; k < 4; ++k) rotations[rotationAt(slot, k)] = static_cast<Real>(q.coeffs()[k]);
}

}  // namespace shapespline
