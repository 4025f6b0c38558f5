#include "bindings/files/file_marshal.h"

#include <array>

// Structs whose fields keep their names in JSON. The definitions must be in the structs' namespace.
namespace shapespline {
namespace {

constexpr std::pair<const char*, Material::Alpha> alphas[] = {
    {"OPAQUE", Material::Alpha::Opaque}, {"MASK", Material::Alpha::Mask}, {"BLEND", Material::Alpha::Blend}};
constexpr std::pair<const char*, Material::Wrap> wraps[] = {
    {"repeat", Material::Wrap::Repeat}, {"clamp", Material::Wrap::Clamp}, {"mirror", Material::Wrap::Mirror}};

template <class T, std::size_t count>
const char* nameOf(T value, const std::pair<const char*, T> (&names)[count]) {
  for (const auto& [name, candidate] : names) {
    if (candidate == value) return name;
  }
  return "";
}

}  // namespace

void from_json(const nlohmann::json& json, Material::Alpha& value) { value = bindings::named(json, alphas); }
void from_json(const nlohmann::json& json, Material::Wrap& value) { value = bindings::named(json, wraps); }
void to_json(nlohmann::json& json, Material::Alpha value) { json = nameOf(value, alphas); }
void to_json(nlohmann::json& json, Material::Wrap value) { json = nameOf(value, wraps); }

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(MaterialGroup, start, count, material, name)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(ObjectFaces, name, start, count, nodeName, meshName, path, isGroup)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Material, name, baseColor, metallic, roughness, doubleSided, alphaMode, alphaCutoff,
                                   unlit, emissive, normalScale, occlusionStrength, baseColorImage,
                                   metallicRoughnessImage, normalImage, occlusionImage, emissiveImage, wrapS, wrapT,
                                   magFilter, minFilter)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(AnimationInfo, name, start, end, keys, moves, together)

}  // namespace shapespline

namespace shapespline::bindings {
namespace {

Json seamsJson(const Seams& seams) {
  if (seams.copyOf.empty()) return {};
  return {{"copyOf", range(seams.copyOf.data(), seams.copyOf.size())},
          {"indices", range(seams.faces.data()->data(), 3 * seams.faces.size())}};
}

}  // namespace

ImportOptions importOptionsFrom(const Json& json) {
  ImportOptions options;
  const Json& animation = json.at("animation");
  if (animation.is_string()) options.animation = animation.get<std::string>();
  if (animation.is_number()) options.animation = animation.get<int>();
  options.sampleTimes = json.at("sampleTimes").get<std::vector<double>>();
  options.frameTimes = json.at("frameTimes").get<std::vector<double>>();
  options.everyFrame = json.at("everyFrame");
  if (!json.at("sampleCount").is_null()) {
    options.sampleCount = json.at("sampleCount");
    options.sampleAsked = true;
  }
  options.keyTimes = json.at("keyTimes").get<std::vector<double>>();
  options.zUp = json.at("zUp");
  options.unit = json.at("unit");
  options.like = trianglesFrom(elements<std::int32_t>(json.at("like")));
  options.likePose = positionsFrom(elements<float>(json.at("likePose")));
  if (!json.at("offset").is_null()) options.offset = vec3From(json.at("offset"));
  options.likeObjects = json.at("likeObjects").get<std::vector<ObjectFaces>>();
  options.objects = json.at("objects").get<std::vector<std::string>>();
  return options;
}

Scene sceneFrom(const Json& json) {
  Scene scene;
  const auto uvs = elements<float>(json.at("uvs")), colors = elements<float>(json.at("colors"));
  scene.uvs.assign(uvs.begin(), uvs.end());
  scene.colors.assign(colors.begin(), colors.end());
  if (const Json& seams = json.at("seams"); !seams.is_null()) {
    const auto copyOf = elements<std::int32_t>(seams.at("copyOf"));
    scene.seams = {{copyOf.begin(), copyOf.end()}, trianglesFrom(elements<std::int32_t>(seams.at("indices")))};
  }
  const auto polygons = elements<std::int32_t>(json.at("polygons"));
  scene.polygons.assign(polygons.begin(), polygons.end());
  scene.objects = json.value("objects", Json::array()).get<std::vector<ObjectFaces>>();
  scene.groups = json.at("groups").get<std::vector<MaterialGroup>>();
  scene.materials = json.at("materials").get<std::vector<Material>>();
  for (const Json& image : json.at("images")) {
    const auto bytes = elements<std::uint8_t>(image.at("bytes"));
    scene.images.push_back({image.at("mimeType"), {bytes.begin(), bytes.end()}});
  }
  return scene;
}

Json toJson(const std::vector<AnimationInfo>& animations) { return animations; }

Json toJson(const std::vector<MatchedObject>& matches) {
  constexpr std::array rules{"name", "shape", "order"};
  Json list = Json::array();
  for (const MatchedObject& match : matches)
    list.push_back({{"key", match.key},
                    {"object", match.object},
                    {"found", match.found},
                    {"by", rules[static_cast<std::size_t>(match.rule)]}});
  return list;
}

Json toJson(const Scene& scene) {
  Json images = Json::array();
  for (const Image& image : scene.images) {
    images.push_back({{"mimeType", image.mimeType}, {"bytes", range(image.bytes.data(), image.bytes.size())}});
  }
  return {{"uvs", rangeOrNull(scene.uvs)},   {"colors", rangeOrNull(scene.colors)},
          {"seams", seamsJson(scene.seams)}, {"polygons", rangeOrNull(scene.polygons)},
          {"groups", scene.groups},          {"objects", scene.objects},
          {"materials", scene.materials},    {"images", images}};
}

}  // namespace shapespline::bindings
