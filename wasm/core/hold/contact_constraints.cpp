#include "core/hold/contact_constraints.h"

#include <algorithm>
#include <cmath>

namespace shapespline {

namespace {

// Mean rest at which holding of a patch starts, and at which it is complete.
constexpr double restFadeStart = 0.1, restFadeEnd = 0.6;
constexpr double softness = 0.1;  // share of the mean compliance
constexpr int maxResponses = 48;  // rows of this size cost about as much as a solve

// Lower triangular L with L L^T = a, by rows, in place.
void factorise(std::vector<double>& a, int n) {
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) {
      double sum = a[i * n + j];
      for (int k = 0; k < j; ++k) sum -= a[i * n + k] * a[j * n + k];
      a[i * n + j] = i == j ? std::sqrt(sum) : sum / a[j * n + j];
    }
}

}  // namespace

ContactConstraints::ContactConstraints(const RestingSpline& path, const HoldSystem& system,
                                       const std::vector<int>& patchOf, int patches, const std::vector<double>& area)
    : loop_(path.loop()), spans_(path.spans()) {
  std::vector<double> patchArea(patches, 0.0), rest(static_cast<std::size_t>(patches) * spans_, 0.0);
  for (std::size_t v = 0; v < patchOf.size(); ++v) {
    if (patchOf[v] < 0) continue;
    patchArea[patchOf[v]] += area[v];
    for (int s = 0; s < spans_; ++s) rest[patchOf[v] * spans_ + s] += area[v] * static_cast<double>(path.rest(s, v));
  }
  std::vector<int> number(patches, -1);
  for (int p = 0; p < patches; ++p) {
    double most = 0;
    for (int s = 0; s < spans_; ++s) {
      double& r = rest[p * spans_ + s];
      r = smoothstep2(r / patchArea[p], restFadeStart, restFadeEnd);
      most = std::max(most, r);
    }
    if (!(most > 0)) continue;
    number[p] = count_++;
    rest_.insert(rest_.end(), &rest[p * spans_], &rest[p * spans_] + spans_);
  }
  for (std::size_t v = 0; v < patchOf.size(); ++v)
    if (patchOf[v] >= 0 && number[patchOf[v]] >= 0)
      shares_.push_back({static_cast<int>(v), number[patchOf[v]], area[v] / patchArea[patchOf[v]]});
  findCompliance(system, patchOf.size());
}

// Computes the displacement of all handles by a pull at one of them, three handles at once.
void ContactConstraints::findCompliance(const HoldSystem& system, std::size_t vertices) {
  factor_.assign(static_cast<std::size_t>(count_) * count_, 0.0);
  if (count_ <= maxResponses) response_.resize(vertices * count_);
  HoldSystem::Scratch scratch;
  for (int first = 0; first < count_; first += 3) {
    Positions pull(vertices, Vec3::Zero()), moved = pull;
    const int some = std::min(3, count_ - first);
    for (const auto& [vertex, handle, share] : shares_)
      if (handle >= first && handle < first + some) pull[vertex][handle - first] = share;
    system.addSolved(pull, moved, scratch, nullptr);
    for (const auto& [vertex, handle, share] : shares_)
      for (int k = 0; k < some; ++k) factor_[handle * count_ + first + k] += share * moved[vertex][k];
    for (std::size_t v = 0; v < vertices && !response_.empty(); ++v)
      for (int k = 0; k < some; ++k) response_[v * count_ + first + k] = static_cast<float>(moved[v][k]);
  }
  double mean = 0;
  for (int h = 0; h < count_; ++h) mean += factor_[h * count_ + h] / count_;
  for (int h = 0; h < count_; ++h) factor_[h * count_ + h] += softness * mean;
  factorise(factor_, count_);
}

bool ContactConstraints::weightsAt(const SpanPosition& inSpan, std::vector<double>& weight) const {
  bool any = false;
  weight.clear();
  for (int h = 0; h < count_; ++h) {
    weight.push_back(blendSpans(&rest_[h * spans_], spans_, loop_, inSpan) * inSpan.within());
    any = any || weight.back() > 0;
  }
  return any;
}

void ContactConstraints::pull(std::vector<Vec3>& left) const {
  const int n = count_;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < i; ++k) left[i] -= factor_[i * n + k] * left[k];
    left[i] /= factor_[i * n + i];
  }
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k < n; ++k) left[i] -= factor_[k * n + i] * left[k];
    left[i] /= factor_[i * n + i];
  }
}

void ContactConstraints::meanDisplacements(const Positions& from, const Positions& to,
                                           std::vector<Vec3>& displacement) const {
  displacement.assign(count_, Vec3::Zero());
  for (const auto& [vertex, handle, share] : shares_) displacement[handle] += share * (to[vertex] - from[vertex]);
}

void ContactConstraints::addTo(Positions& pulls, const std::vector<Vec3>& pull) const {
  for (const auto& [vertex, handle, share] : shares_) pulls[vertex] += share * pull[handle];
}

}  // namespace shapespline
