// Sequences and their shapes. Each function fails the test if there is no result.
#pragma once

#include <doctest/doctest.h>

#include <utility>

#include "core/sequence/sequence.h"

namespace shapespline::test {

inline Sequence sequenceOf(Keyframes keyframes, const EncodingOptions& encoding, const MotionOptions& motion = {}) {
  auto sequence = Sequence::create(std::move(keyframes), encoding, motion);
  REQUIRE_MESSAGE(sequence.ok(), (sequence.ok() ? "" : sequence.error().message));
  return std::move(*sequence);
}

inline Positions shapeAt(Sequence& sequence, double t) {
  Positions positions;
  const Status status = sequence.evaluate(t, positions);
  REQUIRE_MESSAGE(status.ok(), (status.ok() ? "" : status.error().message));
  return positions;
}

inline std::vector<Quaternion> patchesAt(Sequence& sequence, double t) {
  std::vector<Quaternion> rotations;
  REQUIRE(sequence.patchRotations(t, rotations).ok());
  return rotations;
}

}  // namespace shapespline::test
