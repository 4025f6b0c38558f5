#include "io/gltf/gltf_json.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/format.h"
#include "io/base/byte_text.h"
#include "io/base/limits.h"
#include "io/gltf/gltf_extensions.h"
#include "io/gltf/gltf_parts.h"
#include "io/gltf/malformed.h"

namespace shapespline {

namespace {

using nlohmann::json;

constexpr std::array collectionNames{"accessors", "animations", "buffers", "bufferViews", "cameras",
                                     "images",    "materials",  "meshes",  "nodes",       "samplers",
                                     "scenes",    "skins",      "textures"};

// Members that always hold an index, a count or a size.
constexpr std::array wholeNumbers{
    "buffer",        "bufferView", "byteLength", "byteOffset", "byteStride", "camera",
    "componentType", "count",      "index",      "indices",    "input",      "inverseBindMatrices",
    "material",      "mesh",       "mode",       "node",       "output",     "sampler",
    "scene",         "skeleton",   "skin",       "source",     "texCoord",   "wrapS",
    "wrapT"};

// Lists whose items are indices. In a scene, `nodes` is such a list.
constexpr std::array indexLists{"children", "joints", "nodes"};

constexpr std::array readExtensions{"EXT_mesh_gpu_instancing", "EXT_texture_webp",    "KHR_animation_pointer",
                                    "KHR_materials_unlit",     "KHR_node_visibility", "KHR_texture_basisu",
                                    "KHR_texture_transform"};

template <std::size_t N>
bool contains(const std::array<const char*, N>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The size of a document, counted before parsing.
struct Extent {
  int depth = 0;
  std::uint64_t objects = 0, values = 0;
};

Extent extentOf(std::string_view text) {
  Extent extent;
  int depth = 0;
  bool inString = false;
  for (std::size_t i = 0; i < text.size() && extent.depth <= deepestJson; ++i) {
    const char c = text[i];
    if (inString && c == '\\') ++i;
    else if (c == '"') inString = !inString;
    else if (inString) continue;
    else if (c == '{' || c == '[') {
      extent.depth = std::max(extent.depth, ++depth);
      extent.objects += c == '{';
      ++extent.values;
    } else if (c == '}' || c == ']') --depth;
    else if (c == ',') ++extent.values;
  }
  return extent;
}

Status checkExtent(std::string_view text, const std::string& where) {
  const Extent extent = extentOf(text);
  if (extent.depth > deepestJson)
    return malformed(where, "its JSON is nested more than " + std::to_string(deepestJson) + " levels deep");
  const bool objects = extent.objects > maxJsonObjects;
  if (!objects && extent.values <= maxJsonValues) return {};
  return Error{ErrorCode::TooLarge,
               where + ": its JSON exceeds the limit of " + grouped(objects ? maxJsonObjects : maxJsonValues) +
                   (objects ? " objects" : " values") + ". Join nodes and meshes, or export the shape alone."};
}

Result<json> parse(std::string_view text, const std::string& where) {
  while (!text.empty() && (text.back() == '\0' || text.back() == ' ')) text.remove_suffix(1);  // chunk padding
  if (const Status held = checkExtent(text, where); !held) return held.error();
  try {
    return json::parse(text.begin(), text.end());
  } catch (const json::parse_error& e) {
    if (e.byte > text.size())
      return Error{ErrorCode::TruncatedFile,
                   where + " is cut off: its JSON ends after " + sizeText(text.size()) + ". Copy or export it again."};
    return malformed(where, "its JSON is broken at byte " + grouped(static_cast<std::int64_t>(e.byte)));
  } catch (const json::exception&) {
    return malformed(where, "its JSON has a number that is out of range");
  }
}

// Walks the document once. Returns the problem, or "".
std::string tidy(json& node);

std::string tidyMember(const std::string& name, json& value, bool isIndex) {
  if (value.is_number_float()) {
    const double number = value.get<double>();
    if (std::floor(number) == number && std::abs(number) < 9e15) value = static_cast<std::int64_t>(number);
  }
  if (!isIndex) return tidy(value);
  // scene.nodes and the like are arrays. "camera", "index" and so on must be numbers.
  if (value.is_array() || value.is_object()) return tidy(value);
  if (!value.is_number_integer()) return inQuotes(name) + " is not a whole number";
  if (!value.is_number_unsigned() && value.get<std::int64_t>() < 0) return inQuotes(name) + " is negative";
  const auto number = value.get<std::uint64_t>();
  if (number > 0x7fffffffu) return inQuotes(name) + " is " + value.dump() + ", more than is supported";
  value = number;  // tinygltf expects unsigned integers
  return "";
}

void dropUnreadExtensions(json& node) {
  if (auto it = node.find("extensions"); it != node.end()) {
    if (!it->is_object()) node.erase(it);
    else
      for (auto e = it->begin(); e != it->end();) e = contains(readExtensions, e.key()) ? std::next(e) : it->erase(e);
  }
  if (auto it = node.find("extras"); it != node.end()) {
    const auto names = it->is_object() ? it->find("targetNames") : it->end();
    json kept = json::object();
    if (it->is_object() && names != it->end() && names->is_array()) kept["targetNames"] = *names;
    *it = kept;
  }
}

std::string tidy(json& node) {
  if (node.is_array()) {
    for (json& item : node)
      if (std::string wrong = tidyMember("", item, false); !wrong.empty()) return wrong;
    return "";
  }
  if (!node.is_object()) return "";
  dropUnreadExtensions(node);
  for (auto& [name, value] : node.items()) {
    if (name == "extras") continue;
    const bool attributes = name == "attributes";
    if (attributes && value.is_object())
      for (auto& [semantic, accessor] : value.items())
        if (std::string wrong = tidyMember(semantic, accessor, true); !wrong.empty()) return wrong;
    if (contains(indexLists, name) && value.is_array())
      for (json& index : value)
        if (std::string wrong = tidyMember(name, index, true); !wrong.empty()) return wrong;
    if (std::string wrong = tidyMember(name, value, contains(wholeNumbers, name)); !wrong.empty()) return wrong;
  }
  return "";
}

// Tidies the document. A bad part that may be unused is set aside.
std::string tidyDocument(json& doc) {
  for (auto& [name, value] : doc.items()) {
    if (!mayBreak(name)) continue;
    for (json& part : value) {
      std::string wrong = tidy(part);
      if (wrong.empty()) wrong = rejectedPart(doc, name, part);
      if (!wrong.empty()) setAside(name, part, wrong);
    }
  }
  dropUnreadExtensions(doc);
  for (auto& [name, value] : doc.items())
    if (name != "extras" && !mayBreak(name))
      if (std::string wrong = tidyMember(name, value, contains(wholeNumbers, name)); !wrong.empty()) return wrong;
  return "";
}

Status checkAsset(const json& doc, const std::string& where) {
  if (!doc.is_object()) return malformed(where, "its JSON is not an object, so it is not glTF");
  const auto asset = doc.find("asset");
  const bool known =
      asset != doc.end() && asset->is_object() && asset->contains("version") && (*asset)["version"].is_string();
  if (!known)
    return Error{ErrorCode::NotRecognised,
                 where + " is JSON but not glTF: it has no asset.version. Give a glTF 2.0 file."};
  const auto minimum = asset->find("minVersion");
  const bool hasMinimum = minimum != asset->end() && minimum->is_string();
  const auto needed = (hasMinimum ? *minimum : (*asset)["version"]).get<std::string>();
  if (hasMinimum ? needed != "2.0" : !needed.starts_with("2."))
    return Error{ErrorCode::Unsupported,
                 where + " needs glTF version " + inQuotes(needed) + "; only 2.0 is supported. Export it as glTF 2.0."};
  return {};
}

Status checkCollections(const json& doc, const std::string& where) {
  for (const char* name : collectionNames) {
    const auto collection = doc.find(name);
    if (collection == doc.end()) continue;
    if (!collection->is_array()) return malformed(where, std::string(name) + " is not a list");
    for (std::size_t i = 0; i < collection->size(); ++i)
      if (!(*collection)[i].is_object())
        return malformed(where, std::string(name) + "[" + std::to_string(i) + "] is not an object");
  }
  if (const auto materials = doc.find("materials"); materials != doc.end() && materials->size() > maxMaterials)
    return Error{ErrorCode::TooLarge,
                 where + " exceeds the limit of " + grouped(maxMaterials) + " materials. Join identical materials."};
  return {};
}

}  // namespace

Result<json> parseGltfJson(std::string_view text, const std::string& where, std::vector<Warning>& warnings) {
  auto parsed = parse(text, where);
  if (!parsed) return parsed.error();
  json& doc = *parsed;
  if (Status asset = checkAsset(doc, where); !asset) return asset.error();
  if (Status extensions = checkRequiredExtensions(doc, where); !extensions) return extensions.error();
  if (Status collections = checkCollections(doc, where); !collections) return collections.error();
  warnings = extensionWarnings(doc, where);
  if (const int lost = rewriteSpecularGlossiness(doc))
    warnings.push_back({"missing-texture",
                        where + ": textures of specular colour and glossiness are ignored. Export materials with "
                                "metallic and roughness to keep them.",
                        lost});
  moveTargetNames(doc);
  json extras = doc.value("extras", json());
  if (std::string wrong = tidyDocument(doc); !wrong.empty()) return malformed(where, wrong);
  doc["extras"] = std::move(extras);
  return std::move(doc);
}

}  // namespace shapespline
