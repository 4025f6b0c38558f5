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
  bool isMatrix = false;  ///< `matrix` applies instead of the three fields above
  Eigen::Affine3d matrix = Eigen::Affine3d::Identity();

  Eigen::Affine3d affine() const;

  /// Splits the matrix into translation, rotation and scale, for nodes with animated parts.
  void splitMatrix();
};

/// The node graph, checked to be a forest.
struct NodeGraph {
  std::vector<int> parent;   ///< parent of each node, -1 for roots
  std::vector<int> topDown;  ///< all nodes, parents before children
  std::vector<int> shown;    ///< nodes of the default scene (of all roots if there are no scenes), depth first
  std::vector<NodeTransform> rest;
  std::vector<char> visible;  ///< KHR_node_visibility of each node, without its ancestors
};

/// Errors: MalformedFile for missing children, cycles, nodes with two parents, arrays of wrong length.
Result<NodeGraph> readNodes(const GltfDocument& doc);

/// Whether each node and all its ancestors are visible.
std::vector<char> seenNodes(const NodeGraph& graph, const std::vector<char>& visible);

/// World transforms from transforms relative to the parents.
std::vector<Eigen::Affine3d> worldTransforms(const NodeGraph& graph, const std::vector<NodeTransform>& local);

}  // namespace shapespline
