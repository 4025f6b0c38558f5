#include "samples/sample.h"

namespace shapespline {

const std::vector<SampleMaker>& sampleMakers() {
  static const std::vector<SampleMaker> makers{
      {"cactus", makeCactus}, {"dachshund", makeDachshund}, {"stroll", makeStroll},          {"octopus", makeOctopus},
      {"hand", makeHand},     {"gymnast", makeGymnast},     {"twisted-bar", makeTwistedBar},
  };
  return makers;
}

}  // namespace shapespline
