// The built-in samples: each a shape with a few poses.
#pragma once

#include <string>
#include <vector>

#include "core/keyframes.h"
#include "core/options.h"

namespace shapespline {

struct Sample {
  std::string id;           ///< also the file's name
  std::string title;
  std::string description;  ///< one sentence
  BoundaryKind boundary = BoundaryKind::Natural;
  Keyframes keyframes;
};

Sample makeCactus();
Sample makeTwistedBar();

/// All of them, in the order in which they are offered.
std::vector<Sample> makeSamples();

}  // namespace shapespline
