#include "io/gltf/gltf_reader.h"

#include <algorithm>
#include <cmath>

#include "core/base/format.h"
#include "io/base/byte_text.h"
#include "io/base/sample_times.h"
#include "io/gltf/gltf_look.h"
#include "io/gltf/gltf_pose.h"
#include "io/gltf/gltf_vertices.h"
#include "io/gltf/project.h"

namespace shapespline {

namespace {

// Share of the progress that goes to the file itself, before its keys.
constexpr double kReading = 0.4;

void append(std::vector<Warning>& to, std::vector<Warning>&& from) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

// Nodes whose transforms place a vertex: mesh nodes, joints, and everything above them.
std::vector<char> placingNodes(const GltfDocument& doc, const GltfShape& shape) {
  std::vector<char> placing(doc.model.nodes.size(), 0);
  const auto markUp = [&](int node) {
    for (; node >= 0 && !placing[node]; node = shape.graph.parent[node]) placing[node] = 1;
  };
  for (const GltfPart& part : shape.parts) {
    if (part.influences == 0) markUp(part.node);
    else
      for (int joint : shape.skins[part.skin].joints) markUp(joint);
  }
  return placing;
}

// Animations that only move cameras, lights or hidden meshes are not offered.
Result<std::vector<GltfAnimation>> movingAnimations(const GltfDocument& doc, const GltfShape& shape) {
  auto animations = readAnimations(doc);
  if (!animations) return animations;
  const std::vector<char> placing = placingNodes(doc, shape);
  std::vector<char> morphing(doc.model.nodes.size(), 0);
  for (const GltfPart& part : shape.parts) morphing[part.node] |= !part.primitive->targets.empty();
  const auto moves = [&](const AnimationCurve& curve) {
    return curve.path == AnimationCurve::Path::Weights ? morphing[curve.node] : placing[curve.node];
  };
  std::erase_if(*animations,
                [&](const GltfAnimation& a) { return std::none_of(a.curves.begin(), a.curves.end(), moves); });
  return animations;
}

std::vector<AnimationInfo> infosOf(const std::vector<GltfAnimation>& animations) {
  std::vector<AnimationInfo> infos;
  for (const GltfAnimation& a : animations)
    infos.push_back({a.name, a.keyTimes.front(), a.keyTimes.back(), static_cast<int>(a.keyTimes.size())});
  return infos;
}

// What a pose's file could move by. Broken animations are no reason to refuse the pose.
std::vector<AnimationInfo> animationsOf(const GltfDocument& doc, const GltfShape& shape) {
  const auto animations = movingAnimations(doc, shape);
  return animations ? infosOf(*animations) : std::vector<AnimationInfo>();
}

// One file's keys in the making.
struct KeyReader {
  GltfDocument& doc;
  GltfShape& shape;
  const ImportOptions& options;
  const StageProgress& progress;
  std::vector<GltfAnimation> animations;
  Import out;
  std::uint64_t work = 0;

  Error error(ErrorCode code, const std::string& message) const { return {code, doc.where + message}; }

  int morphTargets() const {
    int most = 0;
    for (const GltfPart& part : shape.parts) most = std::max(most, static_cast<int>(part.primitive->targets.size()));
    return most;
  }

  Status checkSize(std::size_t keys) const { return checkKeyCount(keys, shape.vertexCount, doc.where); }

  void report(const char* stage, double fraction) const {
    if (progress) progress(stage, fraction);
  }

  // `count`: how many keys there will be. `animation`: what the state was taken from, or null.
  Status addKey(const std::string& name, double time, const SceneState& state, std::size_t count,
                const GltfAnimation* animation) {
    const auto onKey = [&, before = static_cast<double>(out.keyframes.keys.size())](double fraction) {
      report("taking the keys", kReading + (1 - kReading) * (before + fraction) / static_cast<double>(count));
    };
    onKey(0);
    const bool first = out.keyframes.keys.empty();
    const std::uint64_t cost = poseCost(shape, state) + (animation ? animationCost(*animation) : 0);
    work += cost;
    // The keys to come will take as much as this one, most likely.
    if (work > kMostPoseCost || cost > kMostPoseCost / count)
      return error(ErrorCode::TooLarge, ": its channels, morph targets and skins take too long to compute for " +
                                            grouped(std::int64_t(count)) + " keys. Take fewer keys.");
    auto positions = posedVertices(doc, shape, state, first ? &out.keyframes.normals : nullptr, onKey);
    if (!positions) return positions.error();
    out.keyframes.keys.push_back({name, time, std::move(*positions)});
    return {};
  }

  // The state in which exactly morph target `target` is on; -1 for the base.
  SceneState morphState(int target) const {
    SceneState state = restState(doc, shape);
    for (const GltfPart& part : shape.parts) {
      auto& weights = state.weights[part.node];
      weights.assign(target + 1, 0);
      if (target >= 0) weights[target] = 1;
    }
    return state;
  }

  std::string targetName(int target) const {
    for (const GltfPart& part : shape.parts) {
      const tinygltf::Value& extras = doc.model.meshes[part.mesh].extras;
      if (!extras.Has("targetNames")) continue;
      const tinygltf::Value& names = extras.Get("targetNames");
      if (names.IsArray() && target < static_cast<int>(names.ArrayLen()) && names.Get(target).IsString())
        return names.Get(target).Get<std::string>();
    }
    return "target " + std::to_string(target + 1);
  }

  Status takeMorphTargets() {
    const int targets = morphTargets();
    if (Status size = checkTargets(targets + 1, shape.vertexCount, doc.bufferBytes, doc.where); !size) return size;
    // A second from one to the next, as of poses that are files of their own.
    const auto keys = static_cast<std::size_t>(targets) + 1;
    for (int t = -1; t < targets; ++t)
      if (Status key = addKey(t < 0 ? "base" : targetName(t), t + 1, morphState(t), keys, nullptr); !key) return key;
    return {};
  }

  // The frames that a project file says are its keys.
  Status takeProject(const Project& project) {
    if (Status size = checkSize(project.keys.size()); !size) return size;
    for (const ProjectKey& key : project.keys) {
      const GltfAnimation* animation = key.frame >= 0 ? nullptr : &animations[0];
      SceneState state = animation ? restState(doc, shape) : morphState(key.frame - 1);
      if (animation) applyAnimation(*animation, key.seconds, state);
      if (Status added = addKey(key.name, key.time, state, project.keys.size(), animation); !added) return added;
    }
    out.project = doc.project;
    out.offset = project.offset;
    return {};
  }

  Result<int> chosenAnimation() const {
    if (const int* index = std::get_if<int>(&options.animation)) {
      if (*index >= 0 && *index < static_cast<int>(animations.size())) return *index;
      return error(ErrorCode::UnknownAnimation, " has no animation " + std::to_string(*index) + "; " + animationList());
    }
    if (const std::string* name = std::get_if<std::string>(&options.animation)) {
      for (std::size_t i = 0; i < animations.size(); ++i)
        if (animations[i].name == *name) return static_cast<int>(i);
      return error(ErrorCode::UnknownAnimation, " has no animation " + inQuotes(*name) + "; " + animationList());
    }
    return 0;
  }

  std::string animationList() const {
    if (animations.empty()) return "it has none.";
    std::string list = "it has";
    for (std::size_t i = 0; i < animations.size() && i < 20; ++i)
      list += (i ? ", " : " ") + std::to_string(i) + " " + inQuotes(animations[i].name);
    return list + (animations.size() > 20 ? ", and more." : ".");
  }

  Result<std::vector<double>> timesOf(const GltfAnimation& animation) {
    const bool ownTimes = options.sampleTimes.empty() && animations.size() == 1 && animation.weightsOnly &&
                          !options.sampleAsked && animation.keyTimes.size() >= 2 &&
                          animation.keyTimes.size() <= kMostOwnKeys;
    const bool everyFrame = options.everyFrame && options.sampleTimes.empty() && animation.keyTimes.size() >= 2;
    if (ownTimes || everyFrame) return animation.keyTimes;
    if (options.oneKeyWillDo && animation.keyTimes.size() == 1) return animation.keyTimes;
    return sampleTimes(options, animation.keyTimes.front(), animation.keyTimes.back(),
                       doc.where + ": the animation " + inQuotes(animation.name), out.warnings);
  }

  Status takeAnimation() {
    const auto chosen = chosenAnimation();
    if (!chosen) return chosen.error();
    const GltfAnimation& animation = animations[*chosen];
    const auto times = timesOf(animation);
    if (!times) return times.error();
    if (Status size = checkSize(times->size()); !size) return size;
    out.animation = *chosen;
    for (double t : *times) {
      SceneState state = restState(doc, shape);
      applyAnimation(animation, t, state);
      if (Status key = addKey(sampleName(t), t, state, times->size(), &animation); !key) return key;
    }
    return {};
  }

  Status takeKeys() {
    if (!doc.project.empty() && !options.animationAsked()) {
      auto project = parseProject(doc.project, morphTargets(), !animations.empty());
      if (project) return takeProject(*project);
      out.warnings.push_back({"project-ignored", doc.where + ": " + project.error().message, 0});
    }
    if (options.animationAsked() && animations.empty())
      return error(ErrorCode::UnknownAnimation, " has no animation that moves its mesh.");
    if (!animations.empty()) return takeAnimation();
    if (morphTargets() > 0) return takeMorphTargets();
    return error(ErrorCode::TooFewKeys,
                 " holds one pose only. Add a file for every other key, or give one file with "
                 "morph targets or an animation.");
  }

  Status read() {
    auto read = movingAnimations(doc, shape);
    if (!read) return read.error();
    animations = std::move(*read);
    out.animations = infosOf(animations);
    if (Status keys = takeKeys(); !keys) return keys;
    out.noteRounding(storedRounding(shape, restState(doc, shape)), doc.where);
    out.objects = std::move(shape.objects);
    out.scene = readLook(doc, shape);
    out.keyframes.faces = std::move(shape.faces);
    std::vector<Positions*> poses;
    for (Key& key : out.keyframes.keys) poses.push_back(&key.positions);
    joinVertices(doc, shape, poses, out.keyframes.normals, out.keyframes.faces, out.scene);
    append(out.warnings, std::move(doc.warnings));
    append(out.warnings, std::move(shape.warnings));
    return {};
  }
};

}  // namespace

Result<PoseFile> readGltfPose(const NamedBytes& file, std::span<const NamedBytes> files, const ImportOptions& options,
                              const std::string& where, const FractionReport& onProgress) {
  auto doc = openGltf(file, files, where);
  if (!doc) return doc.error();
  auto shape = readShape(*doc, options.objects, partOf(onProgress, 0.2, 0.6));
  if (!shape) return shape.error();
  PoseFile out;
  const SceneState rest = restState(*doc, *shape);
  if (poseCost(*shape, rest) > kMostPoseCost)
    return Error{ErrorCode::TooLarge,
                 where + ": its morph targets and skins take too long to compute. Export the pose as a plain mesh."};
  auto positions = posedVertices(*doc, *shape, rest, &out.normals, partOf(onProgress, 0.6, 1));
  if (!positions) return positions.error();
  out.positions = std::move(*positions);
  out.rounding = storedRounding(*shape, rest);
  out.animations = animationsOf(*doc, *shape);
  out.skinned = std::any_of(shape->parts.begin(), shape->parts.end(), [](auto& part) { return part.influences > 0; });
  out.objects = std::move(shape->objects);
  out.scene = readLook(*doc, *shape);
  out.faces = std::move(shape->faces);
  joinVertices(*doc, *shape, {&out.positions}, out.normals, out.faces, out.scene);
  append(out.warnings, std::move(doc->warnings));
  append(out.warnings, std::move(shape->warnings));
  return out;
}

Result<Import> readGltfKeys(const NamedBytes& file, std::span<const NamedBytes> files, const ImportOptions& options,
                            const std::string& where, const StageProgress& progress) {
  if (progress) progress("reading the file", 0);
  auto doc = openGltf(file, files, where);
  if (!doc) return doc.error();
  const auto onMesh = [&](double fraction) {
    if (progress) progress("reading the mesh", kReading / 2 * (1 + fraction));
  };
  onMesh(0);
  auto shape = readShape(*doc, options.objects, onMesh);
  if (!shape) return shape.error();
  KeyReader reader{*doc, *shape, options, progress, {}, {}};
  if (Status read = reader.read(); !read) return read.error();
  return std::move(reader.out);
}

}  // namespace shapespline
