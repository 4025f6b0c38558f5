#include "io/gltf/gltf_seams.h"

#include <algorithm>

#include "io/gltf/gltf_accessor.h"

namespace shapespline {

namespace {

// The vertex of each copy, where the numbers are 0, 1, ... up to the last vertex and then those of copies; else
// nothing.
std::vector<int> copiesIn(const std::vector<double>& numbers) {
  std::size_t n = 0;
  while (n < numbers.size() && numbers[n] == static_cast<double>(n)) ++n;
  std::vector<int> copyOf;
  for (std::size_t i = n; i < numbers.size(); ++i) {
    if (!(numbers[i] >= 0 && numbers[i] < static_cast<double>(n))) return {};
    copyOf.push_back(static_cast<int>(numbers[i]));
  }
  return copyOf;
}

bool standOnTheirVertices(const std::vector<int>& copyOf, const Positions& pose) {
  const std::size_t n = pose.size() - copyOf.size();
  for (std::size_t i = 0; i < copyOf.size(); ++i)
    if (pose[n + i] != pose[copyOf[i]]) return false;
  return true;
}

}  // namespace

void joinSeams(const GltfDocument& doc, const GltfShape& shape, const std::vector<Positions*>& poses,
               Positions& normals, std::vector<Triangle>& faces, Scene& scene) {
  if (shape.parts.size() != 1) return;
  const GltfPart& part = shape.parts[0];
  const auto attribute = part.primitive->attributes.find(std::string(kVertexAttribute));
  if (attribute == part.primitive->attributes.end() || accessorCount(doc, attribute->second) != part.positions.size())
    return;
  const auto numbers = readNumbers(doc, attribute->second, 1, "the vertices of " + part.name);
  if (!numbers) return;
  const std::vector<int> copyOf = copiesIn(*numbers);
  if (copyOf.empty() ||
      !std::all_of(poses.begin(), poses.end(), [&](const Positions* p) { return standOnTheirVertices(copyOf, *p); }))
    return;

  const std::size_t n = part.positions.size() - copyOf.size();
  if (!scene.uvs.empty()) scene.seams = {copyOf, faces};
  for (Triangle& face : faces)
    for (int& v : face) v = v < static_cast<int>(n) ? v : copyOf[v - n];
  for (Positions* pose : poses) pose->resize(n);
  if (!normals.empty()) normals.resize(n);
  if (!scene.colors.empty()) scene.colors.resize(4 * n);
}

}  // namespace shapespline
