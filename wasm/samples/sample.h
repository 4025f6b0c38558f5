// The built-in samples: each a shape with a few poses.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/sequence/keyframes.h"
#include "core/sequence/options.h"

namespace shapespline {

struct Sample {
  std::string id;  ///< also the file's name
  std::string title;
  std::string description;  ///< one sentence
  BoundaryKind boundary = BoundaryKind::Natural;
  Keyframes keyframes;
  std::uint32_t colour = 0xc9b5a4;  ///< of its surface: red, green and blue in sRGB
  bool hold = false;                ///< what rests
};

Sample makeCactus();
Sample makeTwistedBar();
Sample makeDachshund();
Sample makeStroll();
Sample makeOctopus();
Sample makeHand();
Sample makeGymnast();

struct SampleMaker {
  const char* id;
  Sample (*make)();
};

/// All of them, in the order in which they are offered. Each takes a second or two.
const std::vector<SampleMaker>& sampleMakers();

}  // namespace shapespline
