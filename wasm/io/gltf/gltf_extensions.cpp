#include "io/gltf/gltf_extensions.h"

#include <algorithm>
#include <array>
#include <set>

#include "io/base/byte_text.h"
#include "io/base/objects.h"
#include "io/gltf/malformed.h"

namespace shapespline {

namespace {

using nlohmann::json;
using enum ExtensionUse;

constexpr std::array extensionList = std::to_array<KnownExtension>({
    {"EXT_mesh_gpu_instancing", Applied},
    {"EXT_texture_webp", Applied},
    {"KHR_animation_pointer", Applied},
    {"KHR_materials_pbrSpecularGlossiness", Applied},
    {"KHR_materials_unlit", Applied},
    {"KHR_mesh_quantization", Applied},
    {"KHR_node_visibility", Applied},
    {"KHR_texture_basisu", Applied},
    {"KHR_texture_transform", Applied},

    {"EXT_meshopt_compression", Decoded},
    {"KHR_draco_mesh_compression", Decoded},
    {"KHR_meshopt_compression", Decoded},

    {"ADOBE_materials_*", Harmless},
    {"ADOBE_render_order", Harmless},
    {"AGI_stk_metadata", Harmless},
    {"BENTLEY_materials_*", Harmless},
    {"CESIUM_primitive_outline", Harmless},
    {"CESIUM_tile_edges", Harmless},
    {"CVTOOLS_unity_metadata", Harmless},
    {"EXT_camera_physical", Harmless},
    {"EXT_feature_metadata", Harmless},
    {"EXT_instance_features", Harmless},
    {"EXT_lights_*", Harmless},
    {"EXT_materials_*", Harmless},
    {"EXT_mesh_features", Harmless},
    {"EXT_mesh_manifold", Harmless},
    {"EXT_mesh_opacity_micromap", Harmless},
    {"EXT_mesh_primitive_edge_visibility", Harmless},
    {"EXT_pbr_attributes", Harmless},
    {"EXT_structural_metadata", Harmless},
    {"EXT_texture_*", Harmless},
    {"FB_geometry_metadata", Harmless},
    {"FB_material_*", Harmless},
    {"FB_materials_*", Harmless},
    {"FB_ngon_encoding", Harmless},
    {"GODOT_single_root", Harmless},
    {"GRIFFEL_bim_data", Harmless},
    {"INTEL_lights_sunsky", Harmless},
    {"KHR_audio*", Harmless},
    {"KHR_character*", Harmless},
    {"KHR_collision_shapes", Harmless},
    {"KHR_implicit_shapes", Harmless},
    {"KHR_lights*", Harmless},
    {"KHR_materials_*", Harmless},
    {"KHR_node_hoverability", Harmless},
    {"KHR_node_selectability", Harmless},
    {"KHR_physics_rigid_bodies", Harmless},
    {"KHR_technique_webgl", Harmless},
    {"KHR_techniques_webgl", Harmless},
    {"KHR_texture_*", Harmless},
    {"KHR_xmp*", Harmless},
    {"MAXAR_collision_geometry", Harmless},
    {"MOZ_*", Harmless},
    {"MPEG_audio_spatial", Harmless},
    {"MPEG_haptic*", Harmless},
    {"MPEG_media", Harmless},
    {"MPEG_texture_video", Harmless},
    {"MPEG_viewport_recommended", Harmless},
    {"MSFT_audio_emitter", Harmless},
    {"MSFT_lod", Harmless},
    {"MSFT_packing_*", Harmless},
    {"MSFT_texture_dds", Harmless},
    {"NV_materials_mdl", Harmless},

    {"AGI_articulations", Ignored},
    {"BENTLEY_primitive_restart", Ignored},
    {"CESIUM_RTC", Ignored},
    {"CESIUM_z_up", Ignored},
    {"EXT_animation_*", Ignored},
    {"EXT_geopose", Ignored},
    {"EXT_implicit_*", Ignored},
    {"EXT_mesh_lod", Ignored},
    {"EXT_mesh_polygon", Ignored},
    {"EXT_mesh_primitive_restart", Ignored},
    {"EXT_node_lod", Ignored},
    {"EXT_primitive_*", Ignored},
    {"FRAUNHOFER_external_model", Ignored},
    {"KHR_accessor_*", Ignored},
    {"KHR_gaussian_splatting*", Ignored},
    {"KHR_interactivity", Ignored},
    {"KHR_mesh_primitive_restart", Ignored},
    {"KHR_mesh_variants", Ignored},
    {"KITTYCAD_boundary_representation", Ignored},
    {"MANYFOLD_mesh_progressive", Ignored},
    {"MAXAR_mesh_variants", Ignored},
    {"MESHOPT_compression", Ignored},
    {"MPEG_*", Ignored},
    {"VRMC_node_constraint", Ignored},
    {"VRMC_springBone", Ignored},
});

const KnownExtension* known(std::string_view name) {
  const auto fits = [&](const KnownExtension& one) {
    return one.name.ends_with('*') ? name.starts_with(one.name.substr(0, one.name.size() - 1)) : name == one.name;
  };
  const auto found = std::find_if(extensionList.begin(), extensionList.end(), fits);
  return found == extensionList.end() ? nullptr : &*found;
}

const json* memberOf(const json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto it = object.find(name);
  return it == object.end() ? nullptr : &*it;
}

// Document parts with extensions that may change the shape: nodes and the like, with their contents.
constexpr std::array shaping{"nodes",      "meshes",   "skins",    "accessors", "bufferViews", "animations",
                             "primitives", "channels", "samplers", "target",    "targets",     "sparse"};

// Adds the names of extensions on an object and its contents. The parser limits the depth.
void collect(const json& at, std::set<std::string>& names) {
  if (at.is_array())
    for (const json& item : at) collect(item, names);
  if (!at.is_object()) return;
  if (const json* extensions = memberOf(at, "extensions"); extensions && extensions->is_object())
    for (const auto& [name, value] : extensions->items())
      if (names.size() < maxObjects) names.insert(name);
  for (const char* member : shaping)
    if (const json* inside = memberOf(at, member)) collect(*inside, names);
}

}  // namespace

std::span<const KnownExtension> knownExtensions() { return extensionList; }

Status checkRequiredExtensions(const json& doc, const std::string& where) {
  const json* required = memberOf(doc, "extensionsRequired");
  if (!required || !required->is_array()) return {};
  for (const json& name : *required) {
    if (!name.is_string()) return malformed(where, "extensionsRequired has an entry that is not a name");
    const std::string& text = name.get_ref<const std::string&>();
    const KnownExtension* extension = known(text);
    if (extension && (extension->use == Applied || extension->use == Harmless)) continue;
    return Error{ErrorCode::Unsupported, where + " needs the glTF extension " + inQuotes(text) +
                                             ", which is not supported. Export it without that extension."};
  }
  return {};
}

std::vector<Warning> extensionWarnings(const json& doc, const std::string& where) {
  std::set<std::string> onShape, ignored;
  // The document's own samplers belong to textures.
  for (const char* collection : {"nodes", "meshes", "skins", "accessors", "bufferViews", "animations"})
    if (const json* items = memberOf(doc, collection)) collect(*items, onShape);
  for (const std::string& name : onShape)
    if (const KnownExtension* extension = known(name); !extension || extension->use == Ignored) ignored.insert(name);
  std::set<std::string> used;
  if (const json* list = memberOf(doc, "extensionsUsed"); list && list->is_array())
    for (const json& name : *list)
      if (name.is_string() && used.size() < maxObjects) used.insert(name.get<std::string>());
  for (const std::string& name : used)
    if (const KnownExtension* extension = known(name); extension && extension->use == Ignored) ignored.insert(name);
  if (ignored.empty()) return {};
  const bool one = ignored.size() == 1;
  return {{"extension-ignored",
           where + ": the glTF " + (one ? "extension " : "extensions ") + objectList({ignored.begin(), ignored.end()}) +
               (one ? " is ignored. It may" : " are ignored. They may") +
               " change the shape or its motion. If the shape looks wrong, export it without " +
               (one ? "this extension." : "these extensions."),
           static_cast<int>(ignored.size())}};
}

}  // namespace shapespline
