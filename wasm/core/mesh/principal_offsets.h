// Few fields of offsets whose weighted sums come near many: principal component analysis of a motion's residuals.
#pragma once

#include <span>
#include <vector>

namespace shapespline {

struct PrincipalOffsets {
  int count = 0;               ///< K
  std::vector<float> offsets;  ///< K x 3n, the leading one first; scaled so that the largest weight of each is 1
  std::vector<float> weights;  ///< rows x K
  double largest = 0;          ///< the largest distance of a vertex that is left
};

/// Takes leading components of the rows (3n numbers each, used as scratch) until no vertex is farther than `tolerance`
/// from its row, or until there are `most` of them.
PrincipalOffsets principalOffsets(std::vector<std::vector<float>>& rows, double tolerance, int most);

}  // namespace shapespline
