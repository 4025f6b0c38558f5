// Prepares parts of glTF's JSON for tinygltf: rewrites old forms, and finds parts that tinygltf would reject.
#pragma once

#include <string>
#include <string_view>

#define JSON_NO_IO
#include <nlohmann/json.hpp>

namespace shapespline {

/// Member of a part's extras with the reason why the part cannot be read.
constexpr const char* brokenMember = "broken";

/// Replaces the core's values of every material with KHR_materials_pbrSpecularGlossiness. Returns the number of
/// textures that have no equivalent.
int rewriteSpecularGlossiness(nlohmann::json& doc);

/// Moves the names of morph targets from the targets to their primitive, as extras.targetNames.
void moveTargetNames(nlohmann::json& doc);

/// Whether one bad part of this collection is an error only where it is used.
bool mayBreak(std::string_view collection);

/// Why tinygltf would reject the file for this part; empty if it would not. The part's numbers have been checked.
std::string rejectedPart(const nlohmann::json& doc, std::string_view collection, const nlohmann::json& part);

/// Replaces the part by an empty one that states the reason.
void setAside(std::string_view collection, nlohmann::json& part, const std::string& reason);

}  // namespace shapespline
