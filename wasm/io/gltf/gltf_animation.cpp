#include "io/gltf/gltf_animation.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/base/format.h"
#include "io/base/byte_text.h"
#include "io/gltf/gltf_accessor.h"
#include "io/gltf/gltf_shape.h"
#include "io/gltf/malformed.h"

namespace shapespline {

namespace {

using Path = AnimationCurve::Path;
using Interpolation = AnimationCurve::Interpolation;

// Limit of the numbers in all curves together: half a gigabyte. Channels may share accessors, so a small file could
// declare any amount.
constexpr std::uint64_t maxNumbers = 64'000'000;

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

int targetsOf(const GltfDocument& doc, int node) {
  const int mesh = doc.model.nodes[node].mesh;
  return mesh >= 0 && mesh < static_cast<int>(doc.model.meshes.size()) ? targetCount(doc.model.meshes[mesh]) : 0;
}

// The target of a channel: one node, or all nodes that show a mesh.
struct Target {
  Path path = Path::Translation;
  std::vector<int> nodes{};
  int weight = -1;  // index of a single weight, or -1 for all weights
};

int widthOf(const GltfDocument& doc, const Target& target) {
  switch (target.path) {
    case Path::Rotation: return 4;
    case Path::Visibility: return 1;
    case Path::Weights: return target.weight >= 0 ? 1 : targetsOf(doc, target.nodes[0]);
    default: return 3;
  }
}

Result<AnimationCurve> readCurve(const GltfDocument& doc, const tinygltf::AnimationSampler& sampler,
                                 const Target& target, const std::string& name, std::uint64_t& numbers) {
  AnimationCurve curve;
  curve.path = target.path;
  curve.node = target.nodes[0];
  curve.first = std::max(target.weight, 0);
  curve.width = widthOf(doc, target);
  if (target.path == Path::Weights && curve.first + curve.width > targetsOf(doc, curve.node))
    curve.width = 0;  // the weight does not exist
  if (curve.width == 0)
    return malformed(doc.where,
                     name + " moves the morph weights of node " + std::to_string(curve.node) +
                         (curve.first > 0 ? ", which has too few morph targets" : ", which has no morph targets"));
  const auto interpolation = interpolationOf(sampler.interpolation);
  if (!interpolation) return malformed(doc.where, name + " has an unknown interpolation");
  curve.interpolation = *interpolation;

  const int components = target.path == Path::Weights ? 1 : curve.width;
  const std::uint64_t more =
      accessorCount(doc, sampler.input) + std::uint64_t(components) * accessorCount(doc, sampler.output);
  if (numbers + more > maxNumbers)
    return Error{ErrorCode::TooLarge, doc.where + ": its animations exceed the limit of " + grouped(maxNumbers) +
                                          " numbers. Export fewer animations or fewer key times."};
  numbers += more;
  auto times = readNumbers(doc, sampler.input, 1, "the times of " + name);
  if (!times) return times.error();
  if (times->empty()) return malformed(doc.where, name + " has no times");
  for (std::size_t i = 0; i < times->size(); ++i)
    if (!std::isfinite((*times)[i]) || (i > 0 && (*times)[i] < (*times)[i - 1]))
      return malformed(doc.where, "the times of " + name + " do not increase at index " + grouped(std::int64_t(i)));
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

// Nodes whose morph weights come from the mesh.
std::vector<int> nodesOfMesh(const GltfDocument& doc, int mesh) {
  std::vector<int> nodes;
  for (std::size_t n = 0; n < doc.model.nodes.size(); ++n)
    if (doc.model.nodes[n].mesh == mesh && doc.model.nodes[n].weights.empty()) nodes.push_back(static_cast<int>(n));
  return nodes;
}

// Removes a part such as "/12" from a pointer and returns its number, or -1.
int takeNumber(std::string_view& pointer) {
  int number = -1;
  if (!pointer.starts_with('/')) return -1;
  const auto [end, error] = std::from_chars(pointer.data() + 1, pointer.data() + pointer.size(), number);
  if (error != std::errc() || number < 0) return -1;
  pointer.remove_prefix(static_cast<std::size_t>(end - pointer.data()));
  return number;
}

bool take(std::string_view& pointer, std::string_view start) {
  if (!pointer.starts_with(start)) return false;
  pointer.remove_prefix(start.size());
  return true;
}

// Parses the rest of a pointer to weights: empty for all weights, or the index of one weight.
bool takeWeights(std::string_view rest, Target& target) {
  target.path = Path::Weights;
  if (rest.empty()) return true;
  target.weight = takeNumber(rest);
  return target.weight >= 0 && rest.empty();
}

// Empty for pointers to other properties.
std::optional<Target> pointedAt(const GltfDocument& doc, std::string_view pointer) {
  Target target;
  if (take(pointer, "/meshes")) {
    const int mesh = takeNumber(pointer);
    if (mesh < 0) return std::nullopt;
    target.nodes = nodesOfMesh(doc, mesh);
    if (take(pointer, "/weights") && takeWeights(pointer, target)) return target;
    return std::nullopt;
  }
  if (!take(pointer, "/nodes")) return std::nullopt;
  const int node = takeNumber(pointer);
  if (node < 0) return std::nullopt;
  target.nodes = {node};
  if (pointer == "/extensions/KHR_node_visibility/visible") {
    target.path = Path::Visibility;
    return target;
  }
  if (take(pointer, "/weights")) return takeWeights(pointer, target) ? std::optional(target) : std::nullopt;
  if (!take(pointer, "/")) return std::nullopt;
  const auto path = pathOf(std::string(pointer));
  if (!path) return std::nullopt;
  target.path = *path;
  return target;
}

// Pointers with these starts move vertices. Others target materials, cameras, lights and the like.
bool mayMove(std::string_view pointer) {
  for (const char* start : {"/nodes/", "/meshes/", "/skins/", "/accessors/"})
    if (pointer.starts_with(start)) return pointer.find("/extensions/") == std::string_view::npos;
  return false;
}

std::string pointerOf(const tinygltf::AnimationChannel& channel) {
  const auto extension = channel.target_extensions.find("KHR_animation_pointer");
  if (extension == channel.target_extensions.end()) return "";
  const tinygltf::Value& pointer = extension->second.Get("pointer");
  return pointer.IsString() ? pointer.Get<std::string>() : "";
}

struct AnimationReader {
  const GltfDocument& doc;
  std::vector<Warning>& warnings;
  std::uint64_t numbers = 0;  // total of all curves
  int ignoredPointers = 0;
  std::string firstIgnored{};

  // Returns nothing if the channel's target is not supported here.
  std::optional<Target> targetOf(const tinygltf::AnimationChannel& channel) {
    if (channel.target_path == "pointer") {
      const std::string pointer = pointerOf(channel);
      auto target = pointedAt(doc, pointer);
      if (!target && mayMove(pointer) && ++ignoredPointers == 1) firstIgnored = pointer;
      return target && !target->nodes.empty() ? target : std::nullopt;
    }
    const auto path = pathOf(channel.target_path);
    if (!path || channel.target_node < 0) return std::nullopt;
    return Target{*path, {channel.target_node}, -1};
  }

  Result<AnimationCurve> curveOf(const tinygltf::Animation& source, int sampler, const Target& target,
                                 const std::string& name) {
    if (const std::string wrong = brokenPart(source.extras); !wrong.empty()) return malformed(doc.where, name + wrong);
    if (sampler < 0 || sampler >= static_cast<int>(source.samplers.size()))
      return malformed(doc.where, name + " has sampler " + std::to_string(sampler) + ", which does not exist");
    if (target.nodes[0] >= static_cast<int>(doc.model.nodes.size()))
      return malformed(doc.where, name + " moves node " + std::to_string(target.nodes[0]) + ", which does not exist");
    return readCurve(doc, source.samplers[sampler], target, name, numbers);
  }

  void addCurves(GltfAnimation& out, const tinygltf::Animation& source, int sampler, const Target& target,
                 const std::string& name) {
    const int count = static_cast<int>(doc.model.nodes.size());
    for (int node : target.nodes) {
      auto curve = curveOf(source, sampler, {target.path, {node}, target.weight}, name);
      if (!curve && !out.error) out.error = curve.error();
      AnimationCurve unread;
      unread.path = target.path;
      unread.node = node < count ? node : -1;
      out.curves.push_back(curve ? std::move(*curve) : unread);
    }
  }

  GltfAnimation read(int index) {
    const tinygltf::Animation& source = doc.model.animations[index];
    GltfAnimation out;
    out.index = index;
    out.name = source.name.empty() ? "animation " + std::to_string(index) : source.name;
    int lastInput = -1;  // most channels share the time accessor of the previous channel
    for (std::size_t c = 0; c < source.channels.size(); ++c) {
      const tinygltf::AnimationChannel& channel = source.channels[c];
      const std::string name = "animation " + std::to_string(index) + ", channel " + std::to_string(c);
      const auto target = targetOf(channel);
      if (!target) continue;
      addCurves(out, source, channel.sampler, *target, name);
      out.weightsOnly = out.weightsOnly && target->path == Path::Weights;
      if (out.error) continue;
      const std::vector<double>& times = out.curves.back().times;
      const int input = source.samplers[channel.sampler].input;
      if (input != lastInput) out.keyTimes.insert(out.keyTimes.end(), times.begin(), times.end());
      lastInput = input;
    }
    sortOnce(out.keyTimes);
    return out;
  }

  void warnOfIgnored() {
    if (ignoredPointers > 0)
      warnings.push_back({"pointer-ignored",
                          doc.where + ": animations of " + inQuotes(firstIgnored) +
                              (ignoredPointers > 1 ? " and others" : "") +
                              " (KHR_animation_pointer) are ignored. If the motion looks wrong, export it as "
                              "node animations.",
                          ignoredPointers});
  }
};

// Spherical interpolation along the shorter arc.
void slerp(const double* a, const double* b, double s, double* out) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(a).normalized().slerp(s, Eigen::Quaterniond(b).normalized());
  Eigen::Map<Eigen::Vector4d>(out, 4) = q.coeffs();
}

// The Hermite form of glTF 2.0, appendix C.4. Tangents are per second, so they are scaled by the segment's length.
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
  if (next == times.size() || interpolation == Interpolation::Step || path == Path::Visibility) return hold(next - 1);
  const double length = times[next] - times[next - 1], s = (t - times[next - 1]) / length;
  const double *a = &values[(next - 1) * step], *b = &values[next * step];
  if (cubic)
    for (int c = 0; c < width; ++c) out[c] = hermite(a[width + c], a[2 * width + c], b[width + c], b[c], s, length);
  else if (path == Path::Rotation) slerp(a, b, s, out);
  else
    for (int c = 0; c < width; ++c) out[c] = a[c] + s * (b[c] - a[c]);
}

bool AnimationCurve::varies() const {
  const std::size_t step = static_cast<std::size_t>(width) * (interpolation == Interpolation::CubicSpline ? 3 : 1);
  const std::size_t centre = step > static_cast<std::size_t>(width) ? width : 0;
  double most = path == Path::Translation ? 0 : 1;
  for (std::size_t i = 0; i < times.size(); ++i)
    for (int c = 0; c < width; ++c) most = std::max(most, std::abs(values[i * step + centre + c]));
  const double near = 1e-6 * most;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double *first = &values[centre], *value = &values[i * step + centre];
    double apart = 0, opposite = 0;
    for (int c = 0; c < width; ++c) {
      apart = std::max(apart, std::abs(value[c] - first[c]));
      opposite = std::max(opposite, std::abs(value[c] + first[c]));
    }
    // A quaternion and its negative are the same rotation.
    if (apart > near && (path != Path::Rotation || opposite > near)) return true;
  }
  // A cubic spline with nonzero slopes moves between equal values.
  if (interpolation == Interpolation::CubicSpline && times.size() > 1)
    for (std::size_t i = 0; i < times.size(); ++i)
      for (int c = 0; c < width; ++c)
        if (std::abs(values[i * step + c]) > near || std::abs(values[i * step + 2 * centre + c]) > near) return true;
  return false;
}

std::vector<double> AnimationCurve::cuts() const {
  const std::size_t step = static_cast<std::size_t>(width) * (interpolation == Interpolation::CubicSpline ? 3 : 1);
  const std::size_t centre = step > static_cast<std::size_t>(width) ? width : 0;
  std::vector<double> out;
  // The first of equal times counts before the cut, and the last from then on.
  for (std::size_t i = 0, last = 0; i < times.size(); i = last + 1) {
    last = std::upper_bound(times.begin() + i, times.end(), times[i]) - times.begin() - 1;
    const double *before = &values[i * step + centre], *after = &values[last * step + centre];
    if (!std::equal(before, before + width, after)) out.push_back(times[i]);
  }
  return out;
}

std::vector<GltfAnimation> readAnimations(const GltfDocument& doc, std::vector<Warning>& warnings) {
  std::vector<GltfAnimation> animations;
  AnimationReader reader{doc, warnings};
  for (std::size_t i = 0; i < doc.model.animations.size(); ++i) {
    GltfAnimation animation = reader.read(static_cast<int>(i));
    if (!animation.curves.empty()) animations.push_back(std::move(animation));
  }
  reader.warnOfIgnored();
  return animations;
}

void sortOnce(std::vector<double>& times) {
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
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
      weights.resize(std::max<std::size_t>(weights.size(), curve.first + curve.width));
      curve.sample(t, weights.data() + curve.first);
      continue;
    }
    curve.sample(t, value);
    if (curve.path == Path::Visibility) {
      state.visible[curve.node] = value[0] != 0;
      continue;
    }
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
