#include "io/gltf/gltf_reader.h"

#include <algorithm>
#include <string>

#include "core/base/format.h"
#include "io/base/byte_text.h"
#include "io/base/objects.h"
#include "io/base/sample_times.h"
#include "io/gltf/gltf_look.h"
#include "io/gltf/gltf_pose.h"
#include "io/gltf/gltf_scene.h"
#include "io/gltf/gltf_targets.h"
#include "io/gltf/gltf_vertices.h"
#include "io/gltf/project.h"

namespace shapespline {

namespace {

// Share of the progress for the file itself, before its keys.
constexpr double readingShare = 0.4;

void append(std::vector<Warning>& to, std::vector<Warning>&& from) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

// Whether the file assigns joints to its vertices. Otherwise the mesh's node places the mesh.
bool hasInfluences(const tinygltf::Mesh& mesh) {
  return std::any_of(mesh.primitives.begin(), mesh.primitives.end(), [](const tinygltf::Primitive& primitive) {
    return primitive.attributes.count("JOINTS_0") > 0 && primitive.attributes.count("WEIGHTS_0") > 0;
  });
}

// Nodes with transforms that place a vertex: mesh nodes, joints, and all their ancestors.
std::vector<char> placingNodes(const GltfDocument& doc, const NodeGraph& graph, const std::vector<int>& meshNodes) {
  const int count = static_cast<int>(doc.model.nodes.size());
  std::vector<char> placing(count, 0);
  const auto markUp = [&](int node) {
    for (; node >= 0 && node < count && !placing[node]; node = graph.parent[node]) placing[node] = 1;
  };
  for (int at : meshNodes) {
    const tinygltf::Node& node = doc.model.nodes[at];
    const bool skinned = node.skin >= 0 && node.skin < static_cast<int>(doc.model.skins.size()) &&
                         hasInfluences(doc.model.meshes[node.mesh]);
    if (skinned)
      for (int joint : doc.model.skins[node.skin].joints) markUp(joint);
    else markUp(at);
  }
  return placing;
}

// Excludes animations that only move cameras, lights or other meshes.
Result<std::vector<GltfAnimation>> movingAnimations(const GltfDocument& doc, const NodeGraph& graph,
                                                    const std::vector<int>& meshNodes, std::vector<Warning>& warnings) {
  auto animations = readAnimations(doc, warnings);
  if (!animations) return animations;
  const std::vector<char> placing = placingNodes(doc, graph, meshNodes);
  std::vector<char> morphing(doc.model.nodes.size(), 0);
  for (int node : meshNodes) morphing[node] = targetCount(doc.model.meshes[doc.model.nodes[node].mesh]) > 0;
  const auto poses = [&](const AnimationCurve& curve) {
    if (curve.path == AnimationCurve::Path::Visibility) return false;
    return (curve.path == AnimationCurve::Path::Weights ? morphing[curve.node] : placing[curve.node]) != 0;
  };
  std::erase_if(*animations,
                [&](const GltfAnimation& a) { return std::none_of(a.curves.begin(), a.curves.end(), poses); });
  for (GltfAnimation& a : *animations)
    a.moves = std::any_of(a.curves.begin(), a.curves.end(),
                          [&](const AnimationCurve& curve) { return poses(curve) && curve.varies(); });
  return animations;
}

std::vector<AnimationInfo> infosOf(const std::vector<GltfAnimation>& animations) {
  std::vector<AnimationInfo> infos;
  for (const GltfAnimation& a : animations)
    infos.push_back({a.name, a.keyTimes.front(), a.keyTimes.back(), static_cast<int>(a.keyTimes.size()), a.moves});
  return infos;
}

// Animations that could pose the file. A broken animation is not an error for the pose.
std::vector<GltfAnimation> animationsOf(const GltfDocument& doc, const NodeGraph& graph,
                                        const std::vector<int>& meshNodes) {
  std::vector<Warning> unsaid;
  auto animations = movingAnimations(doc, graph, meshNodes, unsaid);
  return animations ? std::move(*animations) : std::vector<GltfAnimation>();
}

bool hidesMeshes(const GltfScene& scene) {
  return visibleNodes(scene, scene.meshNodes, scene.graph.visible).size() < scene.meshNodes.size();
}

Error allHidden(const GltfDocument& doc) {
  return {ErrorCode::NoTriangles, doc.where +
                                      " has only hidden meshes (KHR_node_visibility). Export it "
                                      "with a visible mesh."};
}

// The visible mesh nodes with these names. Errors: UnknownObject; NoTriangles if all are hidden.
Result<std::vector<int>> shownNodes(const GltfDocument& doc, const GltfScene& scene, const std::vector<char>& visible,
                                    const std::vector<std::string>& objects) {
  const std::vector<int> seen = visibleNodes(scene, scene.meshNodes, visible);
  std::vector<int> wanted = namedNodes(doc, seen, objects);
  if (wanted.empty() && !namedNodes(doc, scene.meshNodes, objects).empty()) return allHidden(doc);
  if (Status known = checkObjects(objects, objectNames(doc, seen), doc.where); !known) return known.error();
  return wanted;
}

// A key to compute: a state of the scene.
struct PlannedKey {
  std::string name;
  double time = 0;
  const GltfAnimation* animation = nullptr;
  double seconds = 0;  // time in the animation
  int target = -1;     // without animation: index of the active joined morph target, or -1
};

// Reads the keys of one file: plans them, then computes their shapes.
struct KeyReader {
  GltfDocument& doc;
  const GltfScene& scene;
  const ImportOptions& options;
  const StageProgress& progress;
  std::vector<GltfAnimation> animations{};
  JoinedTargets targets{};
  std::vector<PlannedKey> plan{};
  std::size_t keysOfFile = 1;  // number of keys requested by the file, not by the user
  Import out{};
  std::uint64_t work = 0;

  Error error(ErrorCode code, const std::string& message) const { return {code, doc.where + message}; }

  void report(const char* stage, double fraction) const {
    if (progress) progress(stage, fraction);
  }

  // Planning keys.

  void planMorphTargets() {
    // Morph targets are one second apart, like poses in separate files.
    for (int t = -1; t < targets.count(); ++t)
      plan.push_back({t < 0 ? "base" : targets.names[t], t + 1.0, nullptr, 0, t});
    keysOfFile = plan.size();
  }

  // Plans the frames listed as keys in a project file.
  void planProject(const Project& project) {
    for (const ProjectKey& key : project.keys)
      plan.push_back({key.name, key.time, key.frame >= 0 ? nullptr : &animations[0], key.seconds, key.frame - 1});
    keysOfFile = plan.size();
    out.project = doc.project;
    out.offset = project.offset;
  }

  // Plans one pose per animation.
  void planPoses(std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count; ++i)
      plan.push_back({animations[i].name, static_cast<double>(i - first), &animations[i], animations[i].keyTimes[0]});
    keysOfFile = plan.size();
  }

  Result<int> chosenAnimation() const {
    const auto unknown = [&](const std::string& which) {
      return error(ErrorCode::UnknownAnimation, " has no animation " + which + "; " + animationList());
    };
    int chosen = -1;
    if (const int* index = std::get_if<int>(&options.animation)) {
      if (*index < 0 || *index >= static_cast<int>(animations.size())) return unknown(std::to_string(*index));
      chosen = *index;
    } else if (const std::string* name = std::get_if<std::string>(&options.animation)) {
      const auto called = [&](const GltfAnimation& a) { return a.name == *name; };
      // If several animations share the name, prefer one that moves.
      const auto moving = [&](const GltfAnimation& a) { return called(a) && a.moves; };
      auto found = std::find_if(animations.begin(), animations.end(), moving);
      if (found == animations.end()) found = std::find_if(animations.begin(), animations.end(), called);
      if (found == animations.end()) return unknown(inQuotes(*name));
      chosen = static_cast<int>(found - animations.begin());
    } else {
      chosen = firstMoving();
    }
    return chosen;
  }

  int firstMoving() const {
    const auto first = std::find_if(animations.begin(), animations.end(), [](const auto& a) { return a.moves; });
    return first == animations.end() ? -1 : static_cast<int>(first - animations.begin());
  }

  std::string animationList() const {
    if (animations.empty()) return "it has none.";
    std::string list = "it has";
    for (std::size_t i = 0; i < animations.size() && i < 20; ++i)
      list.append(i ? ", " : " ").append(std::to_string(i)).append(" ").append(inQuotes(animations[i].name));
    return list + (animations.size() > 20 ? ", and more." : ".");
  }

  // Advice if the requested animation has a single pose.
  std::string insteadOfPose() const {
    std::string list;
    int count = 0;
    for (std::size_t i = 0; i < animations.size(); ++i)
      if (animations[i].moves && ++count <= 20)
        list.append(count > 1 ? ", " : " ").append(std::to_string(i)).append(" ").append(inQuotes(animations[i].name));
    if (count > 0) return " Choose an animation that moves:" + list + (count > 20 ? ", and more." : ".");
    if (animations.size() > 1) return " Omit the animation and the samples. Each animation then becomes a key.";
    return " Add one file for each further key.";
  }

  Result<std::vector<double>> timesOf(const GltfAnimation& animation) {
    const bool lone = std::count_if(animations.begin(), animations.end(), [](const auto& a) { return a.moves; }) == 1;
    const bool ownTimes = options.sampleTimes.empty() && lone && animation.weightsOnly && !options.sampleAsked &&
                          animation.keyTimes.size() >= 2 && animation.keyTimes.size() <= mostOwnKeys;
    const bool everyFrame = options.everyFrame && options.sampleTimes.empty() && animation.keyTimes.size() >= 2;
    // The file requests these keys, not the user.
    if (everyFrame) keysOfFile = animation.keyTimes.size();
    if (ownTimes || everyFrame) return animation.keyTimes;
    return sampleTimes(options, animation.keyTimes.front(), animation.keyTimes.back(),
                       doc.where + ": the animation " + inQuotes(animation.name), out.warnings);
  }

  Status planAnimation(int chosen) {
    const GltfAnimation& animation = animations[chosen];
    const auto times = timesOf(animation);
    if (!times) return times.error();
    out.animation = chosen;
    for (double t : *times) plan.push_back({sampleName(t), t, &animation, t});
    return {};
  }

  // Handles files without a moving animation, and requests for a still one.
  Status planStill(int chosen) {
    if (options.oneKeyWillDo) {
      if (chosen >= 0) planPoses(chosen, 1);
      else planPoses(0, animations.size());
      return {};
    }
    if (options.animationAsked()) {
      const std::string which =
          chosen < 0 ? ": each of its animations" : ": the animation " + inQuotes(animations[chosen].name);
      return error(ErrorCode::TooFewKeys, which + " is one pose." + insteadOfPose());
    }
    if (animations.size() > 1) planPoses(0, animations.size());
    else if (targets.count() > 0) planMorphTargets();
    else return error(ErrorCode::TooFewKeys, onePose());
    return {};
  }

  static std::string onePose() {
    return " has only one pose. Add one file for each further key, or give one file with morph targets or an "
           "animation.";
  }

  Status planKeys() {
    if (!doc.project.empty() && !options.animationAsked()) {
      auto project = parseProject(doc.project, targets.count(), !animations.empty());
      if (project) return planProject(*project), Status();
      out.warnings.push_back({"project-ignored", doc.where + ": " + project.error().message, 0});
    }
    if (animations.empty()) {
      if (options.animationAsked()) return error(ErrorCode::UnknownAnimation, " has no animation that moves its mesh.");
      if (targets.count() == 0) return error(ErrorCode::TooFewKeys, onePose());
      return planMorphTargets(), Status();
    }
    const auto chosen = chosenAnimation();
    if (!chosen) return chosen.error();
    return *chosen >= 0 && animations[*chosen].moves ? planAnimation(*chosen) : planStill(*chosen);
  }

  // Computing shapes.

  SceneState stateOf(const PlannedKey& key) const {
    SceneState state = restState(doc, scene.graph);
    if (key.animation) {
      applyAnimation(*key.animation, key.seconds, state);
      return state;
    }
    for (int node : scene.meshNodes) {
      const std::vector<int>& slots = targets.slots[doc.model.nodes[node].mesh];
      std::vector<double>& weights = state.weights[node];
      weights.assign(slots.size(), 0);
      for (std::size_t t = 0; t < slots.size(); ++t)
        if (slots[t] == key.target) weights[t] = 1;
    }
    return state;
  }

  Status addKey(const GltfShape& shape, const PlannedKey& key, const SceneState& state) {
    const std::size_t count = plan.size();
    const auto onKey = [&, before = static_cast<double>(out.keyframes.keys.size())](double fraction) {
      report("sampling the keys", readingShare + (1 - readingShare) * (before + fraction) / static_cast<double>(count));
    };
    onKey(0);
    const bool first = out.keyframes.keys.empty();
    const std::uint64_t cost = poseCost(shape, state) + (key.animation ? animationCost(*key.animation) : 0);
    work += cost;
    // Later keys will probably cost the same as this one.
    const std::uint64_t most = mostPoseCost(doc.fileBytes);
    if (work > most || cost > most / count)
      return error(ErrorCode::TooLarge, ": its channels, morph targets and skins take too long to compute for " +
                                            grouped(std::int64_t(count)) + " keys. Use fewer keys.");
    auto positions = posedVertices(doc, shape, state, first ? &out.keyframes.normals : nullptr, onKey);
    if (!positions) return positions.error();
    out.keyframes.keys.push_back({key.name, key.time, std::move(*positions)});
    return {};
  }

  // `nodes`: mesh nodes visible in the first key, given the visibility `visible`.
  Status addKeys(const GltfShape& shape, const std::vector<int>& nodes, const std::vector<char>& visible) {
    int changes = 0;
    const std::vector<int> wanted = namedNodes(doc, scene.meshNodes, options.objects);
    for (const PlannedKey& key : plan) {
      const SceneState state = stateOf(key);
      if (state.visible != visible) changes += visibleNodes(scene, wanted, state.visible) != nodes;
      if (Status added = addKey(shape, key, state); !added) return added;
    }
    if (changes > 0)
      out.warnings.push_back({"visibility-changes",
                              doc.where + ": the visible meshes of some keys differ from those of key 1 "
                                          "(KHR_node_visibility). The meshes of key 1 are shown.",
                              changes});
    return {};
  }

  // Reports errors of the mesh before errors of the keys.
  Status checkMesh(const std::vector<int>& nodes) const {
    if (Status fits = checkAmount(doc, nodes, {}); !fits) return fits;
    const auto shape = readShape(doc, scene.graph, nodes);
    return shape ? Status() : Status(shape.error());
  }

  Status read() {
    const std::vector<int> wanted = namedNodes(doc, scene.meshNodes, options.objects);
    auto moving = movingAnimations(doc, scene.graph, wanted, out.warnings);
    if (!moving) return moving.error();
    animations = std::move(*moving);
    out.animations = infosOf(animations);
    targets = joinTargets(doc, visibleNodes(scene, wanted, scene.graph.visible));
    // Reports errors of the objects before errors of the keys.
    const auto atRest = shownNodes(doc, scene, scene.graph.visible, options.objects);
    if (!atRest && atRest.error().code == ErrorCode::UnknownObject) return atRest.error();
    if (Status planned = planKeys(); !planned) {
      if (planned.error().code != ErrorCode::TooFewKeys) return planned;
      const Status sound = atRest ? checkMesh(*atRest) : Status(atRest.error());
      return sound ? planned : sound;
    }
    const auto visible = plan.empty() ? scene.graph.visible : stateOf(plan[0]).visible;
    const auto nodes = shownNodes(doc, scene, visible, options.objects);
    if (!nodes) return nodes.error();
    if (Status fits = checkAmount(doc, *nodes, {plan.size(), keysOfFile}); !fits) return fits;
    auto shape = readShape(doc, scene.graph, *nodes,
                           [&](double fraction) { report("reading the mesh", readingShare / 2 * (1 + fraction)); });
    if (!shape) return shape.error();
    if (Status added = addKeys(*shape, *nodes, visible); !added) return added;
    out.objects = objectNames(doc, visibleNodes(scene, scene.meshNodes, visible));
    out.noteRounding(storedRounding(*shape, restState(doc, scene.graph)), doc.where);
    out.scene = readLook(doc, *shape);
    out.keyframes.faces = std::move(shape->faces);
    std::vector<Positions*> poses;
    for (Key& key : out.keyframes.keys) poses.push_back(&key.positions);
    joinVertices(doc, *shape, poses, out.keyframes.normals, out.keyframes.faces, out.scene);
    out.scene.objects = std::move(shape->objects);
    append(out.warnings, std::move(doc.warnings));
    append(out.warnings, std::move(shape->warnings));
    return {};
  }
};

}  // namespace

Result<PoseFile> readGltfPose(const NamedBytes& file, const GivenFiles& files, const ImportOptions& options,
                              const std::string& where, const FractionReport& onProgress) {
  auto doc = openGltf(file, files, where);
  if (!doc) return doc.error();
  const auto scene = readScene(*doc);
  if (!scene) return scene.error();
  const std::vector<char> visible =
      options.withHidden ? std::vector<char>(scene->graph.visible.size(), 1) : scene->graph.visible;
  const auto nodes = shownNodes(*doc, *scene, visible, options.objects);
  if (!nodes) return nodes.error();
  if (Status fits = checkAmount(*doc, *nodes, {}); !fits) return fits.error();
  auto shape = readShape(*doc, scene->graph, *nodes, partOf(onProgress, 0.2, 0.6));
  if (!shape) return shape.error();
  PoseFile out;
  SceneState state = restState(*doc, scene->graph);
  const std::vector<GltfAnimation> animations = animationsOf(*doc, scene->graph, *nodes);
  out.isPosed = animations.size() == 1 && !animations[0].moves;
  if (options.posedByActions && out.isPosed) {
    applyAnimation(animations[0], animations[0].keyTimes[0], state);
    out.action = animations[0].name;
  }
  if (poseCost(*shape, state) > mostPoseCost(doc->fileBytes))
    return Error{ErrorCode::TooLarge,
                 where + ": its morph targets and skins take too long to compute. Export the pose as a plain mesh."};
  auto positions = posedVertices(*doc, *shape, state, &out.normals, partOf(onProgress, 0.6, 1));
  if (!positions) return positions.error();
  out.positions = std::move(*positions);
  out.rounding = storedRounding(*shape, state);
  out.animations = infosOf(animations);
  out.hides = hidesMeshes(*scene);
  out.skinned = std::any_of(shape->parts.begin(), shape->parts.end(), [](auto& part) { return part.influences > 0; });
  out.objects = objectNames(*doc, visibleNodes(*scene, scene->meshNodes, visible));
  out.scene = readLook(*doc, *shape);
  out.faces = std::move(shape->faces);
  joinVertices(*doc, *shape, {&out.positions}, out.normals, out.faces, out.scene);
  out.scene.objects = std::move(shape->objects);
  append(out.warnings, std::move(doc->warnings));
  append(out.warnings, std::move(shape->warnings));
  return out;
}

Result<Import> readGltfKeys(const NamedBytes& file, const GivenFiles& files, const ImportOptions& options,
                            const std::string& where, const StageProgress& progress) {
  if (progress) progress("reading the file", 0);
  auto doc = openGltf(file, files, where);
  if (!doc) return doc.error();
  if (progress) progress("reading the mesh", readingShare / 2);
  const auto scene = readScene(*doc);
  if (!scene) return scene.error();
  KeyReader reader{*doc, *scene, options, progress};
  if (Status read = reader.read(); !read) return read.error();
  return std::move(reader.out);
}

}  // namespace shapespline
