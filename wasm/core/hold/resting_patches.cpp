#include "core/hold/resting_patches.h"

#include <algorithm>
#include <cmath>

namespace shapespline {

namespace {

constexpr double restsLittle = 0.1, restsWhole = 0.6;  // mean rest of a patch that is not held yet, and of one that is held whole
constexpr double softness = 0.1;            // of the mean compliance

// Lower triangular L with L L^T = a, in place.
void factorise(Eigen::MatrixXd& a) {
  for (Eigen::Index j = 0; j < a.cols(); ++j) {
    for (Eigen::Index i = j; i < a.rows(); ++i) a(i, j) -= a.row(i).head(j).dot(a.row(j).head(j));
    a.col(j).tail(a.rows() - j) /= std::sqrt(a(j, j));
  }
}

}  // namespace

RestingPatches::RestingPatches(const VertexPath& path, const HoldSystem& system, const std::vector<int>& patchOf,
                               int patches, const std::vector<double>& area)
    : handleOf_(patchOf.size(), -1), share_(patchOf.size(), 0.0), loop_(path.loop()) {
  std::vector<double> patchArea(patches, 0.0);
  for (std::size_t v = 0; v < patchOf.size(); ++v)
    if (patchOf[v] >= 0) patchArea[patchOf[v]] += area[v];
  std::vector<std::vector<double>> rest(patches, std::vector<double>(path.spans(), 0.0));
  for (std::size_t v = 0; v < patchOf.size(); ++v)
    for (int s = 0; s < path.spans() && patchOf[v] >= 0; ++s)
      rest[patchOf[v]][s] += area[v] / patchArea[patchOf[v]] * static_cast<double>(path.rest(s, v));
  std::vector<int> number(patches, -1);
  for (int p = 0; p < patches; ++p) {
    for (double& r : rest[p]) r = fade(r, restsLittle, restsWhole);
    if (*std::max_element(rest[p].begin(), rest[p].end()) <= 0) continue;
    number[p] = static_cast<int>(rest_.size());
    rest_.push_back(rest[p]);
  }
  for (std::size_t v = 0; v < patchOf.size(); ++v)
    if (patchOf[v] >= 0 && number[patchOf[v]] >= 0)
      handleOf_[v] = number[patchOf[v]], share_[v] = area[v] / patchArea[patchOf[v]];

  // Compliance: how far a pull at one handle moves the others, three handles at once.
  factor_ = Eigen::MatrixXd::Zero(count(), count());
  HoldSystem::Scratch scratch;
  std::vector<double> x(system.size());
  const auto at = [&](std::size_t v) { return 4 * static_cast<std::size_t>(system.slot()[v]); };
  for (int first = 0; first < count(); first += 3) {
    std::fill(x.begin(), x.end(), 0.0);
    for (std::size_t v = 0; v < handleOf_.size(); ++v)
      if (handleOf_[v] >= first && handleOf_[v] < first + 3) x[at(v) + handleOf_[v] - first] = share_[v];
    system.solve(x, scratch, nullptr);
    for (std::size_t v = 0; v < handleOf_.size(); ++v)
      for (int k = 0; k < std::min(3, count() - first) && handleOf_[v] >= 0; ++k)
        factor_(handleOf_[v], first + k) += share_[v] * x[at(v) + k];
  }
  const double mean = count() > 0 ? factor_.trace() / count() : 0;
  factor_.diagonal().array() += softness * mean;
  factorise(factor_);
}

bool RestingPatches::weightsAt(const SpanPlace& place, std::vector<double>& weight) const {
  bool any = false;
  weight.clear();
  for (const std::vector<double>& rest : rest_) {
    const auto in = [&](int span) { return rest[span]; };
    weight.push_back(tween(in, static_cast<int>(rest.size()), loop_, place) * place.within());
    any = any || weight.back() > 0;
  }
  return any;
}

void RestingPatches::pull(std::vector<Vec3>& left) const {
  const int n = count();
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < i; ++k) left[i] -= factor_(i, k) * left[k];
    left[i] /= factor_(i, i);
  }
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k < n; ++k) left[i] -= factor_(k, i) * left[k];
    left[i] /= factor_(i, i);
  }
}

}  // namespace shapespline
