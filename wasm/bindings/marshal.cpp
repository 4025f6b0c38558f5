#include "bindings/marshal.h"

#include <cstring>
#include <iterator>

namespace shapespline::bindings {
namespace {

// The engine has checked every name before; a stranger is a defect and becomes an internal error.
template <class T, std::size_t count>
T named(const Json& json, const std::pair<const char*, T> (&names)[count]) {
  const auto text = json.get<std::string>();
  for (const auto& [name, value] : names) {
    if (text == name) return value;
  }
  throw std::invalid_argument("no such choice: " + text);
}

constexpr std::pair<const char*, Method> methods[] = {{"lri", Method::Lri},
                                                      {"geodesic", Method::Geodesic},
                                                      {"linear", Method::Linear},
                                                      {"cubic-vertex", Method::CubicVertex}};
constexpr std::pair<const char*, BoundaryKind> boundaries[] = {{"natural", BoundaryKind::Natural},
                                                               {"hermite", BoundaryKind::Hermite},
                                                               {"periodic", BoundaryKind::Periodic}};
constexpr std::pair<const char*, Stretch> stretches[] = {{"linear", Stretch::Linear}, {"log", Stretch::Log}};
constexpr std::pair<const char*, Transfer> transfers[] = {{"exact", Transfer::Exact}, {"paper", Transfer::Paper}};
constexpr std::pair<const char*, Precision> precisions[] = {{"single", Precision::Single},
                                                            {"double", Precision::Double},
                                                            {"exact", Precision::Exact}};
constexpr std::pair<const char*, Material::Alpha> alphas[] = {{"OPAQUE", Material::Alpha::Opaque},
                                                              {"MASK", Material::Alpha::Mask},
                                                              {"BLEND", Material::Alpha::Blend}};

constexpr std::pair<const char*, Material::Wrap> wraps[] = {{"repeat", Material::Wrap::Repeat},
                                                            {"clamp", Material::Wrap::Clamp},
                                                            {"mirror", Material::Wrap::Mirror}};
constexpr std::pair<const char*, int Material::*> images[] = {{"baseColorImage", &Material::baseColorImage},
                                                              {"metallicRoughnessImage", &Material::metallicRoughnessImage},
                                                              {"normalImage", &Material::normalImage},
                                                              {"occlusionImage", &Material::occlusionImage},
                                                              {"emissiveImage", &Material::emissiveImage}};

template <class T, std::size_t count>
const char* nameOf(T value, const std::pair<const char*, T> (&names)[count]) {
  for (const auto& [name, candidate] : names) {
    if (candidate == value) return name;
  }
  return "";
}

std::optional<Positions> tangentFrom(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return positionsFrom(elements<float>(json));
}

Material materialFrom(const Json& json) {
  Material material;
  material.name = json.at("name");
  material.baseColor = json.at("baseColor");
  material.metallic = json.at("metallic");
  material.roughness = json.at("roughness");
  material.doubleSided = json.at("doubleSided");
  material.alpha = named(json.at("alphaMode"), alphas);
  material.alphaCutoff = json.at("alphaCutoff");
  material.unlit = json.at("unlit");
  material.emissive = json.at("emissive");
  material.normalScale = json.at("normalScale");
  material.occlusionStrength = json.at("occlusionStrength");
  for (const auto& [name, image] : images) material.*image = json.at(name);
  material.wrapS = named(json.at("wrapS"), wraps);
  material.wrapT = named(json.at("wrapT"), wraps);
  material.magFilter = json.at("magFilter");
  material.minFilter = json.at("minFilter");
  return material;
}

Json toJson(const Material& material) {
  Json json = {{"name", material.name},
               {"baseColor", material.baseColor},
               {"metallic", material.metallic},
               {"roughness", material.roughness},
               {"doubleSided", material.doubleSided},
               {"alphaMode", nameOf(material.alpha, alphas)},
               {"alphaCutoff", material.alphaCutoff},
               {"unlit", material.unlit},
               {"emissive", material.emissive},
               {"normalScale", material.normalScale},
               {"occlusionStrength", material.occlusionStrength},
               {"wrapS", nameOf(material.wrapS, wraps)},
               {"wrapT", nameOf(material.wrapT, wraps)},
               {"magFilter", material.magFilter},
               {"minFilter", material.minFilter}};
  for (const auto& [name, image] : images) json[name] = material.*image;
  return json;
}

Json toJson(const Seams& seams) {
  if (seams.copyOf.empty()) return {};
  return {{"copyOf", range(seams.copyOf.data(), seams.copyOf.size())},
          {"indices", range(seams.faces.data()->data(), 3 * seams.faces.size())}};
}

}  // namespace

Positions positionsFrom(std::span<const float> numbers) {
  Positions positions(numbers.size() / 3);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    positions[i] = Vec3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
  }
  return positions;
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
  motion.method = named(json.at("method"), methods);
  motion.boundary = named(json.at("boundary"), boundaries);
  motion.startSpeed = json.at("startSpeed");
  motion.endSpeed = json.at("endSpeed");
  if (!json.at("period").is_null()) motion.period = json.at("period").get<double>();
  motion.tension = json.at("tension").get<std::vector<double>>();
  motion.bias = json.at("bias").get<std::vector<double>>();
  for (const Json& entry : json.at("turns")) motion.turns.push_back({entry.at("key"), entry.at("turns"), entry.value("component", -1)});
  motion.inPlace = json.at("inPlace");
  return motion;
}

EncodingOptions encodingFrom(const Json& json) {
  EncodingOptions encoding;
  encoding.reference = json.at("reference");
  encoding.patches = json.at("patches");
  encoding.stretch = named(json.at("stretch"), stretches);
  encoding.ghostFaces = json.at("ghostFaces");
  encoding.transfer = named(json.at("transfer"), transfers);
  encoding.optimalPlacement = json.at("placement") == "optimal";
  encoding.precision = named(json.at("precision"), precisions);
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
  if (!json.at("sampleCount").is_null()) {
    options.sampleCount = json.at("sampleCount");
    options.sampleAsked = true;
  }
  options.keyTimes = json.at("keyTimes").get<std::vector<double>>();
  options.zUp = json.at("zUp");
  options.unit = json.at("unit");
  options.like = trianglesFrom(elements<std::int32_t>(json.at("like")));
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
  for (const Json& group : json.at("groups")) {
    scene.groups.push_back({group.at("start"), group.at("count"), group.at("material")});
  }
  for (const Json& material : json.at("materials")) scene.materials.push_back(materialFrom(material));
  for (const Json& image : json.at("images")) {
    const auto bytes = elements<std::uint8_t>(image.at("bytes"));
    scene.images.push_back({image.at("mimeType"), {bytes.begin(), bytes.end()}});
  }
  return scene;
}

Json toJson(const std::vector<Warning>& warnings) {
  Json json = Json::array();
  for (const Warning& w : warnings) {
    json.push_back({{"code", w.code}, {"message", w.message}, {"count", w.count}, {"key", w.key}, {"face", w.face}, {"patches", w.patches}});
  }
  return json;
}

Json toJson(const SequenceStats& stats) {
  return {{"encodings", stats.encodings},
          {"factorisations", stats.factorisations},
          {"solves", stats.solves},
          {"patches", stats.patches},
          {"weldedVertices", stats.weldedVertices},
          {"components", stats.components},
          {"ghostFaces", stats.ghostFaces},
          {"ghostVertices", stats.ghostVertices},
          {"joinedComponents", stats.joinedComponents},
          {"weldMs", stats.weldMs},
          {"simplifyMs", stats.simplifyMs},
          {"transferMs", stats.transferMs},
          {"encodeMs", stats.encodeMs},
          {"orderMs", stats.orderMs},
          {"factorMs", stats.factorMs},
          {"arrangeMs", stats.arrangeMs},
          {"factorBytes", stats.factorBytes},
          {"framesMs", stats.framesMs},
          {"facesMs", stats.facesMs},
          {"solveMs", stats.solveMs},
          {"placeMs", stats.placeMs},
          {"normalsMs", stats.normalsMs},
          {"ghostMs", stats.ghostMs}};
}

Json toJson(const std::vector<AnimationInfo>& animations) {
  Json json = Json::array();
  for (const AnimationInfo& a : animations) {
    json.push_back({{"name", a.name}, {"start", a.start}, {"end", a.end}, {"keys", a.keys}});
  }
  return json;
}

Json toJson(const Scene& scene) {
  Json groups = Json::array(), materials = Json::array(), images = Json::array();
  for (const MaterialGroup& g : scene.groups) {
    groups.push_back({{"start", g.start}, {"count", g.count}, {"material", g.material}});
  }
  for (const Material& material : scene.materials) materials.push_back(toJson(material));
  for (const Image& image : scene.images) {
    images.push_back({{"mimeType", image.mimeType}, {"bytes", range(image.bytes.data(), image.bytes.size())}});
  }
  return {{"uvs", rangeOrNull(scene.uvs)},
          {"colors", rangeOrNull(scene.colors)},
          {"seams", toJson(scene.seams)},
          {"groups", groups},
          {"materials", materials},
          {"images", images}};
}

}  // namespace shapespline::bindings
