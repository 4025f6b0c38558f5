#include "core/sparse/ordering.h"

#include "core/sparse/minimum_degree.h"
#include "core/sparse/nested_dissection.h"

namespace shapespline {

std::vector<int> fillReducingOrder(const Graph& graph, std::span<const Vec3> coordinates,
                                   const FractionReport& onProgress) {
  // Nested dissection has no less fill than minimum degree below this size.
  constexpr int large = 40000;
  if (graph.size() < large || coordinates.empty()) return minimumDegreeOrder(graph);
  return nestedDissectionOrder(graph, coordinates, onProgress);
}

}  // namespace shapespline
