#include "io/gltf/gltf_shape.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "core/base/format.h"
#include "io/base/limits.h"
#include "io/gltf/gltf_accessor.h"
#include "io/gltf/malformed.h"

namespace shapespline {

namespace {

Positions toPositions(const std::vector<double>& numbers, const FractionReport& onProgress) {
  Positions out(numbers.size() / 3);
  inBlocks(onProgress, out.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) out[i] = Vec3(&numbers[3 * i]);
  });
  return out;
}

int attribute(const tinygltf::Primitive& primitive, const std::string& name) {
  const auto it = primitive.attributes.find(name);
  return it == primitive.attributes.end() ? -1 : it->second;
}

// Leaves the skins of other nodes empty.
Result<std::vector<GltfSkin>> readSkins(const GltfDocument& doc, const std::vector<int>& meshNodes) {
  std::vector<GltfSkin> skins;
  std::set<int> used;
  for (int node : meshNodes) used.insert(doc.model.nodes[node].skin);
  for (const tinygltf::Skin& skin : doc.model.skins) {
    const std::string name = "skin " + std::to_string(skins.size());
    if (!used.contains(static_cast<int>(skins.size()))) {
      skins.emplace_back();
      continue;
    }
    for (int joint : skin.joints)
      if (joint < 0 || joint >= static_cast<int>(doc.model.nodes.size()))
        return malformed(doc.where, name + " has joint node " + std::to_string(joint) + ", which does not exist");
    GltfSkin out{skin.joints, std::vector<Eigen::Affine3d>(skin.joints.size(), Eigen::Affine3d::Identity())};
    if (skin.inverseBindMatrices >= 0) {
      const auto numbers =
          readNumbers(doc, skin.inverseBindMatrices, 16, "inverseBindMatrices of " + name, skin.joints.size());
      if (!numbers) return numbers.error();
      if (numbers->size() < 16 * skin.joints.size())
        return malformed(doc.where, name + " has fewer inverse bind matrices than joints");
      for (std::size_t j = 0; j < skin.joints.size(); ++j)
        out.inverseBind[j].matrix().topRows<3>() = Eigen::Matrix4d(&(*numbers)[16 * j]).topRows<3>();
    }
    skins.push_back(std::move(out));
  }
  return skins;
}

struct ShapeReader {
  const GltfDocument& doc;
  const std::vector<int>& meshNodes;
  const FractionReport& onProgress;
  GltfShape shape;
  std::vector<Eigen::Affine3d> world{};  // of every node, at rest
  int skippedPrimitives = 0, leftoverCorners = 0, unskinnedParts = 0;
  std::int64_t cornerCount = 0, influenceCount = 0;

  // Adds JOINTS_set and WEIGHTS_set to the influences of the part.
  Status readInfluenceSet(GltfPart& part, int set, std::vector<std::vector<std::uint32_t>>& joints,
                          std::vector<std::vector<double>>& weights) {
    const std::string suffix = "_" + std::to_string(set);
    const int jointAccessor = attribute(*part.primitive, "JOINTS" + suffix),
              weightAccessor = attribute(*part.primitive, "WEIGHTS" + suffix);
    const std::size_t n = part.positions.size();
    if (accessorCount(doc, jointAccessor) != n || accessorCount(doc, weightAccessor) != n)
      return malformed(doc.where, part.name + " has a different number of joints or weights than vertices");
    influenceCount += 4 * static_cast<std::int64_t>(n);
    if (influenceCount > static_cast<std::int64_t>(4 * maxElements))
      return tooLarge(doc, 4 * maxElements, "joint weights");
    auto j = readWholeNumbers(doc, jointAccessor, 4, "JOINTS" + suffix + " of " + part.name);
    if (!j) return j.error();
    auto w = readNumbers(doc, weightAccessor, 4, "WEIGHTS" + suffix + " of " + part.name);
    if (!w) return w.error();
    joints.push_back(std::move(*j));
    weights.push_back(std::move(*w));
    return {};
  }

  Status readInfluences(GltfPart& part) {
    std::vector<std::vector<std::uint32_t>> joints;
    std::vector<std::vector<double>> weights;
    const auto has = [&](const char* name) {
      return attribute(*part.primitive, name + std::to_string(joints.size())) >= 0;
    };
    while (has("JOINTS_") && has("WEIGHTS_"))
      if (Status set = readInfluenceSet(part, static_cast<int>(joints.size()), joints, weights); !set) return set;
    if (joints.empty()) {
      ++unskinnedParts;
      part.skin = -1;
      return {};
    }
    const std::size_t sets = joints.size(), known = shape.skins[part.skin].joints.size();
    part.influences = static_cast<int>(4 * sets);
    part.joints.resize(part.positions.size() * part.influences);
    part.weights.resize(part.joints.size());
    for (std::size_t v = 0; v < part.positions.size(); ++v) {
      double sum = 0;
      std::uint32_t* joint = &part.joints[v * part.influences];
      double* weight = &part.weights[v * part.influences];
      for (std::size_t i = 0; i < 4 * sets; ++i) {
        joint[i] = joints[i / 4][4 * v + i % 4];
        weight[i] = weights[i / 4][4 * v + i % 4];
        if (joint[i] >= known && weight[i] == 0) joint[i] = 0;  // unused slots may hold any index
        if (joint[i] >= known)
          return malformed(doc.where, part.name + ": vertex " + grouped(std::int64_t(v)) + " follows joint " +
                                          grouped(joint[i]) + ", but its skin has " + grouped(std::int64_t(known)) +
                                          (known == 1 ? " joint" : " joints"));
        sum += std::abs(weight[i]);
      }
      if (known == 0) return malformed(doc.where, part.name + " has a skin without joints");
      // Weights must sum to 1. Others are normalised, as in three.js.
      if (sum > 0)
        for (std::size_t i = 0; i < 4 * sets; ++i) weight[i] /= sum;
      else weight[0] = 1;
    }
    return {};
  }

  Status readPart(int node, const Eigen::Affine3d& instance, const tinygltf::Primitive& primitive,
                  const std::string& name, const FractionReport& report) {
    GltfPart part;
    part.node = node;
    part.instance = instance;
    part.mesh = doc.model.nodes[node].mesh;
    part.skin = doc.model.nodes[node].skin;
    part.primitive = &primitive;
    part.name = name;
    part.firstVertex = shape.vertexCount;
    const int position = attribute(primitive, "POSITION"), normal = attribute(primitive, "NORMAL");
    if (position < 0) return malformed(doc.where, name + " has no positions");
    if (shape.vertexCount + accessorCount(doc, position) > maxElements) return tooLarge(doc, maxElements, "vertices");
    // An accessor may omit its bytes to declare zeros. But no real mesh has more vertices than its file has bytes.
    if (accessorCount(doc, position) > doc.bufferBytes && doc.model.accessors[position].bufferView < 0)
      return Error{ErrorCode::TooLarge, doc.where + ": POSITION of " + name + " declares " +
                                            grouped(std::int64_t(accessorCount(doc, position))) +
                                            " vertices, but the file has too few bytes for them. " +
                                            "Export the file again."};
    const std::size_t count = accessorCount(doc, position);
    auto positions = readNumbers(doc, position, 3, "POSITION of " + name, count, partOf(report, 0, 0.3));
    if (!positions) return positions.error();
    part.positions = toPositions(*positions, partOf(report, 0.3, 0.5));
    if (normal >= 0) {
      if (accessorCount(doc, normal) != part.positions.size())
        return malformed(doc.where, name + " has a different number of normals than vertices");
      auto normals = readNumbers(doc, normal, 3, "NORMAL of " + name, count, partOf(report, 0.5, 0.8));
      if (!normals) return normals.error();
      part.normals = toPositions(*normals, partOf(report, 0.8, 1));
    }
    if (part.skin >= static_cast<int>(shape.skins.size()))
      return malformed(doc.where, "node " + std::to_string(node) + " has skin " + std::to_string(part.skin) +
                                      ", which does not exist");
    if (part.skin >= 0)
      if (Status influences = readInfluences(part); !influences) return influences;
    shape.vertexCount += static_cast<int>(part.positions.size());
    shape.hasNormals = shape.hasNormals && normal >= 0;
    shape.parts.push_back(std::move(part));
    return {};
  }

  Result<std::vector<std::uint32_t>> corners(const GltfPart& part, const tinygltf::Primitive& primitive,
                                             const std::string& name, const FractionReport& report) {
    const std::size_t n = part.positions.size();
    cornerCount += static_cast<std::int64_t>(primitive.indices < 0 ? n : accessorCount(doc, primitive.indices));
    if (cornerCount > 3 * maxFaces) return tooLarge(doc, maxFaces, "faces");
    if (primitive.indices < 0) {
      std::vector<std::uint32_t> all(n);
      for (std::size_t i = 0; i < n; ++i) all[i] = static_cast<std::uint32_t>(i);
      return all;
    }
    auto indices = readWholeNumbers(doc, primitive.indices, 1, "the indices of " + name, report);
    if (!indices) return indices;
    for (std::size_t i = 0; i < indices->size(); ++i)
      if ((*indices)[i] >= n)
        return Error{ErrorCode::IndexOutOfRange,
                     doc.where + ": face " + grouped(std::int64_t(i / 3)) + " of " + name + " refers to vertex " +
                         grouped((*indices)[i]) + ", but there are " + grouped(std::int64_t(n)) +
                         " vertices. Export the mesh again.",
                     -1, static_cast<int>(std::min<std::uint32_t>((*indices)[i], 0x7fffffff)),
                     static_cast<int>(shape.faces.size() + i / 3)};
    return indices;
  }

  void addFace(std::uint32_t a, std::uint32_t b, std::uint32_t c, int offset, bool turned) {
    if (turned) std::swap(b, c);
    shape.faces.push_back({static_cast<int>(a) + offset, static_cast<int>(b) + offset, static_cast<int>(c) + offset});
  }

  // Triangles of a list, strip or fan (glTF 2.0, section 3.7.2.1).
  void addFaces(const std::vector<std::uint32_t>& v, int mode, int offset, bool turned, const FractionReport& report) {
    const std::size_t n = v.size();
    if (mode == TINYGLTF_MODE_TRIANGLES) {
      inBlocks(report, n / 3, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) addFace(v[3 * f], v[3 * f + 1], v[3 * f + 2], offset, turned);
      });
      leftoverCorners += static_cast<int>(n % 3);
      return;
    }
    const bool fan = mode == TINYGLTF_MODE_TRIANGLE_FAN;
    for (std::size_t i = 0; i + 2 < n; ++i) {
      const std::uint32_t a = fan ? v[0] : v[i], b = v[i + 1], c = v[i + 2];
      const bool stitch = a == b || b == c || a == c;  // a degenerate face that connects two strips
      if (!stitch) addFace(a, b, c, offset, turned != (!fan && i % 2 == 1));
    }
  }

  // Whether most of a skin's influences mirror their vertices. The mesh node's transform does not count.
  bool isMirrored(const GltfPart& part) const {
    const GltfSkin& skin = shape.skins[part.skin];
    std::vector<double> signs;
    for (std::size_t j = 0; j < skin.joints.size(); ++j)
      signs.push_back((world[skin.joints[j]] * skin.inverseBind[j]).linear().determinant() < 0 ? -1 : 1);
    double sum = 0;
    for (std::size_t i = 0; i < part.joints.size(); ++i) sum += part.weights[i] * signs[part.joints[i]];
    return sum < 0;
  }

  Status readMesh(int node, const Eigen::Affine3d& instance, bool mirrored, const FractionReport& report) {
    const int meshIndex = doc.model.nodes[node].mesh;
    const tinygltf::Mesh& mesh = doc.model.meshes[meshIndex];
    std::map<const tinygltf::Primitive*, std::size_t, ByVertices> knownPart;
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const tinygltf::Primitive& primitive = mesh.primitives[p];
      const auto share = [&, count = static_cast<double>(mesh.primitives.size()), before = static_cast<double>(p)](
                             double from, double to) {
        return partOf(report, (before + from) / count, (before + to) / count);
      };
      if (!isTriangles(primitive.mode)) {
        ++skippedPrimitives;
        continue;
      }
      const std::string name = "mesh " + std::to_string(meshIndex) + ", primitive " + std::to_string(p);
      if (const int m = primitive.material; m >= 0 && m < static_cast<int>(doc.model.materials.size()))
        if (const std::string broken = brokenPart(doc.model.materials[m].extras); !broken.empty())
          return malformed(doc.where, "material " + std::to_string(m) + broken);
      // Primitives that share vertices (one mesh in several materials) also share them here.
      const auto [place, isNew] = knownPart.try_emplace(&primitive, shape.parts.size());
      const std::size_t part = place->second;
      if (isNew)
        if (Status read = readPart(node, instance, primitive, name, share(0, 0.6)); !read) return read;
      const auto v = corners(shape.parts[part], primitive, name, share(0.6, 0.8));
      if (!v) return v.error();
      const int start = static_cast<int>(shape.faces.size());
      if (start + static_cast<std::int64_t>(v->size()) / (primitive.mode == TINYGLTF_MODE_TRIANGLES ? 3 : 1) > maxFaces)
        return tooLarge(doc, maxFaces, "faces");
      const GltfPart& read = shape.parts[part];
      addFaces(*v, primitive.mode, read.firstVertex, read.skin < 0 ? mirrored : isMirrored(read), share(0.8, 1));
      shape.groups.push_back({start, static_cast<int>(shape.faces.size()) - start, primitive.material});
    }
    return {};
  }

  void warn(const char* code, int count, const std::string& message) {
    if (count > 0) shape.warnings.push_back({code, doc.where + ": " + message, count});
  }

  // All copies of a node's mesh form one object.
  Status readNode(int node, const FractionReport& report) {
    const auto instances = readInstances(doc, node);
    if (!instances) return instances.error();
    const int start = static_cast<int>(shape.faces.size());
    for (std::size_t i = 0; i < instances->size(); ++i) {
      const Eigen::Affine3d& instance = (*instances)[i];
      const double count = static_cast<double>(instances->size()), before = static_cast<double>(i);
      const bool mirrored = (world[node] * instance).linear().determinant() < 0;
      if (Status mesh = readMesh(node, instance, mirrored, partOf(report, before / count, (before + 1) / count)); !mesh)
        return mesh;
    }
    shape.objects.push_back(objectOf(node, start));
    return {};
  }

  ObjectFaces objectOf(int node, int start) const {
    ObjectFaces object;
    object.name = objectName(doc, node);
    object.start = start;
    object.count = static_cast<int>(shape.faces.size()) - start;
    object.nodeName = shortName(doc.model.nodes[node].name);
    object.meshName = shortName(doc.model.meshes[doc.model.nodes[node].mesh].name);
    // The names of a few ancestors suffice to distinguish objects with equal names.
    constexpr int most = 8;
    int above = shape.graph->parent[node];
    for (int i = 0; i < most && above >= 0; ++i, above = shape.graph->parent[above])
      object.path = std::string(shortName(doc.model.nodes[above].name, 64)) + "/" + object.path;
    return object;
  }

  Status read() {
    auto skins = readSkins(doc, meshNodes);
    if (!skins) return skins.error();
    shape.skins = std::move(*skins);
    shape.hasNormals = true;
    world = worldTransforms(*shape.graph, shape.graph->rest);
    for (std::size_t i = 0; i < meshNodes.size(); ++i) {
      const double count = static_cast<double>(meshNodes.size()), before = static_cast<double>(i);
      const int node = meshNodes[i];
      if (Status mesh = readNode(node, partOf(onProgress, before / count, (before + 1) / count)); !mesh) return mesh;
    }
    shape.hasNormals = shape.hasNormals && !shape.parts.empty();
    warn("skipped-primitives", skippedPrimitives, "lines and points are ignored.");
    warn("leftover-corners", leftoverCorners,
         "the number of corners in a triangle list is not a multiple of 3. The last one or two are ignored.");
    warn("skin-without-weights", unskinnedParts, "a skinned mesh without joints or weights is used without its skin.");
    if (!shape.faces.empty()) return {};
    return noMesh(doc);
  }
};

}  // namespace

Error noMesh(const GltfDocument& doc) {
  const bool bare = doc.model.meshes.empty();
  if (bare && !doc.model.animations.empty())
    return {ErrorCode::NoTriangles,
            doc.where +
                " has an animation but no mesh. Open it together with the GLB of its character, or export both "
                "as one GLB (with skin)."};
  return {ErrorCode::NoTriangles, doc.where + (bare ? " has no mesh" : " shows no triangles") +
                                      ". Export a scene that shows a mesh with faces."};
}

Result<GltfShape> readShape(const GltfDocument& doc, const NodeGraph& graph, const std::vector<int>& meshNodes,
                            const FractionReport& onProgress) {
  ShapeReader reader{doc, meshNodes, onProgress, {}};
  reader.shape.graph = &graph;
  if (Status read = reader.read(); !read) return read.error();
  return std::move(reader.shape);
}

}  // namespace shapespline
