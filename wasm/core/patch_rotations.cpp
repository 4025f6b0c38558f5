#include "core/patch_rotations.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace shapespline {

namespace {

// Steps below this many radians end the iteration; a vertex then moves by less than 1e-9 of the shape's size.
constexpr double stepTolerance = 1e-11;
// Consistent maps need two or three steps; the limit is met only where branches disagree around a cycle.
constexpr int maximumSteps = 100;

}  // namespace

void PatchRotationSystem::spanTree(const Patches& patches, int root) {
  std::vector<std::vector<std::pair<int, int>>> at(patches.count);  // patch -> (neighbour, pair)
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    at[pairs_[p].first].emplace_back(pairs_[p].second, static_cast<int>(p));
    at[pairs_[p].second].emplace_back(pairs_[p].first, static_cast<int>(p));
  }
  parent_.assign(patches.count, -1);
  parentPair_.assign(patches.count, -1);
  order_.clear();
  std::vector<std::vector<int>> members;
  for (int k = 0; k < patches.count; ++k) {
    const auto piece = static_cast<std::size_t>(patches.pieceOf[k]);
    if (members.size() <= piece) members.resize(piece + 1);
    members[piece].push_back(k);
  }
  std::vector<char> reached(patches.count, 0);
  struct Link {
    double weight;
    int pair, patch, parent;
    bool operator<(const Link& o) const { return weight != o.weight ? weight < o.weight : pair > o.pair; }
  };
  for (const auto& piece : members) {  // Prim's algorithm
    if (piece.empty()) continue;
    std::priority_queue<Link> queue;
    const auto reach = [&](int patch) {
      reached[patch] = 1;
      order_.push_back(patch);
      for (auto [other, pair] : at[patch])
        if (!reached[other]) queue.push({weight_[pair], pair, other, patch});
    };
    reach(piece[static_cast<std::size_t>(root) % piece.size()]);
    while (!queue.empty()) {
      const Link link = queue.top();
      queue.pop();
      if (reached[link.patch]) continue;
      parent_[link.patch] = link.parent;
      parentPair_[link.patch] = link.pair;
      reach(link.patch);
    }
  }
}

Status PatchRotationSystem::build(const Patches& patches, const std::vector<double>& pairWeight, int root) {
  pairs_ = patches.pairs;
  weight_ = pairWeight;
  spanTree(patches, root);
  std::vector<Triplet> entries;
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const auto [i, j, edges] = pairs_[p];
    entries.push_back({i, i, weight_[p]});
    entries.push_back({j, j, weight_[p]});
    entries.push_back({j, i, -weight_[p]});
  }
  // Tying each piece's root to zero makes the matrix definite; the rotation left free is set by the caller.
  for (int k = 0; k < patches.count; ++k)
    if (parent_[k] < 0) entries.push_back({k, k, 1});
  const SymmetricMatrix matrix = assembleSymmetric(patches.count, entries);
  if (Status status = laplacian_.analyse(matrix, {}, Precision::Double); !status) return status;
  if (Status status = laplacian_.factorise(matrix); !status) return status;
  const auto position = laplacian_.eliminationPosition();
  position_.assign(position.begin(), position.end());
  return {};
}

void PatchRotationSystem::startOnTree(const std::vector<Quaternion>& connection, std::vector<Quaternion>& rotation) const {
  for (int k : order_) {
    const int p = parentPair_[k];
    if (p < 0) {
      rotation[k].setIdentity();
      continue;
    }
    const Quaternion& parent = rotation[parent_[k]];
    rotation[k] = pairs_[p].first == parent_[k] ? parent * connection[p] : parent * connection[p].conjugate();
    rotation[k].normalize();
  }
}

int PatchRotationSystem::solve(const std::vector<Vec3>& pair, std::vector<Quaternion>& rotation) const {
  rotation.resize(order_.size());
  std::vector<Quaternion> connection(pairs_.size());
  for (std::size_t p = 0; p < pairs_.size(); ++p) connection[p] = expQuaternion(pair[p]);
  startOnTree(connection, rotation);
  if (pairs_.empty()) return 0;

  using Vec4 = Eigen::Vector4d;
  std::vector<Vec4, Eigen::aligned_allocator<Vec4>> step(laplacian_.paddedSize());
  for (int count = 1; count <= maximumSteps; ++count) {
    std::fill(step.begin(), step.end(), Vec4::Zero());
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      const auto [i, j, edges] = pairs_[p];
      // G_j (G_i exp(x_ij))^T = exp(r) in the common frame; its sine part is the gradient of the chordal distance.
      const Quaternion error = rotation[j] * (rotation[i] * connection[p]).conjugate();
      const Vec3 pull = weight_[p] * 2 * error.w() * error.vec();
      step[position_[i]].head<3>() += pull;
      step[position_[j]].head<3>() -= pull;
    }
    laplacian_.solve(step.data()->data());
    double largest = 0;
    for (std::size_t k = 0; k < rotation.size(); ++k) {
      const Vec3 e = step[position_[k]].head<3>();
      largest = std::max(largest, e.squaredNorm());
      rotation[k] = (expQuaternion(e) * rotation[k]).normalized();
    }
    if (largest < stepTolerance * stepTolerance) return count;
  }
  return maximumSteps;
}

}  // namespace shapespline
