#include "core/patches/global_alignment.h"

#include <algorithm>
#include <cmath>

namespace shapespline {

namespace {

constexpr int steps = 3;

}  // namespace

GlobalAlignment::GlobalAlignment(const std::vector<std::vector<Quaternion>>& halfway, const std::vector<double>& area) {
  // The medoid: the smallest sum over j of area (1 - cos) = the largest sum of area (q_i . q_j)^2, a quadratic form in
  // q_i.
  std::vector<double> agreement(area.size(), 0);
  for (const auto& x : halfway) {
    Eigen::Matrix4d form = Eigen::Matrix4d::Zero();
    for (std::size_t k = 0; k < area.size(); ++k) form.noalias() += area[k] * x[k].coeffs() * x[k].coeffs().transpose();
    for (std::size_t k = 0; k < area.size(); ++k) agreement[k] += x[k].coeffs().dot(form * x[k].coeffs());
  }
  double total = 0;
  for (double a : area) total += a;
  // Rounded to a grid, so rounding errors decide no tie.
  for (double& a : agreement) a = std::nearbyint(a / total * 0x1p20);
  medoid_ = static_cast<int>(std::max_element(agreement.begin(), agreement.end()) - agreement.begin());
  double sum = 0;
  for (std::size_t k = 0; k < area.size(); ++k) {
    double least = 1;  // (1 + cos) / 2 of the largest angle to the medoid
    for (const auto& x : halfway) least = std::min(least, std::pow(x[k].dot(x[medoid_]), 2));
    weight_.push_back(area[k] * std::pow(least, 4));
    sum += weight_.back();
  }
  for (double& w : weight_) w /= sum;
}

Quaternion GlobalAlignment::at(const std::vector<Quaternion>& path, const std::vector<Quaternion>& rotation) const {
  Quaternion turn = path[medoid_] * rotation[medoid_].conjugate();
  for (int i = 0; i < steps; ++i) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < path.size(); ++k) {
      const Quaternion d = path[k] * (turn * rotation[k]).conjugate();
      sum += weight_[k] * 2 * d.w() * d.w() * d.w() * d.vec();
    }
    turn = (expQuaternion(sum) * turn).normalized();
  }
  return turn;
}

}  // namespace shapespline
