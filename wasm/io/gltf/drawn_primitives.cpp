#include "io/gltf/drawn_primitives.h"

#include <algorithm>
#include <numeric>

namespace shapespline {

namespace {

// The scene's groups in face order. Faces outside all groups get groups without material.
std::vector<MaterialGroup> completeGroups(const Scene& scene, int faces) {
  std::vector<MaterialGroup> out;
  int next = 0;
  const auto add = [&](int end, int material) {
    end = std::min(end, faces);
    if (end <= next) return;
    out.push_back({next, end - next, material});
    next = end;
  };
  for (const MaterialGroup& g : scene.groups) {
    add(g.start, -1);
    add(g.start + g.count, g.material);
  }
  add(faces, -1);
  return out;
}

void addUnnamed(const std::vector<Triangle>& faces, std::vector<int>& vertices, int count) {
  std::vector<char> named(count, 0);
  for (const Triangle& face : faces)
    for (int v : face) named[v] = 1;
  for (int v = 0; v < count; ++v)
    if (!named[v]) vertices.push_back(v);
}

// `place`: scratch, one number per mesh vertex.
void numberCompactly(DrawnPrimitive& primitive, std::vector<int>& place) {
  std::vector<int>& vertices = primitive.vertices;
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (std::size_t i = 0; i < vertices.size(); ++i) place[vertices[i]] = static_cast<int>(i);
  for (Triangle& face : primitive.faces)
    for (int& v : face) v = place[v];
}

}  // namespace

std::vector<DrawnPrimitive> drawnPrimitives(const std::vector<Triangle>& faces, int vertices, const Scene& scene) {
  const std::vector<MaterialGroup> groups = completeGroups(scene, static_cast<int>(faces.size()));
  std::vector<DrawnPrimitive> out;
  std::vector<int> place(vertices);
  for (const MaterialGroup& group : groups) {
    DrawnPrimitive primitive;
    primitive.material = group.material < static_cast<int>(scene.materials.size()) ? group.material : -1;
    primitive.faces.assign(faces.begin() + group.start, faces.begin() + group.start + group.count);
    if (groups.size() == 1) {
      primitive.vertices.resize(vertices);
      std::iota(primitive.vertices.begin(), primitive.vertices.end(), 0);
    } else {
      for (const Triangle& face : primitive.faces)
        primitive.vertices.insert(primitive.vertices.end(), face.begin(), face.end());
      if (out.empty()) addUnnamed(faces, primitive.vertices, vertices);
      numberCompactly(primitive, place);
    }
    out.push_back(std::move(primitive));
  }
  return out;
}

}  // namespace shapespline
