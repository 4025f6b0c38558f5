// How much a file may hold.
#pragma once

#include <cstddef>
#include <cstdint>

namespace shapespline {

/// More vertices than a browser can complete. Also limits counts that a file declares without providing bytes.
constexpr std::uint64_t mostElements = 16'000'000;

/// Limits of a JSON document: levels, objects, and values of any kind. Deeper than any tool writes, shallow enough for
/// recursive functions. An object takes a hundred bytes or more, so a few bytes of a file must not become a kilobyte.
/// web/engine/api/gltf-json.ts has the same limits.
constexpr int deepestJson = 100;
constexpr std::uint64_t mostJsonObjects = 250'000, mostJsonValues = 4'000'000;

/// Each has room for dozens of parameters while it is read.
constexpr std::size_t mostMaterials = 16'384;

}  // namespace shapespline
