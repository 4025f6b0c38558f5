#include "shells/deformation_transfer.h"

#include <utility>

#include "core/base/union_find.h"
#include "core/mesh/triangle.h"
#include "core/sparse/spring_matrix.h"

namespace shapespline {

namespace {

// Side c of a face runs from corner c to the next corner. The third corner is opposite.
int endOf(int side) { return (side + 1) % 3; }
int oppositeOf(int side) { return (side + 2) % 3; }

Mat3 frameOf(const Triangle& f, const Positions& p) {
  const Vec3 a = p[f[1]] - p[f[0]], b = p[f[2]] - p[f[0]];
  Mat3 frame;
  frame << a, b, a.cross(b).normalized();
  return frame;
}

}  // namespace

Result<DeformationTransfer> DeformationTransfer::create(const std::vector<Triangle>& faces,
                                                        const std::vector<Positions>& keys, Leader leader,
                                                        const FractionReport& onProgress) {
  std::vector<const Positions*> poses;
  for (const Positions& key : keys) poses.push_back(&key);
  DeformationTransfer transfer(weld(poses, weldTolerances(poses)), faces, std::move(leader));
  const Positions reference = weldPositions(keys.front(), transfer.welding_);
  const int vertices = static_cast<int>(reference.size());
  UnionFind sets(vertices);
  std::vector<char> used(vertices);
  SpringMatrix matrix(vertices);
  for (const Triangle& f : transfer.faces_) {
    std::array<double, 3> cotangents{};
    if (!isDegenerate(reference[f[0]], reference[f[1]], reference[f[2]]))
      for (int c = 0; c < 3; ++c) {
        const int i = f[c], j = f[endOf(c)];
        cotangents[c] = cotangentWeight(reference, f, oppositeOf(c));
        matrix.add(i, j, cotangents[c]);
        sets.join(i, j);
        used[i] = used[j] = 1;
      }
    transfer.cotangent_.push_back(cotangents);
  }
  std::vector<double> unused(vertices, 0.0);
  for (int v = 0; v < vertices; ++v) {
    transfer.componentOf_.push_back(used[v] ? sets.find(v) : -1);
    if (!used[v]) unused[v] = 1;
  }
  const SymmetricMatrix assembled = std::move(matrix).plus(unused);
  if (Status status = transfer.solver_.analyse(assembled, reference, Precision::Double, onProgress); !status)
    return status.error();
  if (Status status = transfer.solver_.factorise(assembled); !status) return status.error();
  return transfer;
}

std::vector<Mat3> DeformationTransfer::deformations(const Positions& from, const Positions& to) const {
  std::vector<Mat3> result;
  for (const Triangle& f : leader_.faces) {
    const Mat3 deformation = frameOf(f, to) * frameOf(f, from).inverse();
    result.push_back(deformation.allFinite() ? deformation : Mat3::Identity());
  }
  return result;
}

Positions DeformationTransfer::follow(const Positions& raw, const Positions& from, const Positions& to) const {
  const Positions shape = weldPositions(raw, welding_);
  const std::vector<Mat3> deformation = deformations(from, to);
  const std::span<const int> position = solver_.eliminationPosition();
  std::vector<double, Eigen::aligned_allocator<double>> work(4 * static_cast<std::size_t>(solver_.paddedSize()), 0);
  const auto at = [&](int v) { return Eigen::Map<Vec3>(&work[4 * static_cast<std::size_t>(position[v])]); };
  for (std::size_t f = 0; f < faces_.size(); ++f)
    for (int c = 0; c < 3; ++c) {
      const int i = faces_[f][c], j = faces_[f][endOf(c)], leading = leader_.faceOf[f];
      const Vec3 side = cotangent_[f][c] * (shape[i] - shape[j]);
      const Vec3 wanted = leading < 0 ? side : deformation[leading] * side;
      at(i) += wanted;
      at(j) -= wanted;
    }
  solver_.solve(work.data());
  Positions solution;
  for (int v = 0; v < static_cast<int>(shape.size()); ++v) solution.push_back(componentOf_[v] < 0 ? shape[v] : at(v));
  place(solution, shape, from, to);
  Positions result;
  for (const int w : welding_.weldedOfRaw) result.push_back(solution[w]);
  return result;
}

// The system does not determine the translation of a component.
void DeformationTransfer::place(Positions& solution, const Positions& shape, const Positions& from,
                                const Positions& to) const {
  struct Sum {
    Vec3 offset = Vec3::Zero(), moved = Vec3::Zero();
    int count = 0, led = 0;
  };
  std::vector<Sum> sums(shape.size());
  for (std::size_t v = 0; v < shape.size(); ++v) {
    if (componentOf_[v] < 0) continue;
    Sum& sum = sums[componentOf_[v]];
    sum.offset += shape[v] - solution[v];
    ++sum.count;
    if (const int leading = leader_.vertexOf[welding_.rawOfWelded[v]]; leading >= 0) {
      sum.moved += to[leading] - from[leading];
      ++sum.led;
    }
  }
  for (std::size_t v = 0; v < shape.size(); ++v) {
    if (componentOf_[v] < 0) continue;
    const Sum& sum = sums[componentOf_[v]];
    solution[v] += sum.offset / sum.count;
    if (sum.led > 0) solution[v] += sum.moved / sum.led;
  }
}

}  // namespace shapespline
