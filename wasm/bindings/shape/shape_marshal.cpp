#include "bindings/shape/shape_marshal.h"

#include <optional>

// Structs whose fields keep their names in JSON. The definitions must be in the structs' namespace.
namespace shapespline {
namespace {

constexpr std::pair<const char*, Method> methods[] = {{"lri", Method::Lri},
                                                      {"geodesic", Method::Geodesic},
                                                      {"linear", Method::Linear},
                                                      {"cubic-vertex", Method::CubicVertex},
                                                      {"rotation-strain", Method::RotationStrain},
                                                      {"rimd", Method::Rimd}};
constexpr std::pair<const char*, BoundaryKind> boundaries[] = {
    {"natural", BoundaryKind::Natural}, {"hermite", BoundaryKind::Hermite}, {"periodic", BoundaryKind::Periodic}};
constexpr std::pair<const char*, Stretch> stretches[] = {{"linear", Stretch::Linear}, {"log", Stretch::Log}};
constexpr std::pair<const char*, Transfer> transfers[] = {{"exact", Transfer::Exact}, {"paper", Transfer::Paper}};

}  // namespace

void from_json(const nlohmann::json& json, Method& value) { value = bindings::named(json, methods); }
void from_json(const nlohmann::json& json, BoundaryKind& value) { value = bindings::named(json, boundaries); }
void from_json(const nlohmann::json& json, Stretch& value) { value = bindings::named(json, stretches); }
void from_json(const nlohmann::json& json, Transfer& value) { value = bindings::named(json, transfers); }

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(AddedTurns, key, turns, component)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SequenceStats, encodings, factorisations, solves, patches, weldedVertices,
                                   components, ghostFaces, ghostVertices, joinedComponents, weldMs, joinMs, simplifyMs,
                                   transferMs, encodeMs, orderMs, factorMs, arrangeMs, finishMs, factorBytes,
                                   localFramesMs, facesMs, solveMs, positionsMs, normalsMs, ghostMs)

}  // namespace shapespline

namespace shapespline::bindings {
namespace {

std::optional<Positions> tangentFrom(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return positionsFrom(elements<float>(json));
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

KeyTiming timingFrom(const Json& json) {
  return {json.at("earlier").get<std::vector<double>>(), json.at("swing").get<std::vector<double>>()};
}

}  // namespace

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
  motion.timing = timingFrom(json);
  for (const Json& region : json.at("regions"))
    motion.regions.push_back(
        {region.at("faces").get<std::vector<int>>(), timingFrom(region), region.at("soft").get<bool>()});
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

Json toJson(const SequenceStats& stats) { return stats; }

}  // namespace shapespline::bindings
