// The node graph of a glTF scene: order, visibility and transforms.
#pragma once

#include <vector>

#include "core/base/status.h"
#include "core/base/types.h"
#include "io/gltf/gltf_document.h"

namespace shapespline {

/// A node's transform relative to its parent.
struct NodeTransform {
  Vec3 translation = Vec3::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Vec3 scale = Vec3::Ones();
  bool isMatrix = false;  ///< `matrix` counts, not the three above
  Eigen::Affine3d matrix = Eigen::Affine3d::Identity();

  Eigen::Affine3d affine() const;

  /// Turns a matrix into translation, rotation and scale, for nodes whose parts are animated.
  void splitMatrix();
};

/// The graph, checked to be a forest.
struct NodeGraph {
  std::vector<int> parent;   ///< -1 for roots
  std::vector<int> topDown;  ///< every node after its parent
  std::vector<int> shown;    ///< nodes of the default scene, depth first; without scenes, of all roots
  std::vector<NodeTransform> rest;
  std::vector<char> visible;  ///< KHR_node_visibility of each node itself
};

/// Errors: MalformedFile for missing children, cycles, nodes with two parents, wrong array lengths.
Result<NodeGraph> readNodes(const GltfDocument& doc);

/// For each node, whether it and all its ancestors are visible.
std::vector<char> seenNodes(const NodeGraph& graph, const std::vector<char>& visible);

/// Transforms to world space from transforms relative to the parents.
std::vector<Eigen::Affine3d> worldTransforms(const NodeGraph& graph, const std::vector<NodeTransform>& local);

}  // namespace shapespline
