#include "io/gltf/gltf_animation.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/format.h"
#include "io/gltf/gltf_accessor.h"
#include "io/gltf/gltf_shape.h"
#include "io/gltf/malformed.h"

namespace shapespline {

namespace {

using Path = AnimationCurve::Path;
using Interpolation = AnimationCurve::Interpolation;

// Numbers of all curves together: half a gigabyte. Channels may share their accessors, so that a small file could
// declare any amount.
constexpr std::uint64_t kMostNumbers = 64'000'000;

std::optional<Path> pathOf(const std::string& name) {
  if (name == "translation") return Path::Translation;
  if (name == "rotation") return Path::Rotation;
  if (name == "scale") return Path::Scale;
  if (name == "weights") return Path::Weights;
  return std::nullopt;
}

std::optional<Interpolation> interpolationOf(const std::string& name) {
  if (name.empty() || name == "LINEAR") return Interpolation::Linear;
  if (name == "STEP") return Interpolation::Step;
  if (name == "CUBICSPLINE") return Interpolation::CubicSpline;
  return std::nullopt;
}

int widthOf(const GltfDocument& doc, Path path, int node) {
  if (path == Path::Rotation) return 4;
  if (path != Path::Weights) return 3;
  const int mesh = doc.model.nodes[node].mesh;
  return mesh >= 0 && mesh < static_cast<int>(doc.model.meshes.size()) ? targetCount(doc.model.meshes[mesh]) : 0;
}

Result<AnimationCurve> readCurve(const GltfDocument& doc, const tinygltf::AnimationChannel& channel,
                                 const tinygltf::AnimationSampler& sampler, Path path, const std::string& name,
                                 std::uint64_t& numbers) {
  AnimationCurve curve;
  curve.path = path;
  curve.node = channel.target_node;
  curve.width = widthOf(doc, path, curve.node);
  if (curve.width == 0)
    return malformed(doc.where, name + " moves the morph weights of node " + std::to_string(curve.node) +
                                    ", which has no morph targets");
  const auto interpolation = interpolationOf(sampler.interpolation);
  if (!interpolation) return malformed(doc.where, name + " has an unknown interpolation");
  curve.interpolation = *interpolation;

  const int components = path == Path::Weights ? 1 : curve.width;
  numbers += accessorCount(doc, sampler.input) + std::uint64_t(components) * accessorCount(doc, sampler.output);
  if (numbers > kMostNumbers)
    return Error{ErrorCode::TooLarge,
                 doc.where + ": its animations hold more than " + grouped(kMostNumbers) +
                     " numbers, more than is supported. Export fewer animations or fewer key times."};
  auto times = readNumbers(doc, sampler.input, 1, "the times of " + name);
  if (!times) return times.error();
  if (times->empty()) return malformed(doc.where, name + " has no times");
  for (std::size_t i = 0; i < times->size(); ++i)
    if (!std::isfinite((*times)[i]) || (i > 0 && !((*times)[i] > (*times)[i - 1])))
      return malformed(doc.where, "the times of " + name + " do not increase at " + grouped(std::int64_t(i)));
  curve.times = std::move(*times);

  auto values = readNumbers(doc, sampler.output, components, "the values of " + name);
  if (!values) return values.error();
  const std::uint64_t perTime = std::uint64_t(curve.width) * (*interpolation == Interpolation::CubicSpline ? 3 : 1);
  if (values->size() < perTime * curve.times.size()) return malformed(doc.where, name + " has fewer values than times");
  if (std::any_of(values->begin(), values->end(), [](double v) { return !std::isfinite(v); }))
    return Error{ErrorCode::NotFinite,
                 doc.where + ": a value of " + name + " is not a finite number. Export the file again."};
  curve.values = std::move(*values);
  return curve;
}

Result<GltfAnimation> readAnimation(const GltfDocument& doc, int index, std::uint64_t& numbers) {
  const tinygltf::Animation& source = doc.model.animations[index];
  GltfAnimation out;
  out.name = source.name.empty() ? "animation " + std::to_string(index) : source.name;
  int lastInput = -1;  // most channels share their times with the one before
  for (std::size_t c = 0; c < source.channels.size(); ++c) {
    const tinygltf::AnimationChannel& channel = source.channels[c];
    const std::string name = "animation " + std::to_string(index) + ", channel " + std::to_string(c);
    const auto path = pathOf(channel.target_path);
    if (!path || channel.target_node < 0) continue;  // an extension's, such as KHR_animation_pointer
    if (channel.target_node >= static_cast<int>(doc.model.nodes.size()))
      return malformed(doc.where,
                       name + " moves node " + std::to_string(channel.target_node) + ", which does not exist");
    if (channel.sampler < 0 || channel.sampler >= static_cast<int>(source.samplers.size()))
      return malformed(doc.where, name + " has sampler " + std::to_string(channel.sampler) + ", which does not exist");
    const tinygltf::AnimationSampler& sampler = source.samplers[channel.sampler];
    auto curve = readCurve(doc, channel, sampler, *path, name, numbers);
    if (!curve) return curve.error();
    out.weightsOnly = out.weightsOnly && *path == Path::Weights;
    if (sampler.input != lastInput) out.keyTimes.insert(out.keyTimes.end(), curve->times.begin(), curve->times.end());
    lastInput = sampler.input;
    out.curves.push_back(std::move(*curve));
  }
  std::sort(out.keyTimes.begin(), out.keyTimes.end());
  out.keyTimes.erase(std::unique(out.keyTimes.begin(), out.keyTimes.end()), out.keyTimes.end());
  return out;
}

// Spherical interpolation, the short way round.
void slerp(const double* a, const double* b, double s, double* out) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(a).normalized().slerp(s, Eigen::Quaterniond(b).normalized());
  Eigen::Map<Eigen::Vector4d>(out, 4) = q.coeffs();
}

// The Hermite form of glTF 2.0, appendix C.4; tangents are per second, so scaled by the segment's length.
double hermite(double p0, double m0, double p1, double m1, double s, double length) {
  const double s2 = s * s, s3 = s2 * s;
  return (2 * s3 - 3 * s2 + 1) * p0 + (s3 - 2 * s2 + s) * length * m0 + (3 * s2 - 2 * s3) * p1 +
         (s3 - s2) * length * m1;
}

}  // namespace

void AnimationCurve::sample(double t, double* out) const {
  const bool cubic = interpolation == Interpolation::CubicSpline;
  const std::size_t step = static_cast<std::size_t>(width) * (cubic ? 3 : 1), centre = cubic ? width : 0;
  const auto hold = [&](std::size_t i) { std::copy_n(&values[i * step + centre], width, out); };
  const std::size_t next = std::upper_bound(times.begin(), times.end(), t) - times.begin();
  if (next == 0) return hold(0);
  if (next == times.size() || interpolation == Interpolation::Step) return hold(next - 1);
  const double length = times[next] - times[next - 1], s = (t - times[next - 1]) / length;
  const double *a = &values[(next - 1) * step], *b = &values[next * step];
  if (cubic)
    for (int c = 0; c < width; ++c) out[c] = hermite(a[width + c], a[2 * width + c], b[width + c], b[c], s, length);
  else if (path == Path::Rotation) slerp(a, b, s, out);
  else
    for (int c = 0; c < width; ++c) out[c] = a[c] + s * (b[c] - a[c]);
}

Result<std::vector<GltfAnimation>> readAnimations(const GltfDocument& doc) {
  std::vector<GltfAnimation> animations;
  std::uint64_t numbers = 0;
  for (std::size_t i = 0; i < doc.model.animations.size(); ++i) {
    auto animation = readAnimation(doc, static_cast<int>(i), numbers);
    if (!animation) return animation.error();
    if (!animation->curves.empty()) animations.push_back(std::move(*animation));
  }
  return animations;
}

std::uint64_t animationCost(const GltfAnimation& animation) {
  std::uint64_t cost = 0;
  for (const AnimationCurve& curve : animation.curves) cost += curve.width;
  return cost;
}

void applyAnimation(const GltfAnimation& animation, double t, SceneState& state) {
  for (const AnimationCurve& curve : animation.curves) {
    NodeTransform& local = state.local[curve.node];
    double value[4];
    if (curve.path == Path::Weights) {
      auto& weights = state.weights[curve.node];
      weights.resize(curve.width);
      curve.sample(t, weights.data());
      continue;
    }
    curve.sample(t, value);
    if (local.isMatrix) local.splitMatrix();
    if (curve.path == Path::Translation) local.translation = Vec3(value);
    if (curve.path == Path::Scale) local.scale = Vec3(value);
    if (curve.path == Path::Rotation) {
      const Eigen::Quaterniond q(value);
      local.rotation = q.norm() > 0 ? q.normalized() : Eigen::Quaterniond::Identity();
    }
  }
}

}  // namespace shapespline
