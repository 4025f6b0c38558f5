#include "core/patches/patch_rotations.h"

#include <algorithm>
#include <utility>

namespace shapespline {

namespace {

double power(double base, int exponent) {
  double result = 1;
  for (; exponent > 0; exponent /= 2, base *= base)
    if (exponent % 2 == 1) result *= base;
  return result;
}

// Laplacian of the graph with weighted links. Holding each root makes it definite. The caller sets the remaining free
// rotation.
SymmetricMatrix laplacianOf(const std::vector<PatchLink>& links, const PatchTree& tree,
                            const std::vector<double>& weight) {
  std::vector<Triplet> entries;
  for (std::size_t l = 0; l < weight.size(); ++l) {
    const auto [i, j, edges] = links[l];
    entries.push_back({i, i, weight[l]});
    entries.push_back({j, j, weight[l]});
    entries.push_back({std::max(i, j), std::min(i, j), -weight[l]});
  }
  const int count = static_cast<int>(tree.parent.size());
  for (int k = 0; k < count; ++k)
    if (tree.parent[k] < 0) entries.push_back({k, k, 1});
  return assembleSymmetric(count, entries);
}

}  // namespace

Result<PatchRotationSystem> PatchRotationSystem::create(const PatchGraph& graph, PatchTree tree,
                                                        std::vector<double> weight) {
  const SymmetricMatrix matrix = laplacianOf(graph.links(), tree, weight);
  Cholesky laplacian;
  if (Status status = laplacian.analyse(matrix, {}, Precision::Double); !status) return status.error();
  if (Status status = laplacian.factorise(matrix); !status) return status.error();
  return PatchRotationSystem(graph, std::move(tree), std::move(weight), std::move(laplacian));
}

PatchRotationSystem::PatchRotationSystem(const PatchGraph& graph, PatchTree tree, std::vector<double> weight,
                                         Cholesky laplacian)
    : links_(graph.links()), tree_(std::move(tree)), weight_(std::move(weight)), laplacian_(std::move(laplacian)) {
  double total = 0;
  for (double a : graph.area()) total += a;
  for (double a : graph.area()) area_.push_back(a / total);
  const auto position = laplacian_.eliminationPosition();
  position_.assign(position.begin(), position.end());
}

void PatchRotationSystem::startOnTree(const std::vector<Quaternion>& connection,
                                      std::vector<Quaternion>& rotation) const {
  for (const int k : tree_.order) {
    const int parent = tree_.parent[k], link = tree_.link[k];
    if (parent < 0) rotation[k].setIdentity();
    else if (links_[link].from == parent) rotation[k] = rotation[parent] * connection[link];
    else rotation[k] = rotation[parent] * connection[link].conjugate();
  }
}

void PatchRotationSystem::solve(const std::vector<Quaternion>& connection, std::span<const int> caution,
                                Scratch& scratch, std::vector<Quaternion>& rotation) const {
  rotation.resize(tree_.order.size());
  startOnTree(connection, rotation);
  if (!connection.empty())
    for (const int c : caution) step(connection, c, scratch, rotation);
}

void PatchRotationSystem::step(const std::vector<Quaternion>& connection, int caution, Scratch& scratch,
                               std::vector<Quaternion>& rotation) const {
  scratch.assign(laplacian_.paddedSize(), Eigen::Vector4d::Zero());
  for (std::size_t l = 0; l < links_.size(); ++l) {
    const auto [i, j, edges] = links_[l];
    // G_j (G_i C)^T = exp(r) with quaternion q: the sine of r, faded by powers of (1 + cos r) / 2 for large
    // disagreements. It needs no logarithm, has no branch cut, and is the same for q and -q.
    const Quaternion q = rotation[j] * (rotation[i] * connection[l]).conjugate();
    const Vec3 pull = weight_[l] * 2 * q.w() * power(q.w() * q.w(), caution) * q.vec();
    scratch[position_[i]].head<3>() += pull;
    scratch[position_[j]].head<3>() -= pull;
  }
  laplacian_.solve(scratch.data()->data());
  Vec3 mean = Vec3::Zero();
  for (std::size_t k = 0; k < rotation.size(); ++k) mean += area_[k] * scratch[position_[k]].head<3>();
  for (std::size_t k = 0; k < rotation.size(); ++k)
    rotation[k] = (expQuaternion(scratch[position_[k]].head<3>() - mean) * rotation[k]).normalized();
}

}  // namespace shapespline
