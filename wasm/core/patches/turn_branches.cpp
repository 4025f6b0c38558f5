#include "core/patches/turn_branches.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/patches/patch_rotations.h"

namespace shapespline {

namespace {

// Shorter increments have no axis for a rotation in the other direction, radians.
constexpr double axisless = 1e-3;
constexpr std::array robustSteps = {1, 1, 1, 1, 1, 1, 1, 1};

Vec3 increment(const PatchLink& link, const Quaternion& from, const Quaternion& to,
               const std::vector<Quaternion>& turn) {
  const Vec3 d = logRotation(Quaternion(from.conjugate() * to));
  const double angle = d.norm();
  const bool isOther = angle > axisless && link.sharedEdges > 0 && turn[link.from].dot(turn[link.to]) < 0;
  return isOther ? Vec3(d - twoPi / angle * d) : d;
}

}  // namespace

Result<TurnBranches> chooseTurnBranches(const PatchGraph& graph, const std::vector<Quaternion>& from,
                                        const std::vector<Quaternion>& to, const std::vector<Quaternion>& turn) {
  TurnBranches result;
  std::vector<double> cost, weight;
  std::vector<Quaternion> half, rotation;
  for (std::size_t l = 0; l < from.size(); ++l) {
    const PatchLink& link = graph.links()[l];
    const Vec3 d = increment(link, from[l], to[l], turn);
    const double angle = d.norm(), shared = std::clamp(link.sharedEdges / graph.meanSharedEdges(), 0.2, 3.0);
    result.increment.push_back(d);
    half.push_back(from[l] * expQuaternion(d / 2));
    cost.push_back(0.1 + angle + 3 * std::pow(angle / 2, 6));
    weight.push_back(1e-5 + std::pow(agreement(angle), 6) + 0.02 * shared);
  }
  const auto system = PatchRotationSystem::create(graph, graph.centreTree(cost), std::move(weight));
  if (!system) return system.error();
  PatchRotationSystem::Scratch scratch;
  system->solve(half, robustSteps, scratch, rotation);
  for (std::size_t l = 0; l < from.size(); ++l) {
    const PatchLink& link = graph.links()[l];
    result.residual.push_back(rotation[link.to].angularDistance(rotation[link.from] * half[l]));
  }
  return result;
}

}  // namespace shapespline
