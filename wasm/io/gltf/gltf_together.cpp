#include "io/gltf/gltf_together.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/base/format.h"
#include "io/base/objects.h"
#include "io/gltf/gltf_scene.h"

namespace shapespline {

namespace {

using Targets = std::set<std::pair<int, AnimationCurve::Path>>;

bool shares(const Targets& taken, const GltfAnimation& animation) {
  return std::any_of(animation.curves.begin(), animation.curves.end(),
                     [&](const AnimationCurve& curve) { return taken.contains({curve.node, curve.path}); });
}

void take(Targets& taken, const GltfAnimation& animation) {
  for (const AnimationCurve& curve : animation.curves) taken.insert({curve.node, curve.path});
}

bool agree(const GltfAnimation& a, const GltfAnimation& b) {
  const double length = a.keyTimes.back() - a.keyTimes.front();
  const auto near = [&](double s, double t) { return std::abs(s - t) <= 1e-3 * length; };
  return near(a.keyTimes.front(), b.keyTimes.front()) && near(a.keyTimes.back(), b.keyTimes.back());
}

}  // namespace

std::vector<int> objectsOf(const GltfDocument& doc, const NodeGraph& graph) {
  const int count = static_cast<int>(doc.model.nodes.size());
  std::vector<int> objects(count);
  for (int n = 0; n < count; ++n) objects[n] = n;
  int skeletons = 0;
  for (const tinygltf::Skin& skin : doc.model.skins) {
    int skeleton = -2 - skeletons++;
    const auto exists = [&](int joint) { return joint >= 0 && joint < count; };
    // Skins may share joints.
    for (int joint : skin.joints)
      if (exists(joint) && objects[joint] < 0) skeleton = objects[joint];
    for (int joint : skin.joints)
      if (exists(joint)) objects[joint] = skeleton;
  }
  for (int n = 0; n < count; ++n) {
    const int above = graph.parent[n];
    if (objects[n] < 0 && above >= 0 && objects[above] == above && doc.model.nodes[above].mesh < 0)
      objects[above] = objects[n];
  }
  return objects;
}

std::vector<int> partsOf(const std::vector<GltfAnimation>& animations, int first) {
  const GltfAnimation& one = animations[first];
  std::vector<int> parts = {first};
  Targets taken;
  take(taken, one);
  std::set<int> skeletons = {one.object};
  for (int i = 0; i < static_cast<int>(animations.size()); ++i) {
    const GltfAnimation& a = animations[i];
    const bool ofOther = one.object != -1 && a.object != -1 && (a.object >= 0 || !skeletons.contains(a.object));
    if (i == first || shares(taken, a) || !(a.name == one.name || (ofOther && agree(one, a)))) continue;
    parts.push_back(i);
    take(taken, a);
    skeletons.insert(a.object);
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

std::vector<int> leftOutOf(const std::vector<GltfAnimation>& animations, const std::vector<int>& parts) {
  std::vector<int> out;
  Targets taken;
  for (int part : parts) take(taken, animations[part]);
  for (int i = 0; i < static_cast<int>(animations.size()); ++i)
    if (animations[i].moves && !shares(taken, animations[i])) out.push_back(i);
  return out;
}

std::vector<int> allTogether(const std::vector<GltfAnimation>& animations) {
  std::vector<int> all;
  Targets taken;
  for (const bool moving : {true, false})
    for (int i = 0; i < static_cast<int>(animations.size()); ++i) {
      if (animations[i].moves != moving) continue;
      const bool shared = shares(taken, animations[i]);
      if (shared && moving) return {};
      if (shared) continue;
      take(taken, animations[i]);
      all.push_back(i);
    }
  std::sort(all.begin(), all.end());
  return all;
}

GltfAnimation joined(std::vector<GltfAnimation>& animations, const std::vector<int>& parts) {
  GltfAnimation out;
  out.name = namesOf(animations, parts, " + ");
  out.keyTimes = keyTimesOf(animations, parts);
  for (int part : parts) {
    GltfAnimation& a = animations[part];
    std::move(a.curves.begin(), a.curves.end(), std::back_inserter(out.curves));
    out.cuts.insert(out.cuts.end(), a.cuts.begin(), a.cuts.end());
    out.weightsOnly = out.weightsOnly && a.weightsOnly;
  }
  sortOnce(out.cuts);
  return out;
}

std::vector<double> keyTimesOf(const std::vector<GltfAnimation>& animations, const std::vector<int>& parts) {
  std::vector<double> times;
  for (int part : parts) times.insert(times.end(), animations[part].keyTimes.begin(), animations[part].keyTimes.end());
  sortOnce(times);
  return times;
}

Result<std::vector<GltfAnimation>> borrowAnimations(const GltfDocument& from, const GltfDocument& to,
                                                    std::vector<Warning>& warnings) {
  std::map<std::string, int> nodes;
  for (std::size_t n = 0; n < to.model.nodes.size(); ++n)
    nodes.try_emplace(to.model.nodes[n].name, static_cast<int>(n));
  nodes.erase("");
  std::vector<GltfAnimation> animations = readAnimations(from, warnings);
  std::vector<std::string> missing;
  std::optional<Error> error;
  for (GltfAnimation& a : animations) {
    if (a.error && !error) error = a.error;
    if (a.error) a.curves.clear();
    // Morph weights belong to a mesh, which the file does not have.
    std::erase_if(a.curves, [&](AnimationCurve& curve) {
      const std::string& name = from.model.nodes[curve.node].name;
      const auto found = nodes.find(name);
      if (found == nodes.end()) addObject(name, missing);
      else curve.node = found->second;
      return found == nodes.end() || curve.path == AnimationCurve::Path::Weights;
    });
  }
  std::erase_if(animations, [](const GltfAnimation& a) { return a.curves.empty(); });
  if (animations.empty() && error) return *error;
  if (animations.empty())
    return Error{ErrorCode::UnknownAnimation, from.where + " moves bones that " + to.where +
                                                  " does not have: " + objectList(missing) +
                                                  ". Export both from the same rig, or together as one GLB."};
  if (!missing.empty())
    warnings.push_back({"missing-bones",
                        from.where + " moves bones that " + to.where + " does not have: " + objectList(missing) +
                            ". They are left out. If the motion looks wrong, export both from the same rig.",
                        static_cast<int>(missing.size())});
  return animations;
}

std::string namesOf(const std::vector<GltfAnimation>& animations, const std::vector<int>& parts, const char* between) {
  constexpr std::size_t most = 4;
  std::string list;
  for (std::size_t i = 0; i < parts.size() && i < most; ++i)
    list.append(i ? between : "").append(shortName(animations[parts[i]].name, 64));
  if (parts.size() > most) list += between + grouped(static_cast<std::int64_t>(parts.size() - most)) + " more";
  return list;
}

}  // namespace shapespline
