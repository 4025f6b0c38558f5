#include "io/gltf/gltf_parts.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "core/base/status.h"

namespace shapespline {

namespace {

using nlohmann::json;

json* field(json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto it = object.find(name);
  return it == object.end() ? nullptr : &*it;
}

const json* field(const json& object, const char* name) { return field(const_cast<json&>(object), name); }

// The items of a list, or none.
template <class Json, class Visit>
void eachOf(Json* list, Visit visit) {
  if (list && list->is_array())
    for (auto& item : *list) visit(item);
}

bool isIndex(const json* value) { return value && value->is_number_unsigned(); }

std::size_t sizeOf(const json& doc, const char* collection) {
  const json* list = field(doc, collection);
  return list && list->is_array() ? list->size() : 0;
}

// The first of these members that is not a number, as the start of a sentence.
std::string lacking(const json& part, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (!isIndex(field(part, name))) return "it has no \"" + std::string(name) + "\"";
  return "";
}

std::string rejectedAccessor(const json& doc, const json& part) {
  constexpr std::array types{"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
  if (std::string wrong = lacking(part, {"componentType", "count"}); !wrong.empty()) return wrong;
  const auto component = part["componentType"].get<std::uint64_t>();
  if (component < 5120 || component > 5130) return "its component type is unknown";
  const json* type = field(part, "type");
  if (!type || std::find(types.begin(), types.end(), *type) == types.end()) return "its type is unknown";
  if (const json* view = field(part, "bufferView");
      isIndex(view) && view->get<std::uint64_t>() >= sizeOf(doc, "bufferViews"))
    return "it refers to a buffer view that does not exist";
  const json* sparse = field(part, "sparse");
  if (!sparse) return "";
  const json *indices = field(*sparse, "indices"), *values = field(*sparse, "values");
  if (!indices || !values) return "its sparse elements have no indices or values";
  std::string wrong = lacking(*sparse, {"count"});
  if (wrong.empty()) wrong = lacking(*indices, {"bufferView", "componentType"});
  return wrong.empty() ? lacking(*values, {"bufferView"}) : wrong;
}

std::string rejectedView(const json& part) {
  if (std::string wrong = lacking(part, {"buffer", "byteLength"}); !wrong.empty()) return wrong;
  const json* stride = field(part, "byteStride");
  const auto bytes = isIndex(stride) ? stride->get<std::uint64_t>() : 0;
  return bytes > 252 || bytes % 4 != 0 ? "its stride is not a multiple of 4 up to 252" : "";
}

std::string rejectedMesh(const json& doc, const json& part) {
  std::string wrong;
  eachOf(field(part, "primitives"), [&](const json& primitive) {
    const json *attributes = field(primitive, "attributes"), *indices = field(primitive, "indices");
    const auto isNumber = [](const json& value) { return value.is_number_integer(); };
    if (!attributes || !attributes->is_object() || !std::all_of(attributes->begin(), attributes->end(), isNumber))
      wrong = "a primitive has no valid attributes";
    if (isIndex(indices) && indices->get<std::uint64_t>() >= sizeOf(doc, "accessors"))
      wrong = "the indices refer to an accessor that does not exist";
  });
  return wrong;
}

std::string rejectedAnimation(const json& part) {
  std::string wrong;
  eachOf(field(part, "samplers"), [&](const json& sampler) {
    if (std::string here = lacking(sampler, {"input", "output"}); !here.empty()) wrong = "a sampler: " + here;
  });
  eachOf(field(part, "channels"), [&](const json& channel) {
    if (std::string here = lacking(channel, {"sampler"}); !here.empty()) wrong = "a channel: " + here;
  });
  return wrong;
}

// Keeps the targets of an animation, which decide whether it moves the mesh.
json withoutSamplers(const json& animation) {
  json out = {{"channels", json::array()}, {"samplers", json::array()}};
  if (const json* name = field(animation, "name")) out["name"] = *name;
  eachOf(field(animation, "channels"), [&](const json& channel) {
    const json* target = field(channel, "target");
    const json *node = target ? field(*target, "node") : nullptr, *path = target ? field(*target, "path") : nullptr;
    if (!path || !path->is_string()) return;
    // An invalid node may be any node, and a pointer may lead to any node.
    const bool valid = isIndex(node) && node->get<std::uint64_t>() <= 0x7fffffffu && *path != "pointer";
    out["channels"].push_back(
        {{"sampler", 0u},
         {"target",
          {{"node", valid ? *node : json(0x7fffffffu)}, {"path", *path == "pointer" ? json("translation") : *path}}}});
  });
  return out;
}

}  // namespace

int rewriteSpecularGlossiness(json& doc) {
  int lost = 0;
  eachOf(field(doc, "materials"), [&](json& material) {
    json* extensions = field(material, "extensions");
    const json* old = extensions ? field(*extensions, "KHR_materials_pbrSpecularGlossiness") : nullptr;
    if (!old || !old->is_object()) return;
    const json* glossiness = field(*old, "glossinessFactor");
    json pbr = {{"metallicFactor", 0},
                {"roughnessFactor", glossiness && glossiness->is_number() ? 1 - glossiness->get<double>() : 0.0}};
    if (const json* color = field(*old, "diffuseFactor")) pbr["baseColorFactor"] = *color;
    if (const json* texture = field(*old, "diffuseTexture")) pbr["baseColorTexture"] = *texture;
    lost += field(*old, "specularGlossinessTexture") != nullptr;
    material["pbrMetallicRoughness"] = std::move(pbr);
  });
  return lost;
}

void moveTargetNames(json& doc) {
  eachOf(field(doc, "meshes"), [](json& mesh) {
    eachOf(field(mesh, "primitives"), [](json& primitive) {
      json names = json::array();
      bool any = false;
      eachOf(field(primitive, "targets"), [&](const json& target) {
        names.push_back("");
        for (const char* place : {"extra", "extras"})
          if (const json* extra = field(target, place))
            if (const json* name = field(*extra, "name"); name && name->is_string()) {
              names.back() = *name;
              any = true;
            }
      });
      if (!any) return;
      json& extras = primitive["extras"];
      if (!extras.is_object()) extras = json::object();
      if (!extras.contains("targetNames")) extras["targetNames"] = std::move(names);
    });
  });
}

bool mayBreak(std::string_view collection) {
  constexpr std::array<std::string_view, 5> names{"accessors", "animations", "bufferViews", "materials", "meshes"};
  return std::find(names.begin(), names.end(), collection) != names.end();
}

std::string rejectedPart(const json& doc, std::string_view collection, const json& part) {
  if (collection == "accessors") return rejectedAccessor(doc, part);
  if (collection == "bufferViews") return rejectedView(part);
  if (collection == "meshes") return rejectedMesh(doc, part);
  if (collection == "animations") return rejectedAnimation(part);
  const json* emissive = field(part, "emissiveFactor");
  const bool fits = !emissive || !emissive->is_array() || emissive->size() == 3 || emissive->size() == 4;
  return fits ? "" : "its emissive colour has the wrong number of values";
}

void setAside(std::string_view collection, json& part, const std::string& reason) {
  json empty = json::object();
  if (collection == "accessors") empty = {{"componentType", 5120u}, {"count", 0u}, {"type", "SCALAR"}};
  if (collection == "bufferViews") empty = {{"buffer", 0u}, {"byteLength", 0u}};
  if (collection == "animations") empty = withoutSamplers(part);
  empty["extras"] = {{brokenMember, reason}};
  part = std::move(empty);
}

}  // namespace shapespline
