#include "core/patch_rotations.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace shapespline {

namespace {

// Radians that may be left when the iteration ends; a vertex then moves by less than 1e-9 of the shape's size.
constexpr double tolerance = 1e-11;
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

void PatchRotationSystem::startOnTree(std::vector<Quaternion>& rotation) const {
  for (int k : order_) {
    const int p = parentPair_[k];
    if (p < 0) {
      rotation[k].setIdentity();
      continue;
    }
    const Quaternion& parent = rotation[parent_[k]];
    rotation[k] = pairs_[p].first == parent_[k] ? parent * connection_[p] : parent * connection_[p].conjugate();
    rotation[k].normalize();
  }
}

int PatchRotationSystem::solve(const std::vector<Vec3>& pair, std::vector<Quaternion>& rotation) {
  rotation.resize(order_.size());
  connection_.resize(pairs_.size());
  for (std::size_t p = 0; p < pairs_.size(); ++p) connection_[p] = expQuaternion(pair[p]);
  startOnTree(rotation);
  if (pairs_.empty()) return 0;

  double before = 0;
  for (int count = 1; count <= maximumSteps; ++count) {
    const double length = step(rotation);
    // Steps shrink by much the same factor each time: what is left after this one is smaller than it by that factor.
    const double left = length < before ? length * (length / before) : length;
    if (left < tolerance) return count;
    before = length;
  }
  return maximumSteps;
}

double PatchRotationSystem::step(std::vector<Quaternion>& rotation) {
  step_.assign(laplacian_.paddedSize(), Vec4::Zero());
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const auto [i, j, edges] = pairs_[p];
    // G_j (G_i exp(x_ij))^T = exp(r) in the common frame; its sine part is the gradient of the chordal distance.
    const Quaternion error = rotation[j] * (rotation[i] * connection_[p]).conjugate();
    const Vec3 pull = weight_[p] * 2 * error.w() * error.vec();
    step_[position_[i]].head<3>() += pull;
    step_[position_[j]].head<3>() -= pull;
  }
  laplacian_.solve(step_.data()->data());
  double largest = 0;
  for (std::size_t k = 0; k < rotation.size(); ++k) {
    const Vec3 e = step_[position_[k]].head<3>();
    largest = std::max(largest, e.squaredNorm());
    // exp(e) but for its third order, which the next step sees
    rotation[k] = (Quaternion(1, e.x() / 2, e.y() / 2, e.z() / 2) * rotation[k]).normalized();
  }
  return std::sqrt(largest);
}

}  // namespace shapespline
