#include "io/gltf/gltf_targets.h"

#include <algorithm>
#include <map>

#include "io/gltf/gltf_scene.h"

namespace shapespline {

namespace {

// One name per target, empty if the target has none.
std::vector<std::string> targetNames(const tinygltf::Mesh& mesh) {
  std::vector<std::string> out(targetCount(mesh));
  if (!mesh.extras.Has("targetNames")) return out;
  const tinygltf::Value& names = mesh.extras.Get("targetNames");
  for (std::size_t t = 0; t < out.size() && names.IsArray() && t < names.ArrayLen(); ++t)
    if (names.Get(static_cast<int>(t)).IsString()) out[t] = names.Get(static_cast<int>(t)).Get<std::string>();
  return out;
}

struct TargetJoining {
  JoinedTargets out;
  // Joined targets of each name. A name has several if one mesh repeats it.
  std::map<std::string, std::vector<int>> slotsOf{};

  int newSlot(const std::string& name) {
    out.names.push_back(name);
    if (!name.empty()) slotsOf[name].push_back(out.count() - 1);
    return out.count() - 1;
  }

  void add(int mesh, const std::vector<std::string>& names) {
    std::vector<int>& slots = out.slots[mesh];
    slots.assign(names.size(), -1);
    std::map<std::string, std::size_t> taken;  // number of occurrences of each name in this mesh
    std::vector<char> used(out.count() + names.size(), 0);
    const auto use = [&](std::size_t t, int slot) { used[slots[t] = slot] = 1; };
    for (std::size_t t = 0; t < names.size(); ++t) {
      if (names[t].empty()) continue;
      const std::size_t nth = taken[names[t]]++;
      const std::vector<int>& known = slotsOf[names[t]];
      use(t, nth < known.size() ? known[nth] : newSlot(names[t]));
    }
    for (std::size_t t = 0; t < names.size(); ++t) {
      if (!names[t].empty()) continue;
      const bool isFree = static_cast<int>(t) < out.count() && !used[t];
      use(t, isFree ? static_cast<int>(t) : newSlot(""));
    }
  }
};

}  // namespace

JoinedTargets joinTargets(const GltfDocument& doc, const std::vector<int>& meshNodes) {
  TargetJoining joining;
  joining.out.slots.resize(doc.model.meshes.size());
  std::vector<int> named, unnamed;
  std::vector<char> known(doc.model.meshes.size(), 0);
  for (int node : meshNodes) {
    const int mesh = doc.model.nodes[node].mesh;
    if (known[mesh]) continue;
    known[mesh] = 1;
    const auto names = targetNames(doc.model.meshes[mesh]);
    const bool hasNames =
        std::any_of(names.begin(), names.end(), [](const std::string& name) { return !name.empty(); });
    (hasNames ? named : unnamed).push_back(mesh);
  }
  // Named targets come first, so unnamed targets have the indices of the first unnamed mesh.
  for (const auto* meshes : {&named, &unnamed})
    for (int mesh : *meshes) joining.add(mesh, targetNames(doc.model.meshes[mesh]));
  for (std::size_t t = 0; t < joining.out.names.size(); ++t)
    if (joining.out.names[t].empty()) joining.out.names[t] = "target " + std::to_string(t + 1);
  return std::move(joining.out);
}

}  // namespace shapespline
