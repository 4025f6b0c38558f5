#include "core/mesh/vertex_normals.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "core/base/compressed_rows.h"
#include "core/base/no_inline_call.h"
#include "core/base/simd.h"

namespace shapespline {

namespace {

// Indices 0, 1, ... sorted stably by ascending key.
std::vector<int> sortedBy(const std::vector<int>& key) {
  if (key.empty()) return {};
  return compressedRows<int>(*std::max_element(key.begin(), key.end()) + 1,
                             [&](auto add) {
                               for (std::size_t i = 0; i < key.size(); ++i) add(key[i], static_cast<int>(i));
                             })
      .item;
}

// Face normal scaled to twice the area.
Float4 areaNormal(Float4 a, Float4 b, Float4 c) {
  const Float4 u = b - a, v = c - a;
  return rotatedXyz(u * rotatedXyz(v) - rotatedXyz(u) * v);
}

// Normalises four sums; zero becomes (0, 0, 1). Divides by the largest component first, because squared areas of a
// small mesh exceed the range of float.
void normalise(Float4 (&sum)[4]) {
  Float4 &x = sum[0], &y = sum[1], &z = sum[2], &w = sum[3];
  transpose(x, y, z, w);
  const Float4 largest = larger(larger(magnitude(x), magnitude(y)), magnitude(z));
  const int flat = notPositive(largest);
  x = x / largest;
  y = y / largest;
  z = z / largest;
  w = Float4::zero();
  const Float4 shorten = Float4::splat(1) / squareRoot((x * x + y * y) + z * z);
  x = x * shorten;
  y = y * shorten;
  z = z * shorten;
  transpose(x, y, z, w);
  if (!flat) return;
  constexpr float up[4] = {0, 0, 1, 0};
  for (int i = 0; i < 4; ++i)
    if (flat >> i & 1) sum[i] = Float4::load(up);
}

const float* at(const float* numbers, int i) { return numbers + 4 * static_cast<std::ptrdiff_t>(i); }
float* at(float* numbers, int i) { return numbers + 4 * static_cast<std::ptrdiff_t>(i); }

// Faces as slots in the shape, and the groups that receive their normals.
struct Faces {
  const std::vector<Triangle>& corner;
  const std::vector<Triangle>& target;
};

void addNormals(const Faces& faces, const FaceRange& range, const float* xyzp, float* sums) {
  const Triangle *corner = faces.corner.data(), *target = faces.target.data();
  const auto add = [&](int f) {
    const auto& [a, b, c] = corner[f];
    const Float4 normal = areaNormal(Float4::load(at(xyzp, a)), Float4::load(at(xyzp, b)), Float4::load(at(xyzp, c)));
    for (int group : target[f]) {
      float* sum = at(sums, group);
      (Float4::load(sum) + normal).store(sum);
    }
  };
  // Neighbouring faces share corners, so each would wait for the previous store. Consecutive additions are therefore
  // eight faces apart.
  int f = range.begin;
  for (; f + 32 <= range.end; f += 32)
    for (int i = f; i < f + 8; ++i) add(i), add(i + 8), add(i + 16), add(i + 24);
  for (; f < range.end; ++f) add(f);
}

// Processes groups of four. The last group repeats earlier vertices.
template <class Drawn>
void drawVertices(std::span<const Drawn> drawn, const float* xyzp, const float* move, const float* sums,
                  float* positions, float* normals) {
  const Float4 by = Float4::load(move);
  const std::size_t count = drawn.size(), last = count - std::min<std::size_t>(count, 4);
  for (std::size_t i = 0; i < count; i += 4) {
    const Drawn* d = &drawn[std::min(i, last)];
    Float4 normal[4];
    for (std::size_t k = 0; k < 4; ++k) normal[k] = Float4::load(at(sums, d[std::min(k, count - 1)].group));
    normalise(normal);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto [vertex, slot, group] = d[std::min(k, count - 1)];
      (Float4::load(at(xyzp, slot)) + by).storeXyz(positions + 3 * static_cast<std::size_t>(vertex));
      normal[k].storeXyz(normals + 3 * static_cast<std::size_t>(vertex));
    }
  }
}

}  // namespace

VertexNormals::VertexNormals(const std::vector<Triangle>& faces, const std::vector<int>& groupOf, int groups,
                             const std::vector<int>& slotOf, const FractionReport& onProgress)
    : groups_(groups) {
  std::vector<int> renumbered(groups, -1);
  int next = 0;
  bool seams = false;
  const std::vector<int> drawn = sortedBy(slotOf);
  drawn_.reserve(drawn.size());
  inBlocks(partOf(onProgress, 0.1, 0.3), drawn.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const int v = drawn[i];
      int& group = renumbered[groupOf[v]];
      if (group < 0) group = next++;
      drawn_.push_back({v, slotOf[v], group});
      seams = seams || group != slotOf[v];
    }
  });
  std::vector<Triangle> target(faces.size());
  inBlocks(partOf(onProgress, 0.3, 0.5), faces.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const auto& [a, b, c] = faces[f];
      target[f] = {renumbered[groupOf[a]], renumbered[groupOf[b]], renumbered[groupOf[c]]};
    }
  });
  const FaceOrder ordered = orderFaces(target, groups, -1, partOf(onProgress, 0.5, 0.8));
  ranges_ = ordered.ranges;
  corner_.reserve(ordered.order.size());
  inBlocks(partOf(onProgress, 0.8, 1), ordered.order.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto& [a, b, c] = faces[ordered.order[i]];
      corner_.push_back({slotOf[a], slotOf[b], slotOf[c]});
      if (seams) target_.push_back(target[ordered.order[i]]);
    }
  });
}

void VertexNormals::draw(const std::vector<float>& xyzp, const Vec3& move, Scratch& sums, std::vector<float>& positions,
                         std::vector<float>& normals, ForkJoin* forkJoin) const {
  positions.resize(3 * drawn_.size());
  normals.resize(positions.size());
  sums.assign(4 * static_cast<std::size_t>(groups_), 0.0f);
  const Faces faces = {corner_, target_.empty() ? corner_ : target_};
  const auto add = outOfLine(addNormals);
  inTwo(forkJoin, [&](int half) { add(faces, ranges_[half], xyzp.data(), sums.data()); });
  add(faces, ranges_[2], xyzp.data(), sums.data());
  const auto write = outOfLine(drawVertices<Drawn>);
  const std::array<float, 4> by = {static_cast<float>(move.x()), static_cast<float>(move.y()),
                                   static_cast<float>(move.z()), 0};
  inTwo(forkJoin, [&](int part) {
    const std::span<const Drawn> all = drawn_;
    const std::size_t half = all.size() / 2;
    write(part == 0 ? all.first(half) : all.subspan(half), xyzp.data(), by.data(), sums.data(), positions.data(),
          normals.data());
  });
}

}  // namespace shapespline
