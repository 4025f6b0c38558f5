#include "core/reconstruct/preview_embedding.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

#include "core/base/permutation.h"
#include "core/base/precision.h"
#include "core/base/simd.h"
#include "core/base/sort_indices.h"
#include "core/base/union_find.h"
#include "core/reconstruct/stretch_limits.h"

namespace shapespline {

namespace {

// Cells have at most so many vertices, unless there would be more than mostCells of them.
constexpr int cellSize = 12, mostCells = 8192;

// Halfway from one rotation to the other. Seen from there the way between two points of a bending body keeps its
// direction.
Quaternion midway(const Quaternion& a, const Quaternion& b) {
  const double sign = a.dot(b) < 0 ? -1 : 1;
  const Eigen::Vector4d sum = a.coeffs() + sign * b.coeffs();
  return Quaternion(sum).normalized();
}

// Cells that turn far against each other say little about where they lie.
double linkWeight(double angle) { return 1e-5 + std::pow((1 + std::cos(std::min(angle, std::numbers::pi))) / 2, 6); }
// Beyond the keys lengths ease towards limits, as a face's stretch does (face_kernel): logarithms towards both,
double blendLogLength(const std::vector<double>& keys, const PoseWeights& weights) {
  double sum = 0;
  for (std::size_t c = 0; c < keys.size(); ++c)
    if (weights.column[c] != 0) sum += weights.column[c] * keys[c];
  if (weights.beyond < 0) return sum;
  const double end = keys[weights.beyond], change = sum - end;
  const auto [low, high] = std::minmax_element(keys.begin(), keys.begin() + weights.keys);
  const double room = std::log(stretchMargin) + (change > 0 ? *high - end : end - *low);
  return end + easing(std::abs(change) / room) * change;
}

// and ways towards the least length, by what they lose along the end key's own.
Vec3 blendWay(const std::vector<Vec3>& keys, const PoseWeights& weights) {
  const Vec3 sum = blend(keys, weights);
  if (weights.beyond < 0) return sum;
  const Vec3& end = keys[weights.beyond];
  const Vec3 change = sum - end;
  const double length = end.norm();
  double least = length;
  for (int c = 0; c < weights.keys; ++c) least = std::min(least, keys[c].norm());
  const double lost = -change.dot(end), room = length * (length - least / stretchMargin);
  return room > 0 && lost > 0 ? Vec3(end + easing(lost / room) * change) : sum;
}

}  // namespace

// Made from what the keys say of each cell, which the embedding then does without.
class PreviewEmbedding::Builder {
 public:
  explicit Builder(const Input& input)
      : in_(input), keyRotation_(input.shape.columns()), keyCentre_(input.shape.columns()) {
    assert(isPermutation(input.placeOf));
    out_.columns_ = input.shape.columns();
    out_.vertexCount_ = input.shape.vertexCount();
  }

  Result<PreviewEmbedding> build() {
    makeCells();
    encodeVertices();
    const std::vector<int> cellOf = cellOfVertices();
    const SymmetricMatrix laplacian = makeLinks(cellOf);
    makeAttachments(cellOf);
    for (int v : vertex_) out_.place_.push_back(v < 0 ? -1 : in_.placeOf[v]);
    if (Status status = out_.laplacian_.analyse(laplacian, {}, Precision::Double); !status) return status.error();
    if (Status status = out_.laplacian_.factorise(laplacian); !status) return status.error();
    return std::move(out_);
  }

 private:
  void makeCells() {
    const int limit = std::max(cellSize, out_.vertexCount_ / mostCells);
    std::vector<char> isLoose(out_.vertexCount_, 0);
    for (int v : in_.loose) isLoose[v] = 1;
    // What belongs together: same frame and component, or same anchor.
    const auto key = [&](int v) {
      const int f = in_.faceOfVertex[v];
      return std::tuple(isLoose[v] ? f : -1, in_.frameOf[f], in_.componentOf[f]);
    };
    std::vector<int> vertices(out_.vertexCount_);
    std::iota(vertices.begin(), vertices.end(), 0);
    sortIndices(vertices, [&](int a, int b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
    for (std::size_t begin = 0, end; begin < vertices.size(); begin = end) {
      for (end = begin + 1; end < vertices.size() && key(vertices[end]) == key(vertices[begin]); ++end) {
      }
      const std::span<int> group(vertices.data() + begin, end - begin);
      if (isLoose[group[0]]) addCell(group, in_.faceOfVertex[group[0]]);
      else divide(group, limit);
    }
  }

  // Halves across the longest axis of the reference pose.
  void divide(std::span<int> vertices, int limit) {
    if (static_cast<int>(vertices.size()) <= limit) return addCell(vertices, -1);
    const Positions& p = in_.shape.poses[in_.shape.reference];
    Vec3 low = p[vertices[0]], high = low;
    for (int v : vertices) low = low.cwiseMin(p[v]), high = high.cwiseMax(p[v]);
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const std::size_t half = vertices.size() / 2;
    std::nth_element(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(half), vertices.end(),
                     [&](int a, int b) { return std::pair(p[a][axis], a) < std::pair(p[b][axis], b); });
    divide(vertices.first(half), limit);
    divide(vertices.subspan(half), limit);
  }

  // A cell's centre is the mean of its vertices: the mean of all vertices then depends on the centres alone.
  void addCell(std::span<int> vertices, int anchor) {
    sortIndices(vertices, [&](int a, int b) { return in_.placeOf[a] < in_.placeOf[b]; });
    const int face = in_.faceOfVertex[vertices[0]], begin = static_cast<int>(vertex_.size());
    Cell cell{
        in_.frameOf[face], anchor < 0 ? in_.componentOf[face] : -1, begin, 0, static_cast<int>(vertices.size()), {}};
    anchorOf_.push_back(anchor);
    vertex_.insert(vertex_.end(), vertices.begin(), vertices.end());
    while (vertex_.size() % 4 != 0) vertex_.push_back(-1);
    cell.end = static_cast<int>(vertex_.size());
    for (int c = 0; c < out_.columns_; ++c) {
      Vec3 turn = Vec3::Zero(), centre = Vec3::Zero();
      for (int v : vertices) turn += in_.turn(in_.faceOfVertex[v], c), centre += in_.shape.poses[c][v];
      cell.turn.push_back(turn / cell.size);
      keyCentre_[c].push_back(centre / cell.size);
      keyRotation_[c].push_back(in_.frames[c][cell.frame] * expQuaternion(cell.turn.back()));
    }
    out_.cells_.push_back(std::move(cell));
  }

  void encodeVertices() {
    const std::size_t blockSize = 12 * static_cast<std::size_t>(out_.columns_);
    out_.numbers_.assign(vertex_.size() / 4 * blockSize, 0.0f);
    out_.mean_.assign(out_.columns_, Vec3::Zero());
    for (int c = 0; c < out_.columns_; ++c)
      for (std::size_t k = 0; k < out_.cells_.size(); ++k) {
        const Cell& cell = out_.cells_[k];
        out_.mean_[c] += cell.size * keyCentre_[c][k] / out_.vertexCount_;
        const Mat3 toCell = keyRotation_[c][k].conjugate().toRotationMatrix();
        for (int i = cell.begin; i < cell.begin + cell.size; ++i) {
          const Vec3 r = toCell * (in_.shape.poses[c][vertex_[i]] - keyCentre_[c][k]);
          float* number =
              &out_.numbers_[static_cast<std::size_t>(i) / 4 * blockSize + 12 * static_cast<std::size_t>(c) + i % 4];
          for (int j = 0; j < 3; ++j) number[4 * j] = static_cast<float>(r[j]);
        }
      }
  }

  std::vector<int> cellOfVertices() const {
    std::vector<int> cellOf(out_.vertexCount_);
    for (std::size_t k = 0; k < out_.cells_.size(); ++k) {
      const Cell& cell = out_.cells_[k];
      for (int i = cell.begin; i < cell.begin + cell.size; ++i) cellOf[vertex_[i]] = static_cast<int>(k);
    }
    return cellOf;
  }

  // Pairs of cells that an edge joins, ascending.
  std::vector<std::pair<int, int>> neighbours(const std::vector<int>& cellOf) const {
    std::vector<std::pair<int, int>> pairs;
    for (int f = 0; f < in_.shape.faceCount(); ++f) {
      if (in_.frameOf[f] < 0) continue;
      const Triangle& t = in_.shape.faces[f];
      for (int i = 0; i < 3; ++i) {
        const int a = cellOf[t[i]], b = cellOf[t[(i + 1) % 3]];
        if (a != b) pairs.emplace_back(std::min(a, b), std::max(a, b));
      }
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  // Returns the Laplacian of the graph of cells, the first cell of each component pinned to zero.
  SymmetricMatrix makeLinks(const std::vector<int>& cellOf) {
    const int count = static_cast<int>(out_.cells_.size());
    std::vector<Triplet> entries;
    UnionFind joined(count);
    for (const auto& [a, b] : neighbours(cellOf)) {
      double angle = 0;
      for (int c = 0; c < out_.columns_; ++c)
        angle = std::max(angle, keyRotation_[c][a].angularDistance(keyRotation_[c][b]));
      const double weight = linkWeight(angle);
      out_.links_.push_back(link(a, b, weight));
      entries.insert(entries.end(), {{a, a, weight}, {b, b, weight}, {b, a, -weight}});
      joined.join(a, b);
    }
    for (int k = 0; k < count; ++k)
      if (joined.find(k) == k) entries.push_back({k, k, 1.0});
    return assembleSymmetric(count, entries);
  }

  Link link(int from, int to, double weight) const {
    Link result{from, to, weight, {}, {}};
    for (int c = 0; c < out_.columns_; ++c) {
      Vec3 offset =
          midway(keyRotation_[c][from], keyRotation_[c][to]).conjugate() * (keyCentre_[c][to] - keyCentre_[c][from]);
      const double length = offset.norm();
      if (in_.logarithmic) {
        result.logLength.push_back(std::log(std::max(length, 1e-300)));
        offset /= std::max(length, 1e-300);
      }
      result.offset.push_back(offset);
    }
    return result;
  }

  void makeAttachments(const std::vector<int>& cellOf) {
    const auto cellAt = [&](int face) { return cellOf[in_.shape.faces[face][0]]; };
    for (const auto& [anchor, contact, pivot] : in_.anchors)
      out_.attachments_.push_back(attachment(anchor, cellAt(anchor), cellAt(contact), pivot));
    for (std::size_t k = 0; k < anchorOf_.size(); ++k)
      if (const int anchor = anchorOf_[k]; anchor >= 0)
        out_.attachments_.push_back(attachment(anchor, cellAt(anchor), static_cast<int>(k), {}));
  }

  // pivot: none for the cell's own centre.
  Attachment attachment(int face, int from, int to, const std::vector<Vec3>& pivot) const {
    Attachment result{from, to, in_.frameOf[face], {}, {}, {}};
    for (int c = 0; c < out_.columns_; ++c) {
      result.turn.push_back(in_.turn(face, c));
      const Quaternion rotation = in_.frames[c][result.frame] * expQuaternion(result.turn.back());
      const Vec3& point = pivot.empty() ? keyCentre_[c][to] : pivot[c];
      result.offset.push_back(rotation.conjugate() * (point - keyCentre_[c][from]));
      result.reach.push_back(keyRotation_[c][to].conjugate() * (point - keyCentre_[c][to]));
    }
    return result;
  }

  const Input& in_;
  PreviewEmbedding out_;
  std::vector<int> vertex_;    // at each of place_
  std::vector<int> anchorOf_;  // face of each cell, or -1
  // Of each column, rotation and centre of each cell.
  std::vector<std::vector<Quaternion>> keyRotation_;
  std::vector<std::vector<Vec3>> keyCentre_;
};

Result<PreviewEmbedding> PreviewEmbedding::create(const Input& input) { return Builder(input).build(); }

Vec3 PreviewEmbedding::way(const Link& link, const Quaternion& middle, const PoseWeights& weights) {
  if (link.logLength.empty()) return middle * blendWay(link.offset, weights);
  const Vec3 direction = blend(link.offset, weights);
  const double length = direction.norm();
  return middle *
         (length > 0 ? Vec3(direction * (std::exp(blendLogLength(link.logLength, weights)) / length)) : direction);
}

// The cells' centres: neighbours as the keys have them, components and anchored vertices where their anchors have them.
void PreviewEmbedding::settle(const PoseWeights& weights, const std::vector<Quaternion>& frames,
                              Scratch& scratch) const {
  auto& [rotation, centre, solution] = scratch;
  const auto position = laplacian_.eliminationPosition();
  const auto at = [&](int cell) { return Eigen::Map<Vec3>(&solution[4 * static_cast<std::size_t>(position[cell])]); };
  solution.assign(4 * static_cast<std::size_t>(laplacian_.paddedSize()), 0.0);
  centre.resize(cells_.size());
  for (const Link& l : links_) {
    const Vec3 pull = l.weight * way(l, midway(rotation[l.from], rotation[l.to]), weights);
    at(l.to) += pull;
    at(l.from) -= pull;
  }
  laplacian_.solve(solution.data());
  for (std::size_t k = 0; k < cells_.size(); ++k) centre[k] = at(static_cast<int>(k));
  for (const Attachment& h : attachments_) {
    const Quaternion anchor = frames[h.frame] * expQuaternion(blend(h.turn, weights));
    const Vec3 shift =
        centre[h.from] + anchor * blend(h.offset, weights) - centre[h.to] - rotation[h.to] * blend(h.reach, weights);
    const int component = cells_[h.to].component;
    if (component < 0) centre[h.to] += shift;
    for (std::size_t k = 0; k < cells_.size() && component >= 0; ++k)
      if (cells_[k].component == component) centre[k] += shift;
  }
  Vec3 mean = Vec3::Zero();
  for (std::size_t k = 0; k < cells_.size(); ++k) mean += cells_[k].size * centre[k] / vertexCount_;
  const Vec3 move = blend(mean_, weights) - mean;
  for (Vec3& p : centre) p += move;
}

void PreviewEmbedding::at(const PoseWeights& weights, const std::vector<Quaternion>& frames, Scratch& scratch,
                          std::vector<float>& places) const {
  auto& rotation = scratch.rotation;
  rotation.resize(cells_.size());
  for (std::size_t k = 0; k < cells_.size(); ++k)
    rotation[k] = frames[cells_[k].frame] * expQuaternion(blend(cells_[k].turn, weights));
  settle(weights, frames, scratch);
  places.resize(4 * static_cast<std::size_t>(vertexCount_));
  const float* number = numbers_.data();
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    const Eigen::Matrix3f g = rotation[k].toRotationMatrix().cast<float>();
    const Eigen::Vector3f centre = scratch.centre[k].cast<float>();
    for (int i = cells_[k].begin; i < cells_[k].end; i += 4) {
      Float4 r[3] = {Float4::zero(), Float4::zero(), Float4::zero()};
      for (int c = 0; c < columns_; ++c, number += 12) {
        if (std::abs(weights.column[c]) < leastWeight<float>) continue;
        const Float4 w = Float4::splat(static_cast<float>(weights.column[c]));
        for (int j = 0; j < 3; ++j) r[j] = r[j] + w * Float4::load(number + 4 * j);
      }
      Float4 p[4];
      for (int j = 0; j < 3; ++j)
        p[j] = Float4::splat(centre[j]) +
               (Float4::splat(g(j, 0)) * r[0] + Float4::splat(g(j, 1)) * r[1] + Float4::splat(g(j, 2)) * r[2]);
      p[3] = Float4::zero();
      transpose(p[0], p[1], p[2], p[3]);
      for (int j = 0; j < 4 && place_[i + j] >= 0; ++j)
        p[j].store(&places[4 * static_cast<std::size_t>(place_[i + j])]);
    }
  }
}

}  // namespace shapespline
