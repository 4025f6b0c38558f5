// Decides which animations of a file play together. glTF's animations are alternatives, but Blender writes an action of
// each object as a separate animation.
#pragma once

#include <string>
#include <vector>

#include "io/gltf/gltf_animation.h"

namespace shapespline {

/// The object of each node: the node itself, or -2 - k for the joints of skeleton k and the node above them.
std::vector<int> objectsOf(const GltfDocument& doc, const NodeGraph& graph);

/// The first animation and those that play with it: no two move the same path of a node, and each has the name of the
/// first, or the same start and length if each of them moves one object.
std::vector<int> partsOf(const std::vector<GltfAnimation>& animations, int first);

/// Moving animations that share no path of a node with those in `parts`.
std::vector<int> leftOutOf(const std::vector<GltfAnimation>& animations, const std::vector<int>& parts);

/// All animations that move, with the still ones beside them; empty if two of them move the same path of a node.
std::vector<int> allTogether(const std::vector<GltfAnimation>& animations);

/// The animations of `from` for the nodes of `to` with the same names. Nodes that `to` lacks give a warning. Error:
/// UnknownAnimation if it lacks all of them.
Result<std::vector<GltfAnimation>> borrowAnimations(const GltfDocument& from, const GltfDocument& to,
                                                    std::vector<Warning>& warnings);

/// The distinct key times of these animations, increasing.
std::vector<double> keyTimesOf(const std::vector<GltfAnimation>& animations, const std::vector<int>& parts);

/// Joins animations into one. Takes over their curves.
GltfAnimation joined(std::vector<GltfAnimation>& animations, const std::vector<int>& parts);

/// The first names, separated by `between`, and the number of others.
std::string namesOf(const std::vector<GltfAnimation>& animations, const std::vector<int>& parts, const char* between);

}  // namespace shapespline
