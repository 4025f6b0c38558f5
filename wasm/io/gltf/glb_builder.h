// Builds a GLB file.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#define JSON_NO_IO
#include <nlohmann/json.hpp>

#include "core/base/status.h"

namespace shapespline {

/// glTF's codes for component types and buffer view targets.
constexpr int glFloat = 5126, glUnsignedShort = 5123, glUnsignedInt = 5125;
constexpr int glArrayBuffer = 34962, glElementArrayBuffer = 34963;

/// The growing binary chunk and its JSON description.
struct GlbBuilder {
  nlohmann::json doc = {{"asset", {{"version", "2.0"}, {"generator", "shapespline"}}}};
  std::vector<std::uint8_t> bin;

  void align() { bin.resize((bin.size() + 3) / 4 * 4, 0); }

  int addView(std::size_t start, int target = 0, int stride = 0) {
    nlohmann::json view = {{"buffer", 0}, {"byteOffset", start}, {"byteLength", bin.size() - start}};
    if (target) view["target"] = target;
    if (stride) view["byteStride"] = stride;
    align();
    doc["bufferViews"].push_back(std::move(view));
    return static_cast<int>(doc["bufferViews"].size()) - 1;
  }

  template <class T>
  std::size_t append(const T* values, std::size_t count) {
    align();
    const std::size_t start = bin.size();
    bin.resize(start + count * sizeof(T));
    if (count) std::memcpy(bin.data() + start, values, count * sizeof(T));
    return start;
  }

  int addAccessor(nlohmann::json accessor) {
    doc["accessors"].push_back(std::move(accessor));
    return static_cast<int>(doc["accessors"].size()) - 1;
  }

  template <class T>
  int addArray(const std::vector<T>& values, const char* type, int components, int componentType, int target = 0) {
    const int view = addView(append(values.data(), values.size()), target);
    return addAccessor({{"bufferView", view},
                        {"componentType", componentType},
                        {"count", values.size() / components},
                        {"type", type}});
  }

  /// Returns the JSON chunk followed by the BIN chunk. Nothing can be added afterwards. Error: TooLarge.
  Result<std::vector<std::uint8_t>> finish();
};

}  // namespace shapespline
