#include "bindings/marshal.h"

#include <array>
#include <cstring>
#include <iterator>

// Structs whose fields travel under their own names, at home in their namespace.
namespace shapespline {
namespace {

// The engine has checked every name before; a stranger is a defect and becomes an internal error.
template <class T, std::size_t count>
T named(const nlohmann::json& json, const std::pair<const char*, T> (&names)[count]) {
  const auto text = json.get<std::string>();
  for (const auto& [name, value] : names) {
    if (text == name) return value;
  }
  throw std::invalid_argument("no such choice: " + text);
}

template <class T, std::size_t count>
const char* nameOf(T value, const std::pair<const char*, T> (&names)[count]) {
  for (const auto& [name, candidate] : names) {
    if (candidate == value) return name;
  }
  return "";
}

constexpr std::pair<const char*, Method> methods[] = {{"lri", Method::Lri},
                                                      {"geodesic", Method::Geodesic},
                                                      {"linear", Method::Linear},
                                                      {"cubic-vertex", Method::CubicVertex}};
constexpr std::pair<const char*, BoundaryKind> boundaries[] = {
    {"natural", BoundaryKind::Natural}, {"hermite", BoundaryKind::Hermite}, {"periodic", BoundaryKind::Periodic}};
constexpr std::pair<const char*, Stretch> stretches[] = {{"linear", Stretch::Linear}, {"log", Stretch::Log}};
constexpr std::pair<const char*, Transfer> transfers[] = {{"exact", Transfer::Exact}, {"paper", Transfer::Paper}};
constexpr std::pair<const char*, Material::Alpha> alphas[] = {
    {"OPAQUE", Material::Alpha::Opaque}, {"MASK", Material::Alpha::Mask}, {"BLEND", Material::Alpha::Blend}};
constexpr std::pair<const char*, Material::Wrap> wraps[] = {
    {"repeat", Material::Wrap::Repeat}, {"clamp", Material::Wrap::Clamp}, {"mirror", Material::Wrap::Mirror}};

}  // namespace

void from_json(const nlohmann::json& json, Method& value) { value = named(json, methods); }
void from_json(const nlohmann::json& json, BoundaryKind& value) { value = named(json, boundaries); }
void from_json(const nlohmann::json& json, Stretch& value) { value = named(json, stretches); }
void from_json(const nlohmann::json& json, Transfer& value) { value = named(json, transfers); }
void from_json(const nlohmann::json& json, Material::Alpha& value) { value = named(json, alphas); }
void from_json(const nlohmann::json& json, Material::Wrap& value) { value = named(json, wraps); }
void to_json(nlohmann::json& json, Material::Alpha value) { json = nameOf(value, alphas); }
void to_json(nlohmann::json& json, Material::Wrap value) { json = nameOf(value, wraps); }

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(AddedTurns, key, turns, component)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(MaterialGroup, start, count, material, name)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(ObjectFaces, name, start, count, nodeName, meshName, path, isGroup)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Material, name, baseColor, metallic, roughness, doubleSided, alphaMode, alphaCutoff,
                                   unlit, emissive, normalScale, occlusionStrength, baseColorImage,
                                   metallicRoughnessImage, normalImage, occlusionImage, emissiveImage, wrapS, wrapT,
                                   magFilter, minFilter)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Warning, code, message, count, key, face, patches)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(AnimationInfo, name, start, end, keys, moves)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SequenceStats, encodings, factorisations, solves, patches, weldedVertices,
                                   components, ghostFaces, ghostVertices, joinedComponents, weldMs, joinMs, simplifyMs,
                                   transferMs, encodeMs, orderMs, factorMs, arrangeMs, finishMs, factorBytes, framesMs,
                                   facesMs, solveMs, placeMs, normalsMs, ghostMs)

}  // namespace shapespline

namespace shapespline::bindings {
namespace {

std::optional<Positions> tangentFrom(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return positionsFrom(elements<float>(json));
}

Json seamsJson(const Seams& seams) {
  if (seams.copyOf.empty()) return {};
  return {{"copyOf", range(seams.copyOf.data(), seams.copyOf.size())},
          {"indices", range(seams.faces.data()->data(), 3 * seams.faces.size())}};
}

Pin pinFrom(const Json& json) {
  Pin pin;
  pin.vertex = json.at("vertex");
  pin.radius = json.at("radius");
  if (json.contains("stay")) pin.key = json.at("stay");
  if (!json.contains("path")) return pin;
  for (const Json& key : json.at("path")) {
    pin.path.push_back({key.at("time"), vec3From(key.at("move"))});
  }
  return pin;
}

}  // namespace

Positions positionsFrom(std::span<const float> numbers) {
  Positions positions(numbers.size() / 3);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    positions[i] = Vec3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
  }
  return positions;
}

Vec3 vec3From(const Json& json) {
  return Vec3(json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>());
}

std::vector<float> floatsFrom(const Positions& positions) {
  std::vector<float> numbers;
  numbers.reserve(3 * positions.size());
  for (const Vec3& p : positions) {
    for (int i = 0; i < 3; ++i) numbers.push_back(static_cast<float>(p[i]));
  }
  return numbers;
}

std::vector<Triangle> trianglesFrom(std::span<const std::int32_t> indices) {
  static_assert(sizeof(Triangle) == 3 * sizeof(std::int32_t));
  std::vector<Triangle> triangles(indices.size() / 3);
  if (!triangles.empty()) std::memcpy(triangles.data(), indices.data(), triangles.size() * sizeof(Triangle));
  return triangles;
}

Keyframes keyframesFrom(const Json& json) {
  Keyframes keyframes;
  keyframes.faces = trianglesFrom(elements<std::int32_t>(json.at("faces")));
  keyframes.normals = positionsFrom(elements<float>(json.at("normals")));
  for (const Json& key : json.at("keys")) {
    keyframes.keys.push_back({key.at("name"), key.at("time"), positionsFrom(elements<float>(key.at("positions")))});
  }
  return keyframes;
}

MotionOptions motionFrom(const Json& json) {
  MotionOptions motion;
  motion.method = json.at("method");
  motion.hold = json.at("hold") == "on";
  motion.boundary = json.at("boundary");
  motion.startSpeed = json.at("startSpeed");
  motion.endSpeed = json.at("endSpeed");
  if (!json.at("period").is_null()) motion.period = json.at("period").get<double>();
  motion.tension = json.at("tension").get<std::vector<double>>();
  motion.bias = json.at("bias").get<std::vector<double>>();
  motion.turns = json.at("turns").get<std::vector<AddedTurns>>();
  for (const Json& pin : json.at("pins")) motion.pins.push_back(pinFrom(pin));
  motion.inPlace = json.at("inPlace");
  return motion;
}

EncodingOptions encodingFrom(const Json& json) {
  EncodingOptions encoding;
  encoding.reference = json.at("reference");
  encoding.patches = json.at("patches");
  encoding.stretch = json.at("stretch");
  encoding.ghostFaces = json.at("ghostFaces");
  encoding.transfer = json.at("transfer");
  encoding.optimalPlacement = json.at("placement") == "optimal";
  if (json.at("precision") == "exact") encoding.precision = Precision::Exact;
  encoding.startTangent = tangentFrom(json.at("startTangent"));
  encoding.endTangent = tangentFrom(json.at("endTangent"));
  return encoding;
}

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

Json toJson(const std::vector<Warning>& warnings) { return warnings; }
Json toJson(const SequenceStats& stats) { return stats; }
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

Json toJson(const MeshReport& report) {
  return {{"vertices", report.vertices},
          {"weldedVertices", report.weldedVertices},
          {"faces", report.faces},
          {"components", report.components},
          {"boundaryEdges", report.counts.boundaryEdges},
          {"nonManifoldEdges", report.counts.nonManifoldEdges},
          {"degenerateFaces", report.degenerateFaces},
          {"duplicateFaces", report.counts.duplicateFaces},
          {"unreferencedVertices", report.unreferencedVertices},
          {"inconsistentEdges", report.counts.inconsistentEdges},
          {"diagonal", report.diagonal}};
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
