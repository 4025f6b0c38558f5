#include "shapes/bench_mesh.h"

#include <algorithm>
#include <string>
#include <utility>

#include "shapes/bench_surface.h"

namespace shapespline {

Keyframes makeBenchKeyframes(int faces, int keys, std::uint32_t seed) {
  Random random(seed);
  faces = std::max(64, faces + faces % 2);
  keys = std::max(2, keys);
  Surface surface = bumpyCapsule(faces, random);
  shuffle(surface, random);

  Keyframes result;
  for (int j = 0; j < keys; ++j) {
    const Deformation d = j > 0 ? randomDeformation(random) : Deformation{};
    Key key{"key " + std::to_string(j + 1), double(j) / (keys - 1), {}};
    key.positions.reserve(surface.positions.size());
    for (const Vec3& p : surface.positions) key.positions.push_back(deformed(d, p));
    result.keys.push_back(std::move(key));
  }
  result.faces = std::move(surface.faces);
  return result;
}

Keyframes subdivided(const Keyframes& keyframes) {
  Keyframes result;
  result.keys = keyframes.keys;
  const std::vector<int> opposite = oppositeHalfEdges(keyframes.faces);
  std::vector<int> middle(opposite.size());
  int count = keyframes.vertexCount();
  for (int h = 0; h < static_cast<int>(opposite.size()); ++h) {
    if (opposite[h] >= 0 && opposite[h] < h) {
      middle[h] = middle[opposite[h]];
      continue;
    }
    const int a = keyframes.faces[h / 3][h % 3], b = keyframes.faces[h / 3][(h + 1) % 3];
    for (Key& key : result.keys) key.positions.push_back(0.5 * (key.positions[a] + key.positions[b]));
    middle[h] = count++;
  }
  result.faces.reserve(4 * keyframes.faces.size());
  for (int f = 0; f < keyframes.faceCount(); ++f) {
    const auto [a, b, c] = keyframes.faces[f];
    const int ab = middle[3 * f], bc = middle[3 * f + 1], ca = middle[3 * f + 2];
    result.faces.insert(result.faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return result;
}

}  // namespace shapespline
