#include "io/gltf/gltf_vertices.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <string>
#include <tuple>

#include "io/base/limits.h"
#include "io/gltf/gltf_accessor.h"

namespace shapespline {

namespace {

// Reads a whole number for each vertex of the shape. Returns an empty list if some part has none, or has other numbers.
std::vector<int> vertexNumbers(const GltfDocument& doc, const GltfShape& shape, std::string_view name) {
  std::vector<int> out;
  out.reserve(shape.vertexCount);
  for (const GltfPart& part : shape.parts) {
    const auto attribute = part.primitive->attributes.find(std::string(name));
    if (attribute == part.primitive->attributes.end() || accessorCount(doc, attribute->second) != part.positions.size())
      return {};
    const auto numbers = readNumbers(doc, attribute->second, 1, std::string(name) + " of " + part.name);
    if (!numbers) return {};
    for (double number : *numbers) {
      const bool isVertex = number >= 0 && number < static_cast<double>(maxElements) && number == std::floor(number);
      if (!isVertex) return {};
      out.push_back(static_cast<int>(number));
    }
  }
  return out;
}

// Groups the file's vertices by mesh vertex, and then by drawn vertex.
struct Joining {
  const Scene& scene;
  std::vector<int> order;   // file vertices, sorted by mesh vertex, then by drawn vertex
  std::vector<int> vertex;  // mesh vertex of each file vertex
  std::vector<int> first;   // representative file vertex of each mesh vertex
  std::vector<int> drawn;   // drawn vertex of each file vertex; empty without coordinates
  std::vector<int> source;  // representative file vertex of each drawn vertex
  std::vector<int> copyOf;

  void numberVertices(const std::vector<int>& numbers, const std::vector<int>& drawnNumbers) {
    const auto rank = [&](int v) { return std::pair(numbers[v], drawnNumbers.empty() ? 0 : drawnNumbers[v]); };
    order.resize(numbers.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return rank(a) < rank(b); });
    vertex.resize(numbers.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i == 0 || numbers[order[i]] != numbers[order[i - 1]]) first.push_back(order[i]);
      vertex[order[i]] = static_cast<int>(first.size()) - 1;
    }
  }

  bool standTogether(const Positions& pose) const {
    for (std::size_t v = 0; v < vertex.size(); ++v)
      if (pose[v] != pose[first[vertex[v]]]) return false;
    return true;
  }

  // A vertex gets the coordinates of its first file vertex. File vertices with other coordinates become copies.
  void numberDrawn(const std::vector<int>& drawnNumbers) {
    struct Copy {
      int number, vertex, source;
    };
    const auto number = [&](int v) { return drawnNumbers.empty() ? v : drawnNumbers[v]; };
    const auto place = [&](int v) { return std::tuple(vertex[v], scene.uvs[2 * v], scene.uvs[2 * v + 1]); };
    std::vector<int> apart;
    std::copy_if(order.begin(), order.end(), std::back_inserter(apart),
                 [&](int v) { return place(v) != place(first[vertex[v]]); });
    std::sort(apart.begin(), apart.end(), [&](int a, int b) {
      return place(a) != place(b) ? place(a) < place(b) : std::pair(number(a), a) < std::pair(number(b), b);
    });
    std::vector<Copy> copies;
    std::vector<int> copyAt(vertex.size(), -1);  // index of each file vertex among the copies
    for (std::size_t i = 0; i < apart.size(); ++i) {
      if (i == 0 || place(apart[i]) != place(apart[i - 1]))
        copies.push_back({number(apart[i]), vertex[apart[i]], apart[i]});
      copyAt[apart[i]] = static_cast<int>(copies.size()) - 1;
    }
    std::vector<int> sorted(copies.size()), drawnAt(copies.size());
    std::iota(sorted.begin(), sorted.end(), 0);
    std::stable_sort(sorted.begin(), sorted.end(), [&](int a, int b) { return copies[a].number < copies[b].number; });
    source = first;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      drawnAt[sorted[i]] = static_cast<int>(first.size() + i);
      copyOf.push_back(copies[sorted[i]].vertex);
      source.push_back(copies[sorted[i]].source);
    }
    drawn = vertex;
    for (std::size_t v = 0; v < drawn.size(); ++v)
      if (copyAt[v] >= 0) drawn[v] = drawnAt[copyAt[v]];
  }
};

template <class Values>
void take(Values& values, const std::vector<int>& from, std::size_t width = 1) {
  if (values.empty()) return;
  Values out;
  out.reserve(width * from.size());
  for (int v : from)
    for (std::size_t i = 0; i < width; ++i) out.push_back(values[width * v + i]);
  values = std::move(out);
}

void renumber(std::vector<Triangle>& faces, const std::vector<int>& numbers) {
  for (Triangle& face : faces)
    for (int& v : face) v = numbers[v];
}

}  // namespace

void joinVertices(const GltfDocument& doc, const GltfShape& shape, const std::vector<Positions*>& poses,
                  Positions& normals, std::vector<Triangle>& faces, Scene& scene) {
  const std::vector<int> numbers = vertexNumbers(doc, shape, vertexAttribute);
  if (numbers.empty()) return;
  const std::vector<int> drawnNumbers = vertexNumbers(doc, shape, drawnAttribute);
  Joining joining{scene, {}, {}, {}, {}, {}, {}};
  joining.numberVertices(numbers, drawnNumbers);
  if (!std::all_of(poses.begin(), poses.end(), [&](const Positions* p) { return joining.standTogether(*p); })) return;
  if (!scene.uvs.empty()) {
    joining.numberDrawn(drawnNumbers);
    if (!joining.copyOf.empty()) {
      scene.seams = {joining.copyOf, faces};
      renumber(scene.seams.faces, joining.drawn);
    }
    take(scene.uvs, joining.source, 2);
  }
  renumber(faces, joining.vertex);
  for (Positions* pose : poses) take(*pose, joining.first);
  take(normals, joining.first);
  take(scene.colors, joining.first, 4);
}

}  // namespace shapespline
