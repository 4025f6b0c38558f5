#include "core/reconstruct/poisson.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "core/base/compressed_rows.h"
#include "core/base/sort_indices.h"
#include "core/mesh/triangle.h"
#include "core/sparse/graph.h"
#include "core/sparse/ordering.h"

namespace shapespline {

namespace {

// Operations between two reports: well below a quarter of a second on a slow machine.
constexpr std::int64_t flopsPerChunk = 100'000'000;

}  // namespace

CotangentLaplacian cotangentLaplacian(const std::vector<Triangle>& faces, const std::vector<char>& hasArea,
                                      const Components& components, const Positions& reference,
                                      const FractionReport& onProgress) {
  CotangentLaplacian result;
  result.unknown.assign(reference.size(), -1);
  std::vector<char> pinned(components.count, 0);
  std::vector<char> seen(reference.size(), 0);
  int count = 0;
  inBlocks(partOf(onProgress, 0, 0.1), faces.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      if (!hasArea[f]) continue;
      for (int v : faces[f]) {
        if (seen[v]) continue;
        seen[v] = 1;
        char& isPinned = pinned[components.ofFace[f]];
        if (!isPinned) {
          isPinned = 1;
          continue;
        }
        result.unknown[v] = count++;
        result.coordinates.push_back(reference[v]);
      }
    }
  });

  // Every side of a face contributes to the diagonal and to one entry below it. The latter are sorted by row in each
  // column and summed in face order, so the sums are reproducible.
  std::vector<double> diagonal(count, 0.0);
  const auto eachSide = [&](const FractionReport& report, auto visit) {
    inBlocks(report, faces.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) {
        if (!hasArea[f]) continue;
        for (int c = 0; c < 3; ++c) visit(f, c, faces[f][(c + 1) % 3], faces[f][(c + 2) % 3]);
      }
    });
  };
  struct Entry {
    int row;
    double value;
  };
  RowSorter<Entry> sorter(count);
  eachSide(partOf(onProgress, 0.1, 0.3), [&](std::size_t, int, int i, int j) {
    const int a = result.unknown[i], b = result.unknown[j];
    if (a >= 0 && b >= 0) sorter.count(std::min(a, b));
  });
  sorter.allocate();
  eachSide(partOf(onProgress, 0.3, 0.6), [&](std::size_t f, int c, int i, int j) {
    const double weight = cotangentWeight(reference, faces[f], c);
    const int a = result.unknown[i], b = result.unknown[j];
    if (a >= 0) diagonal[a] += weight;
    if (b >= 0) diagonal[b] += weight;
    if (a >= 0 && b >= 0) sorter.place(std::min(a, b), {std::max(a, b), -weight});
  });
  CompressedRows<Entry> columns = sorter.take();

  const FractionReport onColumns = partOf(onProgress, 0.6, 1);
  SymmetricMatrix& matrix = result.matrix;
  matrix.size = count;
  matrix.row.reserve(columns.item.size() / 2 + 2 * static_cast<std::size_t>(count));
  matrix.value.reserve(matrix.row.capacity());
  std::vector<int> order;
  for (int column = 0; column < count; ++column) {
    reportItem(onColumns, static_cast<std::size_t>(column), static_cast<std::size_t>(count));
    matrix.row.push_back(column);
    matrix.value.push_back(diagonal[column]);
    const std::span<const Entry> entries = columns.of(column);
    order.resize(entries.size());
    std::iota(order.begin(), order.end(), 0);
    sortIndices(order, [&](int a, int b) { return std::pair(entries[a].row, a) < std::pair(entries[b].row, b); });
    for (const int at : order) {
      const Entry& entry = entries[at];
      if (entry.row == matrix.row.back()) {
        matrix.value.back() += entry.value;
        continue;
      }
      matrix.row.push_back(entry.row);
      matrix.value.push_back(entry.value);
    }
    matrix.columnStart.push_back(static_cast<int>(matrix.row.size()));
  }
  return result;
}

std::vector<int> eliminationOrder(const CotangentLaplacian& laplacian) {
  return fillReducingOrder(graphOf(laplacian.matrix), laplacian.coordinates);
}

Result<PoissonSystem> PoissonSystem::create(const CotangentLaplacian& laplacian, Precision precision, OrderSource order,
                                            const FractionReport& ordering, const FractionReport& factorising) {
  PoissonSystem system;
  Stopwatch watch;
  const Precision stored = precision == Precision::Double ? Precision::Double : Precision::Single;
  const std::vector<int> given = order ? order(laplacian.matrix.size) : std::vector<int>();
  if (Status status = system.solver_.analyse(laplacian.matrix, laplacian.coordinates, stored, ordering, given); !status)
    return status.error();
  reportFraction(ordering, 1);
  system.times_.order = watch.lap();
  if (Status status = system.factorise(laplacian, factorising); !status) return status.error();
  if (precision == Precision::Exact) system.refinement_.emplace(laplacian.matrix, system.solver_);
  system.times_.factor = watch.lap();
  return system;
}

Status PoissonSystem::factorise(const CotangentLaplacian& laplacian, const FractionReport& onProgress) {
  if (Status status = solver_.beginFactorise(laplacian.matrix); !status) return status;
  reportFraction(onProgress, 0);
  while (solver_.factoriseSome(flopsPerChunk)) reportFraction(onProgress, solver_.factoriseProgress());
  if (Status status = solver_.factoriseStatus(); !status) return status;
  const auto position = solver_.eliminationPosition();
  slot_.resize(laplacian.unknown.size());
  inBlocks({}, slot_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      slot_[v] = laplacian.unknown[v] >= 0 ? position[laplacian.unknown[v]] : trashSlot();
  });
  return {};
}

}  // namespace shapespline
