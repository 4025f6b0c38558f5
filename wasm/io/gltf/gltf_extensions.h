// The registered extensions of glTF and how each is handled. EXTENSIONS.md has the same lists.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#define JSON_NO_IO
#include <nlohmann/json.hpp>

#include "core/base/status.h"
#include "core/base/warning.h"

namespace shapespline {

enum class ExtensionUse {
  Applied,
  Decoded,   ///< decoded before the core reads the file
  Harmless,  ///< does not affect the shape or its motion
  Ignored,   ///< may affect the shape or its motion, and is not applied
};

struct KnownExtension {
  std::string_view name;  ///< a trailing '*' matches all names with this prefix
  ExtensionUse use;
};

/// All known extensions. If two entries match a name, the first one applies.
std::span<const KnownExtension> knownExtensions();

/// Errors: Unsupported for a required extension that is neither applied nor harmless; MalformedFile for a list with
/// anything but names.
Status checkRequiredExtensions(const nlohmann::json& doc, const std::string& where);

/// Warns about extensions that are not applied but may change the shape: known extensions in use, and unknown ones on
/// nodes, meshes, skins, accessors, buffer views or animations.
std::vector<Warning> extensionWarnings(const nlohmann::json& doc, const std::string& where);

}  // namespace shapespline
