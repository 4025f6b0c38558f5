// Approximates many offset fields by weighted sums of a few: principal component analysis of a motion's residuals.
#pragma once

#include <span>
#include <vector>

namespace shapespline {

struct PrincipalOffsets {
  int count = 0;               ///< K
  std::vector<float> offsets;  ///< K x 3n, leading component first; scaled so that each has largest weight 1
  std::vector<float> weights;  ///< rows x K
  double largest = 0;          ///< largest remaining distance of a vertex
};

/// Extracts leading components of the rows (3n numbers each, used as scratch) until every vertex is within `tolerance`
/// of its row, or until there are `most` components.
PrincipalOffsets principalOffsets(std::vector<std::vector<float>>& rows, double tolerance, int most);

}  // namespace shapespline
