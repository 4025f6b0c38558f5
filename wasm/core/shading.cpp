#include "core/shading.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "core/simd.h"

namespace shapespline {

namespace {

// 0, 1, ... sorted by ascending key, equals in their own order.
std::vector<int> sortedBy(const std::vector<int>& key) {
  std::vector<int> order(key.size());
  if (key.empty()) return order;
  std::vector<int> start(static_cast<std::size_t>(*std::max_element(key.begin(), key.end())) + 2, 0);
  for (int k : key) ++start[k + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  for (std::size_t i = 0; i < key.size(); ++i) order[start[key[i]]++] = static_cast<int>(i);
  return order;
}

// Face normal times twice the area.
Float4 areaNormal(Float4 a, Float4 b, Float4 c) {
  const Float4 u = b - a, v = c - a;
  return turnedXyz(u * turnedXyz(v) - turnedXyz(u) * v);
}

// Four sums to unit length. Divided by their largest component first: the squares of a small mesh's areas leave the range
// of float. A sum of zero becomes (0, 0, 1).
void normalise(Float4 (&sum)[4]) {
  Float4 &x = sum[0], &y = sum[1], &z = sum[2], &w = sum[3];
  transpose(x, y, z, w);
  const Float4 largest = largerMagnitude(largerMagnitude(x, y), z);
  const int flat = notPositive(largest);
  x = x / largest, y = y / largest, z = z / largest, w = Float4::zero();
  const Float4 length = squareRoot((x * x + y * y) + z * z);
  x = x / length, y = y / length, z = z / length;
  transpose(x, y, z, w);
  constexpr float up[4] = {0, 0, 1, 0};
  for (int i = 0; i < 4; ++i)
    if (flat >> i & 1) sum[i] = Float4::load(up);
}

}  // namespace

Shading::Shading(const std::vector<Triangle>& faces, const std::vector<int>& groupOf, int groups, const std::vector<int>& placeOf)
    : sum_(4 * static_cast<std::size_t>(groups)) {
  std::vector<int> renumbered(groups, -1), faceKey(faces.size());
  int next = 0;
  bool seams = false;
  for (int v : sortedBy(placeOf)) {
    int& group = renumbered[groupOf[v]];
    if (group < 0) group = next++;
    drawn_.push_back({v, placeOf[v], group});
    seams = seams || group != placeOf[v];
  }
  const auto renumber = [&](int v) { return renumbered[groupOf[v]]; };
  for (std::size_t f = 0; f < faces.size(); ++f)
    faceKey[f] = std::min({placeOf[faces[f][0]], placeOf[faces[f][1]], placeOf[faces[f][2]]});
  for (int f : sortedBy(faceKey)) {
    const auto& [a, b, c] = faces[f];
    corner_.push_back({placeOf[a], placeOf[b], placeOf[c]});
    if (seams) target_.push_back({renumber(a), renumber(b), renumber(c)});
  }
}

void Shading::draw(const std::vector<float>& places, std::vector<float>& positions, std::vector<float>& normals) {
  const auto at = [](auto* p, int i) { return p + 4 * static_cast<std::ptrdiff_t>(i); };
  std::fill(sum_.begin(), sum_.end(), 0.0f);
  const std::vector<Triangle>& target = target_.empty() ? corner_ : target_;
  for (std::size_t f = 0; f < corner_.size(); ++f) {
    const Triangle& corner = corner_[f];
    const Float4 normal = areaNormal(Float4::load(at(places.data(), corner[0])), Float4::load(at(places.data(), corner[1])),
                                     Float4::load(at(places.data(), corner[2])));
    for (int g : target[f]) {
      float* sum = at(sum_.data(), g);
      (Float4::load(sum) + normal).store(sum);
    }
  }
  positions.resize(3 * drawn_.size());
  normals.resize(positions.size());
  for (std::size_t i = 0; i < drawn_.size(); i += 4) {
    const std::size_t count = std::min<std::size_t>(4, drawn_.size() - i);
    Float4 normal[4] = {Float4::zero(), Float4::zero(), Float4::zero(), Float4::zero()};
    for (std::size_t k = 0; k < count; ++k) normal[k] = Float4::load(at(sum_.data(), drawn_[i + k].group));
    normalise(normal);
    for (std::size_t k = 0; k < count; ++k) {
      float xyz[4];
      normal[k].store(xyz);
      const std::size_t to = 3 * static_cast<std::size_t>(drawn_[i + k].vertex);
      std::copy_n(xyz, 3, &normals[to]);
      std::copy_n(at(places.data(), drawn_[i + k].place), 3, &positions[to]);
    }
  }
}

}  // namespace shapespline
