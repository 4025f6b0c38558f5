#include "core/hold/affine_response.h"

#include <algorithm>
#include <cmath>

#include "core/hold/hold_passes.h"

namespace shapespline {

namespace {

constexpr std::size_t fields = 4;  // a constant field, and one along each of three axes
// Limits below which a pin is flat or a single vertex, and has no field in a direction: relative to the pin's extent,
// and, for rounding errors, relative to the coordinates.
constexpr double minExtent = 1e-3, rounding = 1e-7;
// Share of a patch's largest gradient. Pulls with smaller gradients barely rotate the patch.
constexpr double littleGradient = 5e-3;

}  // namespace

AffineResponse::AffineResponse(const HoldInput& input, const HoldSystem& system, std::span<const HeldVertex> held,
                               int pins)
    : modes_(fields * static_cast<std::size_t>(pins)), held_(held.begin(), held.end()) {
  int patches = 0;
  for (const int p : input.patchOfFace) patches = std::max(patches, p + 1);
  planes_.assign(patches, Mat3::Zero());
  gradient_.assign(planes_.size() * modes_, Vec3::Zero());
  response_.assign(held_.size() * modes_, 0.0);
  findFields(input.mesh.shape.poses[input.mesh.shape.reference]);
  HoldSystem::Scratch scratch;
  for (std::size_t first = 0; first < modes_; first += 3) {
    Positions pull(input.mesh.shape.poses[0].size(), Vec3::Zero()), moved = pull;
    const std::size_t count = std::min<std::size_t>(3, modes_ - first);
    for (std::size_t i = 0; i < held_.size(); ++i)
      for (std::size_t k = 0; k < count; ++k)
        if (held_[i].pin == static_cast<int>((first + k) / fields))
          pull[held_[i].vertex][k] = held_[i].weight * field_[fields * i + (first + k) % fields];
    system.addSolved(pull, moved, scratch, nullptr);
    for (std::size_t i = 0; i < held_.size(); ++i)
      for (std::size_t k = 0; k < count; ++k) response_[modes_ * i + first + k] = moved[held_[i].vertex][k];
    addGradients(input, moved, first);
  }
  std::vector<double> most(planes_.size(), 0.0);
  for (std::size_t i = 0; i < gradient_.size(); ++i) most[i / modes_] += gradient_[i].squaredNorm();
  const double largest = *std::max_element(most.begin(), most.end());
  for (const double square : most) little_.push_back(square <= littleGradient * littleGradient * largest);
}

// Fields of each pin: the constant 1 and the vertex positions, orthonormal under the pin's weights.
void AffineResponse::findFields(const Positions& reference) {
  field_.assign(fields * held_.size(), 0.0);
  for (std::size_t begin = 0, end = 0; begin < held_.size(); begin = end) {
    double whole = 1e-300;  // avoids 0 / 0: a loose vertex has no weight
    for (; end < held_.size() && held_[end].pin == held_[begin].pin; ++end) whole += held_[end].weight;
    const auto product = [&](std::size_t a, std::size_t b) {
      double sum = 0;
      for (std::size_t i = begin; i < end; ++i)
        sum += held_[i].weight * field_[fields * i + a] * field_[fields * i + b];
      return sum / whole;
    };
    double extent = 0;
    for (std::size_t field = 0; field < fields; ++field) {
      for (std::size_t i = begin; i < end; ++i)
        field_[fields * i + field] = field == 0 ? 1 : reference[held_[i].vertex][field - 1];
      const double given = std::sqrt(product(field, field));
      for (std::size_t before = 0; before < field; ++before) {
        const double share = product(before, field);
        for (std::size_t i = begin; i < end; ++i) field_[fields * i + field] -= share * field_[fields * i + before];
        if (before == 0) extent = std::max(extent, std::sqrt(product(field, field)));
      }
      const double size = std::sqrt(product(field, field));
      for (std::size_t i = begin; i < end; ++i) {
        double& f = field_[fields * i + field];
        f = size > std::max(minExtent * extent, rounding * given) ? f / size : 0;
      }
    }
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t k = 0; k < fields; ++k) fit_.push_back(held_[i].weight / whole * field_[fields * i + k]);
  }
}

void AffineResponse::addGradients(const HoldInput& input, const Positions& moved, std::size_t first) {
  const WeldedShape& shape = input.mesh.shape;
  const Positions& p = shape.poses[shape.reference];
  std::vector<double> area(planes_.size(), 0.0);
  for (int pass = 0; pass < 2; ++pass)
    for (std::size_t f = 0; f < shape.faces.size(); ++f) {
      const int patch = input.mesh.localFrameOf[f] < 0 ? -1 : input.patchOfFace[f];
      if (patch < 0) continue;
      const Triangle& t = shape.faces[f];
      const Vec3 normal = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
      const double size = normal.norm();
      if (pass == 0) {
        area[patch] += size;
        continue;
      }
      if (first == 0)
        planes_[patch] += size / area[patch] * (Mat3::Identity() - normal * normal.transpose() / (size * size));
      for (int c = 0; c < 3; ++c) {
        const Vec3 hat = (normal / size).cross(p[t[(c + 2) % 3]] - p[t[(c + 1) % 3]]) / area[patch];
        for (std::size_t k = 0; k < 3 && first + k < modes_; ++k)
          gradient_[modes_ * patch + first + k] += moved[t[c]][k] * hat;
      }
    }
}

void AffineResponse::fit(std::span<const Vec3> displacement, std::vector<Vec3>& mode) const {
  mode.assign(modes_, Vec3::Zero());
  for (std::size_t i = 0; i < held_.size(); ++i)
    for (std::size_t k = 0; k < fields; ++k) mode[fields * held_[i].pin + k] += fit_[fields * i + k] * displacement[i];
}

Vec3 AffineResponse::moved(std::size_t held, const std::vector<Vec3>& mode) const {
  return weightedSum(modes_, &response_[modes_ * held], mode.data());
}

Mat3 AffineResponse::gradient(std::size_t patch, const std::vector<Vec3>& mode) const {
  return outerProducts(modes_, mode.data(), &gradient_[modes_ * patch]);
}

}  // namespace shapespline
