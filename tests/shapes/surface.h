// A closed triangle surface under construction.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace shapespline {

struct Surface {
  Positions positions;
  std::vector<Triangle> faces;
};

}  // namespace shapespline
