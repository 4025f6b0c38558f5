#include "io/gltf/gltf_pose.h"

#include <algorithm>
#include <span>

#include "io/base/stored_rounding.h"
#include "io/gltf/gltf_accessor.h"

namespace shapespline {

namespace {

// Adds weight * target to the values, for one attribute of all morph targets.
Status addTargets(const GltfDocument& doc, const GltfPart& part, const char* attribute,
                  const std::vector<double>& weights, Positions& values, const FractionReport& onProgress) {
  const auto& targets = part.primitive->targets;
  for (std::size_t t = 0; t < targets.size() && t < weights.size(); ++t) {
    if (weights[t] == 0) continue;
    const auto found = targets[t].find(attribute);
    if (found == targets[t].end()) continue;
    const std::string name = "morph target " + std::to_string(t) + " of " + part.name;
    if (accessorCount(doc, found->second) != values.size())
      return Error{ErrorCode::MalformedFile,
                   doc.where + ": " + name + " does not have as many vertices as its mesh. Export the file again."};
    const double count = static_cast<double>(weights.size()), before = static_cast<double>(t);
    const auto offsets = readNumbers(doc, found->second, 3, name, values.size(),
                                     partOf(onProgress, before / count, (before + 0.7) / count));
    if (!offsets) return offsets.error();
    inBlocks(partOf(onProgress, (before + 0.7) / count, (before + 1) / count), values.size(),
             [&](std::size_t begin, std::size_t end) {
               for (std::size_t v = begin; v < end; ++v) values[v] += weights[t] * Vec3(&(*offsets)[3 * v]);
             });
  }
  return {};
}

using Matrices = std::vector<Eigen::Affine3d>;

struct PartTransforms {
  const GltfPart& part;
  std::span<const Eigen::Affine3d> matrices;  // one per joint, or one for the whole part

  Eigen::Affine3d of(std::size_t vertex) const {
    if (part.influences == 0) return matrices[0];
    Eigen::Matrix<double, 3, 4> sum = Eigen::Matrix<double, 3, 4>::Zero();
    for (int i = 0; i < part.influences; ++i) {
      const std::size_t slot = vertex * part.influences + i;
      if (part.weights[slot] != 0) sum += part.weights[slot] * matrices[part.joints[slot]].matrix().topRows<3>();
    }
    Eigen::Affine3d out = Eigen::Affine3d::Identity();
    out.matrix().topRows<3>() = sum;
    return out;
  }
};

// A skin places the mesh by its joints alone and ignores the mesh node's transform (glTF 2.0, section 3.7.3.3).
// `ofPart`: transforms of parts without a skin. `ofSkins`: caches each skin's matrices for parts that share the skin.
PartTransforms partTransforms(const GltfPart& part, const GltfShape& shape, const Matrices& world,
                              const Eigen::Affine3d& ofPart, std::vector<Matrices>& ofSkins) {
  if (part.influences == 0) return {part, {&ofPart, 1}};
  const GltfSkin& skin = shape.skins[part.skin];
  Matrices& matrices = ofSkins[part.skin];
  if (matrices.empty())
    for (std::size_t j = 0; j < skin.joints.size(); ++j)
      matrices.push_back(world[skin.joints[j]] * skin.inverseBind[j]);
  return {part, matrices};
}

// Normals transform with the inverse transpose. The cofactor matrix is this times the determinant, and exists for
// singular matrices too. A negative determinant would turn normals inwards, as the faces of a mirrored part are
// reversed.
Vec3 turnedNormal(const Mat3& m, const Vec3& normal) {
  Mat3 cofactor;
  cofactor.col(0) = m.col(1).cross(m.col(2));
  cofactor.col(1) = m.col(2).cross(m.col(0));
  cofactor.col(2) = m.col(0).cross(m.col(1));
  return (cofactor * (cofactor.col(0).dot(m.col(0)) < 0 ? Vec3(-normal) : normal)).normalized();
}

}  // namespace

std::uint64_t poseCost(const GltfShape& shape, const SceneState& state) {
  std::uint64_t cost = state.local.size();
  for (const GltfSkin& skin : shape.skins) cost += skin.joints.size();
  for (const GltfPart& part : shape.parts) {
    const auto& weights = state.weights[part.node];
    const auto on = weights.size() - std::count(weights.begin(), weights.end(), 0.0);
    cost += 1 + weights.size() + part.positions.size() * (1 + part.influences + 4 * on);
  }
  return cost;
}

SceneState restState(const GltfDocument& doc, const NodeGraph& graph) {
  SceneState state{graph.rest, {}, graph.visible};
  for (const tinygltf::Node& node : doc.model.nodes) {
    const bool hasMesh = node.mesh >= 0 && node.mesh < static_cast<int>(doc.model.meshes.size());
    state.weights.push_back(!node.weights.empty() || !hasMesh ? node.weights : doc.model.meshes[node.mesh].weights);
  }
  return state;
}

Result<Positions> posedVertices(const GltfDocument& doc, const GltfShape& shape, const SceneState& state,
                                Positions* normals, const FractionReport& onProgress) {
  const auto world = worldTransforms(*shape.graph, state.local);
  std::vector<Matrices> ofSkins(shape.skins.size());
  Positions out;
  out.reserve(shape.vertexCount);
  if (normals) normals->clear();
  for (std::size_t p = 0; p < shape.parts.size(); ++p) {
    const GltfPart& part = shape.parts[p];
    const auto share = [&, count = static_cast<double>(shape.parts.size()), before = static_cast<double>(p)](
                           double from, double to) {
      return partOf(onProgress, (before + from) / count, (before + to) / count);
    };
    const std::vector<double>& weights = state.weights[part.node];
    Positions positions = part.positions;
    if (Status morphed = addTargets(doc, part, "POSITION", weights, positions, share(0, 0.3)); !morphed)
      return morphed.error();
    const Eigen::Affine3d ofPart = world[part.node] * part.instance;
    const PartTransforms transforms = partTransforms(part, shape, world, ofPart, ofSkins);
    inBlocks(share(0.3, 0.5), positions.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) out.push_back(transforms.of(v) * positions[v]);
    });
    if (!normals || !shape.hasNormals) continue;
    Positions turned = part.normals;
    if (Status morphed = addTargets(doc, part, "NORMAL", weights, turned, share(0.5, 0.8)); !morphed)
      return morphed.error();
    inBlocks(share(0.8, 1), turned.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) turned[v] = turnedNormal(transforms.of(v).linear(), turned[v]);
    });
    normals->insert(normals->end(), turned.begin(), turned.end());
  }
  return out;
}

double storedRounding(const GltfShape& shape, const SceneState& state) {
  const auto world = worldTransforms(*shape.graph, state.local);
  const auto scaleOf = [](const Eigen::Affine3d& m) { return m.linear().colwise().norm().maxCoeff(); };
  std::vector<Matrices> ofSkins(shape.skins.size());
  double largest = 0;
  for (const GltfPart& part : shape.parts) {
    const Eigen::Affine3d ofPart = world[part.node] * part.instance;
    const PartTransforms transforms = partTransforms(part, shape, world, ofPart, ofSkins);
    largest = std::max(largest, storedRounding(part.positions) * scaleOf(transforms.matrices[0]));
  }
  for (const GltfSkin& skin : shape.skins)
    for (std::size_t j = 0; j < skin.joints.size(); ++j)
      largest = std::max(largest, storedRounding({skin.inverseBind[j].translation()}) * scaleOf(world[skin.joints[j]]));
  return largest;
}

}  // namespace shapespline
