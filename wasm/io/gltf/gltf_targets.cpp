#include "io/gltf/gltf_targets.h"

#include <algorithm>
#include <map>

#include "io/gltf/gltf_accessor.h"
#include "io/gltf/gltf_scene.h"

namespace shapespline {

namespace {

bool isNamed(const std::string& name) { return !name.empty(); }

void addNames(const tinygltf::Value& extras, std::vector<std::string>& out) {
  if (!extras.Has("targetNames")) return;
  const tinygltf::Value& names = extras.Get("targetNames");
  for (std::size_t t = 0; t < out.size() && names.IsArray() && t < names.ArrayLen(); ++t)
    if (out[t].empty() && names.Get(static_cast<int>(t)).IsString())
      out[t] = names.Get(static_cast<int>(t)).Get<std::string>();
}

// The name of a primitive's accessor of positions, or "".
std::string accessorName(const GltfDocument& doc, const std::map<std::string, int>& attributes) {
  const auto found = attributes.find("POSITION");
  const bool exists = found != attributes.end() && accessorCount(doc, found->second) > 0;
  return exists ? doc.model.accessors[found->second].name : std::string();
}

// Names that older versions of FBX2glTF gave to accessors. A program that names all accessors does not name targets.
std::vector<std::string> accessorNames(const GltfDocument& doc, const tinygltf::Mesh& mesh) {
  std::vector<std::string> out(targetCount(mesh));
  for (const tinygltf::Primitive& primitive : mesh.primitives) {
    if (!accessorName(doc, primitive.attributes).empty()) return {};
    for (std::size_t t = 0; t < primitive.targets.size(); ++t)
      if (out[t].empty()) out[t] = accessorName(doc, primitive.targets[t]);
  }
  return std::all_of(out.begin(), out.end(), isNamed) ? out : std::vector<std::string>();
}

// One name per target, empty if the target has none. All primitives of a mesh have the same targets, so the first name
// applies to all of them.
std::vector<std::string> targetNames(const GltfDocument& doc, const tinygltf::Mesh& mesh) {
  std::vector<std::string> out(targetCount(mesh));
  addNames(mesh.extras, out);
  for (const tinygltf::Primitive& primitive : mesh.primitives) addNames(primitive.extras, out);
  if (std::none_of(out.begin(), out.end(), isNamed))
    if (auto names = accessorNames(doc, mesh); !names.empty()) return names;
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
    const auto names = targetNames(doc, doc.model.meshes[mesh]);
    const bool hasNames = std::any_of(names.begin(), names.end(), isNamed);
    (hasNames ? named : unnamed).push_back(mesh);
  }
  // Named targets come first, so unnamed targets have the indices of the first unnamed mesh.
  for (const auto* meshes : {&named, &unnamed})
    for (int mesh : *meshes) joining.add(mesh, targetNames(doc, doc.model.meshes[mesh]));
  for (std::size_t t = 0; t < joining.out.names.size(); ++t)
    if (joining.out.names[t].empty()) joining.out.names[t] = "target " + std::to_string(t + 1);
  return std::move(joining.out);
}

}  // namespace shapespline
