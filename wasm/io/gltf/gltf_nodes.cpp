#include "io/gltf/gltf_nodes.h"

#include "io/gltf/malformed.h"

namespace shapespline {

namespace {

Result<NodeTransform> readTransform(const GltfDocument& doc, int index) {
  const tinygltf::Node& node = doc.model.nodes[index];
  const auto fits = [](const std::vector<double>& values, std::size_t size) {
    return values.empty() || values.size() == size;
  };
  if (!fits(node.matrix, 16) || !fits(node.translation, 3) || !fits(node.rotation, 4) || !fits(node.scale, 3))
    return malformed(doc.where, "the transform of node " + std::to_string(index) + " has the wrong number of values");
  NodeTransform out;
  if (!node.translation.empty()) out.translation = Vec3(node.translation.data());
  if (!node.scale.empty()) out.scale = Vec3(node.scale.data());
  if (!node.rotation.empty()) {
    const Eigen::Quaterniond q(node.rotation.data());  // x, y, z, w
    if (q.norm() > 0) out.rotation = q.normalized();
  }
  if (!node.matrix.empty()) {
    out.isMatrix = true;
    out.matrix.matrix().topRows<3>() = Eigen::Matrix4d(node.matrix.data()).topRows<3>();  // column major
  }
  return out;
}

bool isVisible(const tinygltf::Node& node) {
  const auto extension = node.extensions.find("KHR_node_visibility");
  if (extension == node.extensions.end()) return true;
  const tinygltf::Value& visible = extension->second.Get("visible");
  return !visible.IsBool() || visible.Get<bool>();
}

Status linkParents(const GltfDocument& doc, NodeGraph& graph) {
  const int n = static_cast<int>(doc.model.nodes.size());
  graph.parent.assign(n, -1);
  for (int i = 0; i < n; ++i)
    for (int child : doc.model.nodes[i].children) {
      if (child < 0 || child >= n)
        return malformed(
            doc.where, "node " + std::to_string(i) + " has child " + std::to_string(child) + ", which does not exist");
      if (graph.parent[child] >= 0 || child == i)
        return malformed(doc.where, "node " + std::to_string(child) +
                                        (child == i ? " is its own child" : " has two parents") +
                                        ", so the nodes are not a tree");
      graph.parent[child] = i;
    }
  return {};
}

// Depth first from `roots`, children in file order. Not recursive, because chains may be long.
std::vector<int> depthFirst(const GltfDocument& doc, const std::vector<int>& roots) {
  std::vector<int> order, stack(roots.rbegin(), roots.rend());
  std::vector<char> seen(doc.model.nodes.size(), 0);
  while (!stack.empty()) {
    const int node = stack.back();
    stack.pop_back();
    if (seen[node]) continue;
    seen[node] = 1;
    order.push_back(node);
    const auto& children = doc.model.nodes[node].children;
    stack.insert(stack.end(), children.rbegin(), children.rend());
  }
  return order;
}

}  // namespace

Eigen::Affine3d NodeTransform::affine() const {
  if (isMatrix) return matrix;
  return Eigen::Translation3d(translation) * rotation * Eigen::Scaling(scale);
}

void NodeTransform::splitMatrix() {
  translation = matrix.translation();
  Mat3 linear = matrix.linear();
  scale = linear.colwise().norm().transpose();
  if (linear.determinant() < 0) scale.x() = -scale.x();
  for (int c = 0; c < 3; ++c)
    if (scale[c] != 0) linear.col(c) /= scale[c];
  rotation = Eigen::Quaterniond(linear).normalized();
  isMatrix = false;
}

Result<NodeGraph> readNodes(const GltfDocument& doc) {
  NodeGraph graph;
  if (Status linked = linkParents(doc, graph); !linked) return linked.error();
  const int n = static_cast<int>(doc.model.nodes.size());
  std::vector<int> roots;
  for (int i = 0; i < n; ++i)
    if (graph.parent[i] < 0) roots.push_back(i);
  graph.topDown = depthFirst(doc, roots);
  if (static_cast<int>(graph.topDown.size()) < n) return malformed(doc.where, "its nodes form a cycle");

  graph.shown = graph.topDown;
  if (!doc.model.scenes.empty()) {
    const int scene = doc.model.defaultScene < 0 ? 0 : doc.model.defaultScene;
    if (scene >= static_cast<int>(doc.model.scenes.size()))
      return malformed(doc.where, "its default scene " + std::to_string(scene) + " does not exist");
    for (int node : doc.model.scenes[scene].nodes)
      if (node < 0 || node >= n)
        return malformed(doc.where, "its scene shows node " + std::to_string(node) + ", which does not exist");
    graph.shown = depthFirst(doc, doc.model.scenes[scene].nodes);
  }
  graph.rest.reserve(n);
  for (int i = 0; i < n; ++i) {
    auto transform = readTransform(doc, i);
    if (!transform) return transform.error();
    graph.rest.push_back(*transform);
    graph.visible.push_back(isVisible(doc.model.nodes[i]));
  }
  return graph;
}

std::vector<char> seenNodes(const NodeGraph& graph, const std::vector<char>& visible) {
  std::vector<char> seen = visible;
  for (int node : graph.topDown)
    if (graph.parent[node] >= 0) seen[node] = seen[node] && seen[graph.parent[node]];
  return seen;
}

std::vector<Eigen::Affine3d> worldTransforms(const NodeGraph& graph, const std::vector<NodeTransform>& local) {
  std::vector<Eigen::Affine3d> world(local.size());
  for (int node : graph.topDown) {
    const int parent = graph.parent[node];
    world[node] = parent < 0 ? local[node].affine() : world[parent] * local[node].affine();
  }
  return world;
}

}  // namespace shapespline
