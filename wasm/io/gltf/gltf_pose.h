// Computes the vertices of a glTF scene in one state: morph targets, then skin or node transform.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/base/status.h"
#include "io/gltf/gltf_animation.h"
#include "io/gltf/gltf_shape.h"

namespace shapespline {

/// Maximum cost of posing the keys of a file of this size. Grows with the file, up to about ten seconds of work.
constexpr std::uint64_t maxPoseCost(std::uint64_t fileBytes) {
  constexpr std::uint64_t base = 200'000'000, perByte = 10'000, most = 4'000'000'000;
  return fileBytes < most / perByte ? std::min(most, base + perByte * fileBytes) : most;
}

/// Cost of posing the vertices in this state, in steps of a few nanoseconds. Morph targets may share bytes, so a small
/// file could demand any amount.
std::uint64_t poseCost(const GltfShape& shape, const SceneState& state);

/// The state stored in the file: node transforms, default morph weights, and visibility.
SceneState restState(const GltfDocument& doc, const NodeGraph& graph);

/// Computes the world positions of all vertices. With `normals`, also their unit normals if the shape has them.
/// Errors: MalformedFile for morph targets that do not fit the mesh.
Result<Positions> posedVertices(const GltfDocument& doc, const GltfShape& shape, const SceneState& state,
                                Positions* normals = nullptr, const FractionReport& onProgress = {});

/// Largest rounding of the stored vertices, or of the vertices bound by skins, to single precision.
double storedRounding(const GltfShape& shape, const SceneState& state);

}  // namespace shapespline
