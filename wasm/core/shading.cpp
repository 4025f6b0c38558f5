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
void normalise(float* sums) {
  Float4 x = Float4::load(sums), y = Float4::load(sums + 4), z = Float4::load(sums + 8), w = Float4::load(sums + 12);
  transpose(x, y, z, w);
  const Float4 largest = largerMagnitude(largerMagnitude(x, y), z);
  const int flat = notPositive(largest);
  x = x / largest, y = y / largest, z = z / largest, w = Float4::zero();
  const Float4 length = squareRoot((x * x + y * y) + z * z);
  x = x / length, y = y / length, z = z / length;
  transpose(x, y, z, w);
  x.store(sums), y.store(sums + 4), z.store(sums + 8), w.store(sums + 12);
  for (int i = 0; i < 4; ++i)
    if (flat >> i & 1) sums[4 * i] = sums[4 * i + 1] = 0, sums[4 * i + 2] = 1;
}

}  // namespace

Shading::Shading(const std::vector<Triangle>& faces, const std::vector<int>& groupOfVertex, int groups, const std::vector<int>& rank)
    : vertexAt_(sortedBy(rank)) {
  const std::size_t n = vertexAt_.size();
  std::vector<int> placeOf(n), renumbered(groups, -1), faceRank(faces.size());
  for (std::size_t i = 0; i < n; ++i) placeOf[vertexAt_[i]] = static_cast<int>(i);
  int next = 0;
  for (int v : vertexAt_)
    if (int& g = renumbered[groupOfVertex[v]]; g < 0) g = next++;
  group_.resize(n);
  for (std::size_t v = 0; v < n; ++v) group_[v] = renumbered[groupOfVertex[v]];

  for (std::size_t f = 0; f < faces.size(); ++f)
    faceRank[f] = std::min({placeOf[faces[f][0]], placeOf[faces[f][1]], placeOf[faces[f][2]]});
  const bool seams = groups != static_cast<int>(n);
  for (int f : sortedBy(faceRank)) {
    const auto& [a, b, c] = faces[f];
    corner_.push_back({placeOf[a], placeOf[b], placeOf[c]});
    if (seams) target_.push_back({group_[a], group_[b], group_[c]});
  }
  place_.assign(4 * n, 0.0f);
  sum_.resize(4 * (static_cast<std::size_t>(groups) + 3));  // whole blocks of four
}

void Shading::normals(const std::vector<float>& positions, std::vector<float>& normals) {
  const std::size_t n = vertexAt_.size();
  const auto at = [](auto* p, int i) { return p + 4 * static_cast<std::ptrdiff_t>(i); };
  for (std::size_t i = 0; i < n; ++i) std::copy_n(&positions[3 * static_cast<std::size_t>(vertexAt_[i])], 3, &place_[4 * i]);
  std::fill(sum_.begin(), sum_.end(), 0.0f);
  const std::vector<Triangle>& target = target_.empty() ? corner_ : target_;
  for (std::size_t f = 0; f < corner_.size(); ++f) {
    const Triangle& corner = corner_[f];
    const Float4 normal = areaNormal(Float4::load(at(place_.data(), corner[0])), Float4::load(at(place_.data(), corner[1])),
                                     Float4::load(at(place_.data(), corner[2])));
    for (int g : target[f]) {
      float* sum = at(sum_.data(), g);
      (Float4::load(sum) + normal).store(sum);
    }
  }
  for (std::size_t i = 0; i + 16 <= sum_.size(); i += 16) normalise(&sum_[i]);
  normals.resize(3 * n);
  for (std::size_t v = 0; v < n; ++v) std::copy_n(&sum_[4 * static_cast<std::size_t>(group_[v])], 3, &normals[3 * v]);
}

}  // namespace shapespline
