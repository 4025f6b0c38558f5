// One-sided derivatives of a motion by differences. They differ between the two sides at a jump.
#pragma once

#include <array>

#include "sweep.h"

namespace shapespline::test {

/// First and second derivatives of all vertices and of the rotations of all patches (radians): angular velocity and
/// acceleration.
struct OneSided {
  Positions velocity, acceleration, angularVelocity, angularAcceleration;
};

/// Uses the times t, t + h, t + 2h and t + 3h; h < 0 for the side before t. Errors: third order in h for the velocity,
/// second order for the acceleration.
inline OneSided oneSided(Sequence& sequence, const PatchTurning& patches, double t, double h) {
  std::array<Positions, 4> x, turn;
  for (int i = 0; i < 4; ++i) {
    x[i] = shapeAt(sequence, t + i * h);
    for (int patch = 0; patch < patches.count(); ++patch) turn[i].push_back(patches.of(patch, x[0], x[i]) * (pi / 180));
  }
  const auto velocity = [&](const std::array<Positions, 4>& y, std::size_t v) -> Vec3 {
    return (-11 * y[0][v] + 18 * y[1][v] - 9 * y[2][v] + 2 * y[3][v]) / (6 * h);
  };
  const auto acceleration = [&](const std::array<Positions, 4>& y, std::size_t v) -> Vec3 {
    return (2 * y[0][v] - 5 * y[1][v] + 4 * y[2][v] - y[3][v]) / (h * h);
  };
  OneSided side;
  for (std::size_t v = 0; v < x[0].size(); ++v)
    side.velocity.push_back(velocity(x, v)), side.acceleration.push_back(acceleration(x, v));
  for (std::size_t p = 0; p < turn[0].size(); ++p)
    side.angularVelocity.push_back(velocity(turn, p)), side.angularAcceleration.push_back(acceleration(turn, p));
  return side;
}

inline double largestNorm(const Positions& list) {
  double largest = 0;
  for (const Vec3& x : list) largest = std::max(largest, x.norm());
  return largest;
}

/// Largest differences between the two sides, relative to the largest value. Accelerations smaller than needed to stop
/// the motion within `duration` count as that value, so a motion without acceleration has no relative jump.
struct Jumps {
  double velocity, acceleration, angularVelocity, angularAcceleration;
};

inline Jumps jumpsBetween(const OneSided& before, const OneSided& after, double duration) {
  const auto jump = [](const Positions& a, const Positions& b, double least) {
    return largestDistance(a, b) / std::max({largestNorm(a), largestNorm(b), least, 1e-12});
  };
  return {jump(before.velocity, after.velocity, 0),
          jump(before.acceleration, after.acceleration, largestNorm(before.velocity) / duration),
          jump(before.angularVelocity, after.angularVelocity, 0),
          jump(before.angularAcceleration, after.angularAcceleration, largestNorm(before.angularVelocity) / duration)};
}

/// Jumps of the motion at t, by differences over h.
inline Jumps jumpsAt(Sequence& sequence, const PatchTurning& patches, double t, double h = 2e-4) {
  const auto [start, end] = sequence.range();
  return jumpsBetween(oneSided(sequence, patches, t, -h), oneSided(sequence, patches, t, h), end - start);
}

}  // namespace shapespline::test
