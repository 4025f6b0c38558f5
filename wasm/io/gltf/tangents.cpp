#include "io/gltf/tangents.h"

#include <cmath>

namespace shapespline {

namespace {

Vec3 vec3(std::span<const float> values, int i) { return {values[3 * i], values[3 * i + 1], values[3 * i + 2]}; }
Vec2 vec2(std::span<const float> values, int i) { return {values[2 * i], values[2 * i + 1]}; }

// Any unit vector perpendicular to n.
Vec3 anyPerpendicular(const Vec3& n) {
  const Vec3 axis = std::abs(n.x()) < 0.7 ? Vec3::UnitX() : Vec3::UnitY();
  return axis.cross(n).normalized();
}

}  // namespace

std::vector<float> tangentsOf(std::span<const float> positions, std::span<const float> normals,
                              std::span<const float> uvs, const std::vector<Triangle>& faces) {
  const std::size_t n = positions.size() / 3;
  std::vector<Vec3> along(n, Vec3::Zero()), across(n, Vec3::Zero());  // dp/du and dp/dv, times the area in the texture
  for (const auto& [a, b, c] : faces) {
    const Vec3 e1 = vec3(positions, b) - vec3(positions, a), e2 = vec3(positions, c) - vec3(positions, a);
    const Vec2 d1 = vec2(uvs, b) - vec2(uvs, a), d2 = vec2(uvs, c) - vec2(uvs, a);
    const double sign = d1.x() * d2.y() - d1.y() * d2.x() < 0 ? -1 : 1;
    const Vec3 u = sign * (e1 * d2.y() - e2 * d1.y()), v = sign * (e2 * d1.x() - e1 * d2.x());
    for (int corner : {a, b, c}) {
      along[corner] += u;
      across[corner] += v;
    }
  }
  std::vector<float> out(4 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 normal = vec3(normals, static_cast<int>(i));
    Vec3 tangent = along[i] - normal * normal.dot(along[i]);
    const double length = tangent.norm();
    tangent = length > 1e-12 * along[i].norm() && std::isfinite(length) && length > 0 ? Vec3(tangent / length)
                                                                                      : anyPerpendicular(normal);
    for (int c = 0; c < 3; ++c) out[4 * i + c] = static_cast<float>(tangent[c]);
    // glTF's bitangent, cross(normal, tangent) * w, points up in the image: towards smaller v.
    out[4 * i + 3] = normal.cross(tangent).dot(across[i]) > 0 ? -1.0f : 1.0f;
  }
  return out;
}

}  // namespace shapespline
