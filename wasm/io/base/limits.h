// How much a file may hold.
#pragma once

#include <cstddef>
#include <cstdint>

namespace shapespline {

/// More vertices than a browser can complete; also the bound for what a file declares without bytes behind it.
constexpr std::uint64_t kMostElements = 16'000'000;

/// Of a JSON document: levels, objects, and values of any kind. Deeper than any tool writes, and shallow enough for
/// recursive functions; each object becomes some hundred bytes and more, so that 3 bytes of a file must not be a
/// kilobyte. web/engine/api/gltf-json.ts has the same.
constexpr int kDeepestJson = 100;
constexpr std::uint64_t kMostJsonObjects = 250'000, kMostJsonValues = 4'000'000;

/// Each has room for dozens of parameters while it is read.
constexpr std::size_t kMostMaterials = 16'384;

}  // namespace shapespline
