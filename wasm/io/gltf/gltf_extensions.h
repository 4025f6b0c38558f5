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
  Decoded,   ///< undone before the core reads the file
  Harmless,  ///< the shape and its motion are the same without it
  Ignored,   ///< it may change the shape or its motion, and is not applied
};

struct KnownExtension {
  std::string_view name;  ///< a trailing '*' stands for all names with this start
  ExtensionUse use;
};

/// All of them; where two fit a name, the first one counts.
std::span<const KnownExtension> knownExtensions();

/// Error: Unsupported for a required extension that is neither applied nor harmless; MalformedFile for a list that
/// holds something else than names.
Status checkRequiredExtensions(const nlohmann::json& doc, const std::string& where);

/// Names those that are not applied though they may change the shape: known ones that the file uses, and unknown ones
/// that it puts on nodes, meshes, skins, accessors or animations.
std::vector<Warning> extensionWarnings(const nlohmann::json& doc, const std::string& where);

}  // namespace shapespline
