#include "io/gltf/gltf_reader.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>

#include "core/base/format.h"
#include "io/base/byte_text.h"
#include "io/base/objects.h"
#include "io/base/sample_times.h"
#include "io/gltf/gltf_materials.h"
#include "io/gltf/gltf_pose.h"
#include "io/gltf/gltf_scene.h"
#include "io/gltf/gltf_targets.h"
#include "io/gltf/gltf_together.h"
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

// Animations that pose the mesh, and those among them that cannot be read.
struct PosingAnimations {
  std::vector<GltfAnimation> sound, broken;
};

// Excludes animations that only move cameras, lights or other meshes.
PosingAnimations posingAnimations(const GltfDocument& doc, const NodeGraph& graph, const std::vector<int>& meshNodes,
                                  std::vector<GltfAnimation>&& all) {
  PosingAnimations out;
  auto& animations = out.sound = std::move(all);
  const std::vector<char> placing = placingNodes(doc, graph, meshNodes);
  std::vector<char> morphing(doc.model.nodes.size(), 0);
  for (int node : meshNodes) morphing[node] = targetCount(doc.model.meshes[doc.model.nodes[node].mesh]) > 0;
  const auto poses = [&](const AnimationCurve& curve) {
    if (curve.path == AnimationCurve::Path::Visibility) return false;
    if (curve.node < 0) return true;  // a broken animation of an unknown node
    return (curve.path == AnimationCurve::Path::Weights ? morphing[curve.node] : placing[curve.node]) != 0;
  };
  std::erase_if(animations,
                [&](const GltfAnimation& a) { return std::none_of(a.curves.begin(), a.curves.end(), poses); });
  const auto firstBroken =
      std::stable_partition(animations.begin(), animations.end(), [](const GltfAnimation& a) { return !a.error; });
  std::move(firstBroken, animations.end(), std::back_inserter(out.broken));
  animations.erase(firstBroken, animations.end());
  const std::vector<int> objects = objectsOf(doc, graph);
  for (GltfAnimation& a : animations) {
    std::set<int> moved;
    a.moves = false;
    for (const AnimationCurve& curve : a.curves) {
      if (!poses(curve)) continue;
      a.moves = a.moves || curve.varies();
      moved.insert(objects[curve.node]);
      const auto cuts = curve.cuts();
      a.cuts.insert(a.cuts.end(), cuts.begin(), cuts.end());
    }
    a.moves = a.moves && a.keyTimes.size() > 1;
    a.object = moved.size() == 1 ? *moved.begin() : -1;
    sortOnce(a.cuts);
    std::erase(a.cuts, a.keyTimes.front());  // nothing is shown before the start
  }
  return out;
}

std::vector<AnimationInfo> infosOf(const std::vector<GltfAnimation>& animations) {
  std::vector<AnimationInfo> infos;
  for (const GltfAnimation& a : animations)
    infos.push_back({a.name, a.keyTimes.front(), a.keyTimes.back(), static_cast<int>(a.keyTimes.size()), a.moves, {}});
  return infos;
}

// Animations that could pose the file. A broken animation is not an error for the pose.
std::vector<GltfAnimation> animationsOf(const GltfDocument& doc, const NodeGraph& graph,
                                        const std::vector<int>& meshNodes) {
  std::vector<Warning> unsaid;
  return posingAnimations(doc, graph, meshNodes, readAnimations(doc, unsaid)).sound;
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
  std::vector<GltfAnimation> borrowed{};  // of files without a mesh
  std::vector<GltfAnimation> animations{}, broken{};
  std::vector<std::vector<int>> groups{};  // animations offered together; in the list, they follow the animations
  GltfAnimation together{};                // the chosen group as one animation
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
    if (const int* index = std::get_if<int>(&options.animation)) {
      if (*index < 0 || *index >= static_cast<int>(out.animations.size())) return unknown(std::to_string(*index));
      return *index;
    }
    if (const std::string* name = std::get_if<std::string>(&options.animation)) {
      const auto& infos = out.animations;
      const auto called = [&](const auto& a) { return a.name == *name; };
      // If several animations share the name, prefer one that moves.
      auto found = std::find_if(infos.begin(), infos.end(), [&](const auto& a) { return called(a) && a.moves; });
      if (found == infos.end()) found = std::find_if(infos.begin(), infos.end(), called);
      if (found != infos.end()) return static_cast<int>(found - infos.begin());
      const auto bad = std::find_if(broken.begin(), broken.end(), called);
      if (bad != broken.end()) return *bad->error;
      return *name == "all" ? allAnimations() : unknown(inQuotes(*name));
    }
    const int first = firstMoving();
    if (!broken.empty() && (first < 0 || broken[0].index < animations[first].index)) {
      Error error = *broken[0].error;
      if (first >= 0)
        error.message += " Or choose another animation (on the command line, with --animation): " + animationList();
      return error;
    }
    return first < 0 ? first : defaultOf(first);
  }

  // The group of all animations.
  Result<int> allAnimations() const {
    if (!broken.empty()) return *broken[0].error;
    if (firstMoving() < 0) return -1;
    const std::vector<int> all = allTogether(animations);
    if (all.size() == 1) return all[0];
    if (!all.empty()) return groupIndex(all);
    return error(ErrorCode::UnknownAnimation,
                 ": its animations move the same parts, so they cannot play together. Choose one; " + animationList());
  }

  int groupIndex(const std::vector<int>& parts) const {
    return static_cast<int>(animations.size() + (std::find(groups.begin(), groups.end(), parts) - groups.begin()));
  }

  // The list's entry for the first animation and those that play with it.
  int defaultOf(int first) const {
    const std::vector<int> parts = partsOf(animations, first);
    return parts.size() > 1 ? groupIndex(parts) : first;
  }

  void findGroups() {
    const int first = firstMoving();
    if (first < 0) return;
    for (auto& parts : {partsOf(animations, first), allTogether(animations)})
      if (parts.size() > 1 && std::find(groups.begin(), groups.end(), parts) == groups.end()) groups.push_back(parts);
    for (const auto& parts : groups) {
      const std::vector<double> times = keyTimesOf(animations, parts);
      out.animations.push_back({namesOf(animations, parts, " + "), times.front(), times.back(),
                                static_cast<int>(times.size()), true, parts});
    }
  }

  // Warns of animations that the user may miss: unread ones, and those of other objects if none was chosen.
  void warnOfOthers(const std::vector<int>& parts) {
    for (std::size_t i = 0; i < broken.size() && i < 10; ++i)
      out.warnings.push_back({"broken-animation",
                              "The animation " + inQuotes(broken[i].name) + " is left out: " + broken[i].error->message,
                              1});
    if (!std::holds_alternative<std::monostate>(options.animation)) return;
    const std::vector<int> others = leftOutOf(animations, parts);
    if (others.empty()) return;
    const bool one = others.size() == 1;
    out.warnings.push_back(
        {"other-animations",
         doc.where + ": the keys are from the animation " + inQuotes(out.animations[out.animation].name) +
             ". Other parts are moved by " + inQuotes(namesOf(animations, others, "\", \"")) + ", which " +
             (one ? "is" : "are") + " left out. " +
             (allTogether(animations).empty()
                  ? "Choose another animation on the timeline (on the command line, with --animation)."
                  : "Choose all together in the list of animations (on the command line, --animation all)."),
         static_cast<int>(others.size())});
  }

  void warnOfCuts(const GltfAnimation& animation) {
    if (animation.cuts.empty()) return;
    std::string list;
    for (std::size_t i = 0; i < animation.cuts.size() && i < 5; ++i)
      list += (i ? ", " : "") + shortNumber(animation.cuts[i]);
    out.warnings.push_back(
        {"animation-cut",
         doc.where + ": the animation " + inQuotes(animation.name) + " jumps at " + list + " s" +
             (animation.cuts.size() > 5 ? " and at other times" : "") +
             ". The spline smooths the jump between the keys around it. To shorten it, add a key just before the jump.",
         static_cast<int>(animation.cuts.size())});
  }

  int firstMoving() const {
    const auto first = std::find_if(animations.begin(), animations.end(), [](const auto& a) { return a.moves; });
    return first == animations.end() ? -1 : static_cast<int>(first - animations.begin());
  }

  std::string animationList() const {
    if (animations.empty()) return "it has none.";
    // Groups have no number here, because "all" is easier to type.
    std::string list = "it has";
    for (std::size_t i = 0; i < animations.size() && i < 20; ++i)
      list.append(i ? ", " : " ").append(std::to_string(i)).append(" ").append(inQuotes(animations[i].name));
    return list + (animations.size() > 20 ? ", and more" : "") +
           (allTogether(animations).size() < 2 ? "." : ", or all.");
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
                          animation.keyTimes.size() >= 2 && animation.keyTimes.size() <= maxOwnKeys;
    const bool everyFrame = options.everyFrame && options.sampleTimes.empty() && animation.keyTimes.size() >= 2;
    // The file requests these keys, not the user.
    if (everyFrame) keysOfFile = animation.keyTimes.size();
    if (ownTimes || everyFrame) return animation.keyTimes;
    return sampleTimes(options, animation.keyTimes, doc.where + ": the animation " + inQuotes(animation.name),
                       out.warnings);
  }

  Status planAnimation(int chosen) {
    const int count = static_cast<int>(animations.size());
    const std::vector<int> parts = chosen < count ? std::vector<int>{chosen} : groups[chosen - count];
    out.animation = chosen;
    warnOfOthers(parts);
    if (chosen >= count) together = joined(animations, parts);
    const GltfAnimation& animation = chosen < count ? animations[chosen] : together;
    const auto times = timesOf(animation);
    if (!times) return times.error();
    warnOfCuts(animation);
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
      if (!broken.empty()) return *broken[0].error;
      if (options.animationAsked() && doc.model.meshes.empty()) return noMesh(doc);
      if (options.animationAsked()) return error(ErrorCode::UnknownAnimation, " has no animation that moves its mesh.");
      if (targets.count() == 0) return error(ErrorCode::TooFewKeys, onePose());
      return planMorphTargets(), Status();
    }
    const auto chosen = chosenAnimation();
    if (!chosen) return chosen.error();
    return *chosen >= 0 && out.animations[*chosen].moves ? planAnimation(*chosen) : planStill(*chosen);
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
    const std::uint64_t most = maxPoseCost(doc.fileBytes);
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
                              doc.where + ": the visible meshes of some keys differ from those of its first key "
                                          "(KHR_node_visibility), which are shown.",
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
    std::vector<GltfAnimation> all = std::move(borrowed);
    auto own = readAnimations(doc, out.warnings);
    std::move(own.begin(), own.end(), std::back_inserter(all));
    for (std::size_t i = 0; i < all.size(); ++i) all[i].index = static_cast<int>(i);
    PosingAnimations posing = posingAnimations(doc, scene.graph, wanted, std::move(all));
    animations = std::move(posing.sound);
    broken = std::move(posing.broken);
    out.animations = infosOf(animations);
    findGroups();
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

Result<PoseFile> readGltfPose(const NamedBytes& file, const SourceFiles& files, const ImportOptions& options,
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
  if (poseCost(*shape, state) > maxPoseCost(doc->fileBytes))
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

bool isMotionOnly(const NamedBytes& file, const SourceFiles& files) {
  const auto doc = openGltf(file, files, "");
  return doc && doc->model.meshes.empty() && !doc->model.animations.empty();
}

Result<Import> readGltfKeys(const NamedBytes& file, const SourceFiles& files, const ImportOptions& options,
                            const std::string& where, const StageProgress& progress,
                            const std::vector<const NamedBytes*>& motions) {
  if (progress) progress("reading the file", 0);
  auto doc = openGltf(file, files, where);
  if (!doc) return doc.error();
  if (progress) progress("reading the mesh", readingShare / 2);
  const auto scene = readScene(*doc);
  if (!scene) return scene.error();
  KeyReader reader{*doc, *scene, options, progress};
  for (const NamedBytes* motion : motions) {
    const auto other = openGltf(*motion, files, std::string(baseName(motion->name)));
    if (!other) return other.error();
    auto animations = borrowAnimations(*other, *doc, reader.out.warnings);
    if (!animations) return animations.error();
    // Some programs give all animations one name.
    const std::string_view name = baseName(motion->name);
    if (motions.size() > 1 && animations->size() == 1) animations->front().name = name.substr(0, name.rfind('.'));
    std::move(animations->begin(), animations->end(), std::back_inserter(reader.borrowed));
  }
  if (Status read = reader.read(); !read) return read.error();
  return std::move(reader.out);
}

}  // namespace shapespline
