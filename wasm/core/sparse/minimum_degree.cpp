#include "core/sparse/minimum_degree.h"

#include <algorithm>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace shapespline {

std::vector<int> minimumDegreeOrder(const Graph& graph) {
  const int size = graph.size();
  // Eigen requires a diagonal entry in each column. The values do not matter.
  Eigen::SparseMatrix<signed char, Eigen::ColMajor, int> pattern(size, size);
  pattern.resizeNonZeros(static_cast<Eigen::Index>(graph.neighbour.size()) + size);
  int next = 0;
  for (int v = 0; v < size; ++v) {
    pattern.outerIndexPtr()[v] = next;
    pattern.innerIndexPtr()[next++] = v;
    for (int u : graph.neighbours(v)) pattern.innerIndexPtr()[next++] = u;
  }
  pattern.outerIndexPtr()[size] = next;
  std::fill_n(pattern.valuePtr(), next, static_cast<signed char>(1));

  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  if (size > 0) Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Lower>(), permutation);
  return {permutation.indices().data(), permutation.indices().data() + size};
}

}  // namespace shapespline
