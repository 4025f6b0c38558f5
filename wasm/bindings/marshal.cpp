#include "bindings/marshal.h"

#include <cstring>

namespace shapespline {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Warning, code, message, count, key, face, patches, about)

}  // namespace shapespline

namespace shapespline::bindings {

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

Json toJson(const std::vector<Warning>& warnings) { return warnings; }

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

}  // namespace shapespline::bindings
