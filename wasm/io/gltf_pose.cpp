#include "io/gltf_pose.h"

#include "io/gltf_accessor.h"

namespace shapespline {

namespace {

// Adds weight * target to the values, for one attribute of all targets.
Status addTargets(const GltfDocument& doc, const GltfPart& part, const char* attribute, const std::vector<double>& weights,
                  Positions& values) {
  const auto& targets = part.primitive->targets;
  for (std::size_t t = 0; t < targets.size() && t < weights.size(); ++t) {
    const auto found = targets[t].find(attribute);
    if (weights[t] == 0 || found == targets[t].end()) continue;
    const std::string name = "morph target " + std::to_string(t) + " of " + part.name;
    const auto offsets = readNumbers(doc, found->second, 3, name);
    if (!offsets) return offsets.error();
    if (offsets->size() != 3 * values.size())
      return Error{ErrorCode::MalformedFile,
                   doc.where + ": " + name + " has another number of vertices than its mesh. Export the file again."};
    for (std::size_t v = 0; v < values.size(); ++v) values[v] += weights[t] * Vec3(&(*offsets)[3 * v]);
  }
  return {};
}

struct PartTransforms {
  const GltfPart& part;
  std::vector<Eigen::Affine3d> matrices;  // one a joint, or one for the whole part

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

// A skin places the mesh by its joints alone; the mesh node's own transform does not count (glTF 2.0, section 3.7.3.3).
PartTransforms partTransforms(const GltfPart& part, const GltfShape& shape, const std::vector<Eigen::Affine3d>& world) {
  if (part.influences == 0) return {part, {world[part.node]}};
  const GltfSkin& skin = shape.skins[part.skin];
  PartTransforms out{part, {}};
  for (std::size_t j = 0; j < skin.joints.size(); ++j) out.matrices.push_back(world[skin.joints[j]] * skin.inverseBind[j]);
  return out;
}

// Normals turn with the cofactor matrix, which is det * inverse transpose and exists for singular matrices too.
Vec3 turnedNormal(const Mat3& m, const Vec3& normal) {
  Mat3 cofactor;
  cofactor.col(0) = m.col(1).cross(m.col(2));
  cofactor.col(1) = m.col(2).cross(m.col(0));
  cofactor.col(2) = m.col(0).cross(m.col(1));
  return (cofactor * normal).normalized();
}

}  // namespace

SceneState restState(const GltfDocument& doc, const GltfShape& shape) {
  SceneState state{shape.graph.rest, {}};
  for (const tinygltf::Node& node : doc.model.nodes) {
    const bool hasMesh = node.mesh >= 0 && node.mesh < static_cast<int>(doc.model.meshes.size());
    state.weights.push_back(!node.weights.empty() || !hasMesh ? node.weights : doc.model.meshes[node.mesh].weights);
  }
  return state;
}

Result<Positions> posedVertices(const GltfDocument& doc, const GltfShape& shape, const SceneState& state, Positions* normals) {
  const auto world = worldTransforms(shape.graph, state.local);
  Positions out;
  out.reserve(shape.vertexCount);
  if (normals) normals->clear();
  for (const GltfPart& part : shape.parts) {
    const std::vector<double>& weights = state.weights[part.node];
    Positions positions = part.positions;
    if (Status morphed = addTargets(doc, part, "POSITION", weights, positions); !morphed) return morphed.error();
    const PartTransforms transforms = partTransforms(part, shape, world);
    for (std::size_t v = 0; v < positions.size(); ++v) out.push_back(transforms.of(v) * positions[v]);
    if (!normals || !shape.hasNormals) continue;
    Positions turned = part.normals;
    if (Status morphed = addTargets(doc, part, "NORMAL", weights, turned); !morphed) return morphed.error();
    for (std::size_t v = 0; v < turned.size(); ++v) turned[v] = turnedNormal(transforms.of(v).linear(), turned[v]);
    normals->insert(normals->end(), turned.begin(), turned.end());
  }
  return out;
}

}  // namespace shapespline
