// Primitives of a written mesh. Each has its own vertices, because players copy all vertices that a primitive refers
// to, once per primitive.
#pragma once

#include <span>
#include <vector>

#include "core/base/types.h"
#include "io/base/scene.h"

namespace shapespline {

/// Faces with one material, and their vertices.
struct DrawnPrimitive {
  int material = -1;            ///< index into Scene::materials, or -1
  std::vector<int> vertices;    ///< drawn vertex indices of the mesh, increasing
  std::vector<Triangle> faces;  ///< faces as indices into `vertices`
};

/// Returns one primitive per material group, in face order. Faces without a group get no material. `faces` refer to
/// drawn `vertices`. Unused vertices go into the first primitive, so none is lost.
std::vector<DrawnPrimitive> drawnPrimitives(const std::vector<Triangle>& faces, int vertices, const Scene& scene);

/// Selects a primitive's values from those of the whole mesh, `width` numbers per vertex.
template <class Number>
std::vector<Number> gathered(std::span<const Number> numbers, std::size_t width, const DrawnPrimitive& primitive) {
  std::vector<Number> out;
  out.reserve(width * primitive.vertices.size());
  for (int v : primitive.vertices)
    for (std::size_t i = 0; i < width; ++i) out.push_back(numbers[width * v + i]);
  return out;
}

}  // namespace shapespline
