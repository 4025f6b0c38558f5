#include "core/poisson.h"

namespace shapespline {

namespace {

// Operations between two reports: well under a quarter of a second on a slow machine.
constexpr std::int64_t flopsPerChunk = 100'000'000;

}  // namespace

CotangentLaplacian cotangentLaplacian(const std::vector<Triangle>& faces, const std::vector<char>& hasArea,
                                      const Pieces& pieces, const Positions& reference) {
  CotangentLaplacian result;
  result.unknown.assign(reference.size(), -1);
  std::vector<char> tied(pieces.count, 0);
  std::vector<char> seen(reference.size(), 0);
  int count = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!hasArea[f]) continue;
    for (int v : faces[f]) {
      if (seen[v]) continue;
      seen[v] = 1;
      char& isTied = tied[pieces.ofFace[f]];
      if (!isTied) {
        isTied = 1;
        continue;
      }
      result.unknown[v] = count++;
      result.coordinates.push_back(reference[v]);
    }
  }

  std::vector<Triplet> entries;
  entries.reserve(faces.size() * 9);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!hasArea[f]) continue;
    for (int c = 0; c < 3; ++c) {
      const int i = faces[f][(c + 1) % 3], j = faces[f][(c + 2) % 3];
      const Vec3 u = reference[i] - reference[faces[f][c]], v = reference[j] - reference[faces[f][c]];
      const double weight = u.dot(v) / u.cross(v).norm() / 2;  // half the cotangent of the angle opposite edge ij
      const int a = result.unknown[i], b = result.unknown[j];
      if (a >= 0) entries.push_back({a, a, weight});
      if (b >= 0) entries.push_back({b, b, weight});
      if (a >= 0 && b >= 0) entries.push_back({std::max(a, b), std::min(a, b), -weight});
    }
  }
  result.matrix = assembleSymmetric(count, entries);
  return result;
}

Status PoissonSystem::build(const CotangentLaplacian& laplacian, Precision precision,
                            const std::function<void(double)>& onOrder, const std::function<void(double)>& onFactor) {
  onOrder(0);
  constexpr double ordering = 0.9;  // of the analysis; the rest is the factor's structure
  if (Status status = solver_.analyse(laplacian.matrix, laplacian.coordinates, precision,
                                      [&](double fraction) { onOrder(ordering * fraction); });
      !status)
    return status;
  onOrder(1);
  if (Status status = solver_.beginFactorise(laplacian.matrix); !status) return status;
  while (solver_.factoriseSome(flopsPerChunk)) onFactor(solver_.factoriseProgress());
  if (Status status = solver_.factoriseStatus(); !status) return status;
  onFactor(1);
  const auto position = solver_.eliminationPosition();
  slot_.resize(laplacian.unknown.size());
  for (std::size_t v = 0; v < slot_.size(); ++v)
    slot_[v] = laplacian.unknown[v] >= 0 ? position[laplacian.unknown[v]] : dump();
  return {};
}

}  // namespace shapespline
