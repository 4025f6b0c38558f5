#include "samples/skin.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "samples/implicit.h"

namespace shapespline {
namespace {

std::vector<std::vector<int>> neighbours(const Surface& surface) {
  std::vector<std::vector<int>> result(surface.positions.size());
  for (const Triangle& face : surface.faces) {
    for (int c = 0; c < 3; ++c) result[face[c]].push_back(face[(c + 1) % 3]);
  }
  return result;
}

struct Attachment {
  std::vector<Share> shares;
  bool held;  // at the rigid end of a limb
};

Attachment attachmentOf(const Body& body, const Vec3& point) {
  const BodyPoint nearest = nearestOnBody(body, point);
  const Limb& limb = body.limbs[nearest.limb];
  const int first = body.firstJoint(nearest.limb), last = limb.jointCount() - 1;
  if (nearest.on.along >= limb.rigidFrom * last) return {{{first + last, 1.0}}, true};
  const int joint = std::min(static_cast<int>(nearest.on.along), last - 1);
  const double t = nearest.on.along - joint;
  return {{{first + joint, 1 - t}, {first + joint + 1, t}}, false};
}

std::vector<Share> average(const Binding& binding, int vertex, const std::vector<int>& around) {
  std::map<int, double> sums;
  for (const Share& share : binding[vertex]) sums[share.joint] += 0.5 * share.weight;
  for (int v : around) {
    for (const Share& share : binding[v]) sums[share.joint] += 0.5 * share.weight / around.size();
  }
  std::vector<Share> result;
  double total = 0;
  for (const auto& [joint, weight] : sums) {
    if (weight < 1e-5) continue;  // far joints: without this the lists grow with every round
    result.push_back({joint, weight});
    total += weight;
  }
  for (Share& share : result) share.weight /= total;
  return result;
}

struct DualQuaternion {
  Eigen::Vector4d real = Eigen::Vector4d::Zero(), dual = Eigen::Vector4d::Zero();  // x, y, z, w
};

DualQuaternion toDual(const Rigid& rigid) {
  const Eigen::Quaterniond r(rigid.linear());
  const Eigen::Quaterniond t(0, rigid.translation().x(), rigid.translation().y(), rigid.translation().z());
  return {r.coeffs(), 0.5 * (t * r).coeffs()};
}

DualQuaternion blend(const std::vector<DualQuaternion>& joints, const std::vector<Share>& shares) {
  const auto main = std::max_element(shares.begin(), shares.end(),
                                     [](const Share& a, const Share& b) { return a.weight < b.weight; });
  DualQuaternion sum;
  for (const Share& share : shares) {
    // q and -q are the same rotation: take the one near the main joint's.
    const double sign = joints[share.joint].real.dot(joints[main->joint].real) < 0 ? -1 : 1;
    sum.real += sign * share.weight * joints[share.joint].real;
    sum.dual += sign * share.weight * joints[share.joint].dual;
  }
  const double norm = sum.real.norm();
  return {sum.real / norm, sum.dual / norm};
}

Vec3 apply(const DualQuaternion& q, const Vec3& point) {
  const Eigen::Quaterniond real(q.real), dual(q.dual);
  return real * point + 2 * (dual * real.conjugate()).vec();
}

}  // namespace

Binding bindSurface(const Surface& surface, const Body& body, int rounds) {
  const auto around = neighbours(surface);
  Binding binding;
  std::vector<bool> held;
  for (const Vec3& point : surface.positions) {
    Attachment attachment = attachmentOf(body, point);
    binding.push_back(std::move(attachment.shares));
    held.push_back(attachment.held);
  }
  for (int i = 0; i < rounds; ++i) {
    Binding smoothed;
    for (std::size_t v = 0; v < binding.size(); ++v) {
      smoothed.push_back(held[v] ? binding[v] : average(binding, static_cast<int>(v), around[v]));
    }
    binding = std::move(smoothed);
  }
  return binding;
}

Positions skin(const Surface& surface, const Binding& binding, const std::vector<Rigid>& joints) {
  std::vector<DualQuaternion> duals;
  for (const Rigid& joint : joints) duals.push_back(toDual(joint));
  Positions result;
  for (std::size_t v = 0; v < binding.size(); ++v) {
    result.push_back(apply(blend(duals, binding[v]), surface.positions[v]));
  }
  return result;
}

}  // namespace shapespline
