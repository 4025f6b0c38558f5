// Parses glTF's JSON and makes it safe for tinygltf, which casts, skips and recurses without checks.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#define JSON_NO_IO
#include <nlohmann/json.hpp>

#include "core/base/status.h"
#include "core/base/warning.h"

namespace shapespline {

/// Checks depth and number of values (limits.h) before parsing. Then checks syntax, asset.version 2.x, collections that
/// are arrays of objects, sizes and indices that are whole numbers in [0, 2^31), and required extensions. Integers
/// written as 3.0 become 3. Unused extensions and extras are dropped, except for the root's. Extensions that are not
/// applied give warnings. A bad accessor, buffer view, mesh, material or animation is set aside (gltf_parts.h), because
/// it may be unused.
Result<nlohmann::json> parseGltfJson(std::string_view text, const std::string& where, std::vector<Warning>& warnings);

}  // namespace shapespline
