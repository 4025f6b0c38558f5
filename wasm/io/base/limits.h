// Limits on the contents of a file.
#pragma once

#include <cstddef>
#include <cstdint>

namespace shapespline {

/// Most vertices of a file; limits of other counts are multiples of it. The engine cannot process larger meshes in a
/// browser. The limit also bounds declared counts that have no bytes in the file.
constexpr std::uint64_t maxElements = 16'000'000;

/// Limits of a JSON document: nesting depth, objects, and total values. The depth exceeds any real file but is safe for
/// recursive functions. An object takes 100 bytes or more in memory, so a few file bytes could otherwise become a
/// kilobyte. Same limits in web/engine/api/gltf-json.ts.
constexpr int deepestJson = 100;
constexpr std::uint64_t maxJsonObjects = 250'000, maxJsonValues = 4'000'000;

/// Most materials of a file. A reader holds dozens of parameters for each.
constexpr std::size_t maxMaterials = 16'384;

}  // namespace shapespline
