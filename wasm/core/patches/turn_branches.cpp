#include "core/patches/turn_branches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/patches/patch_rotations.h"

namespace shapespline {

namespace {

// Links that turn by more may have turned the other way: 100 degrees.
constexpr double ambiguousAngle = 1.75;
constexpr std::array robustSteps = {1, 1, 1, 1, 1, 1, 1, 1};
constexpr int mostRounds = 6;
// Disagreement beyond this adds no cost: a few links may be lost.
constexpr double worstResidual = 2;
// Of a turn against a disagreement.
constexpr double turnCost = 0.3;

class BranchSearch {
 public:
  BranchSearch(const PatchGraph& graph, const std::vector<Quaternion>& from, const std::vector<Quaternion>& to)
      : graph_(graph), from_(from), half_(from.size()), count_(from.size()) {
    for (std::size_t l = 0; l < count_; ++l) {
      const Vec3 d = logRotation(Quaternion(from[l].conjugate() * to[l]));
      const double angle = d.norm();
      principal_.push_back(d);
      angle_.push_back(angle);
      const bool ambiguous = angle > ambiguousAngle && graph.links()[l].sharedEdges > 0;
      other_.push_back(ambiguous ? Vec3(d - twoPi / angle * d) : d);
      anyAmbiguous_ |= ambiguous;
    }
  }

  Result<TurnBranches> run() {
    for (const PatchTree& tree : startTrees())
      if (Status status = searchFrom(tree); !status) return status.error();
    return std::move(best_);
  }

 private:
  const Vec3& chosen(std::size_t l, bool flip) const { return flip ? other_[l] : principal_[l]; }

  std::vector<double> costs(double (*cost)(double angle)) const {
    std::vector<double> result;
    for (const double angle : angle_) result.push_back(cost(angle));
    return result;
  }

  std::vector<PatchTree> startTrees() const {
    std::vector<PatchTree> trees;
    trees.push_back(graph_.centreTree(costs([](double a) { return 0.1 + a + 3 * std::pow(a / 2, 6); })));
    if (!anyAmbiguous_) return trees;
    trees.push_back(graph_.centreTree(costs([](double a) { return 0.1 + a; })));
    trees.push_back(graph_.spanningTree(costs([](double a) { return std::pow(agreement(a), 6); }), trees[0].root()));
    trees.push_back(graph_.centreTree(costs([](double a) { return 1 / (std::pow(agreement(a), 6) + 3e-3); })));
    return trees;
  }

  std::vector<double> weights() const {
    std::vector<double> result;
    for (std::size_t l = 0; l < count_; ++l) {
      const double shared = std::clamp(graph_.links()[l].sharedEdges / graph_.meanSharedEdges(), 0.2, 3.0);
      result.push_back(1e-5 + std::pow(agreement(angle_[l]), 6) + 0.02 * shared);
    }
    return result;
  }

  double residual(std::size_t l, const Vec3& increment) const {
    const auto [i, j, edges] = graph_.links()[l];
    return rotation_[j].angularDistance(rotation_[i] * from_[l] * expQuaternion(increment / 2));
  }

  Status searchFrom(const PatchTree& tree) {
    const Result<PatchRotationSystem> system = PatchRotationSystem::create(graph_, tree, weights());
    if (!system) return system.error();
    std::vector<char> flip(count_, 0);
    for (int round = 0; round < mostRounds; ++round) {
      for (std::size_t l = 0; l < count_; ++l) half_[l] = from_[l] * expQuaternion(chosen(l, flip[l]) / 2);
      system->solve(half_, robustSteps, scratch_, rotation_);
      std::vector<double> left(count_);
      double cost = 0;
      for (std::size_t l = 0; l < count_; ++l) {
        left[l] = residual(l, chosen(l, flip[l]));
        const double lost = std::min(left[l], worstResidual);
        cost += graph_.links()[l].sharedEdges * (lost * lost + turnCost * chosen(l, flip[l]).squaredNorm());
      }
      keepIfBest(std::nearbyint(cost * 0x1p20), flip, left);
      bool changed = false;
      for (std::size_t l = 0; l < count_; ++l) {
        if (angle_[l] <= ambiguousAngle || graph_.links()[l].sharedEdges == 0) continue;
        const char better = residual(l, other_[l]) < residual(l, principal_[l]);
        changed |= better != flip[l];
        flip[l] = better;
      }
      if (!changed) break;
    }
    return {};
  }

  void keepIfBest(double cost, const std::vector<char>& flip, const std::vector<double>& left) {
    if (cost >= leastCost_) return;
    leastCost_ = cost;
    best_.residual = left;
    best_.increment.clear();
    for (std::size_t l = 0; l < count_; ++l) best_.increment.push_back(chosen(l, flip[l]));
  }

  const PatchGraph& graph_;
  const std::vector<Quaternion>& from_;
  std::vector<Quaternion> half_, rotation_;
  PatchRotationSystem::Scratch scratch_;
  std::size_t count_;
  std::vector<Vec3> principal_, other_;
  std::vector<double> angle_;
  bool anyAmbiguous_ = false;
  TurnBranches best_;
  double leastCost_ = std::numeric_limits<double>::infinity();
};

}  // namespace

Result<TurnBranches> chooseTurnBranches(const PatchGraph& graph, const std::vector<Quaternion>& from,
                                        const std::vector<Quaternion>& to) {
  return BranchSearch(graph, from, to).run();
}

}  // namespace shapespline
