// What the user should know that is no error.
#pragma once

#include <string>
#include <vector>

namespace shapespline {

struct Warning {
  std::string code;     ///< stable, such as "non-manifold-edges"
  std::string message;  ///< one or two sentences: what, where, what to do
  int count = 0;        ///< how many places, 0 where that has no meaning
  int key = -1;         ///< 0-based key that it is about, or that ends the interval; -1 where it is about none
  int face = -1;        ///< a face of the input at the (worst) place, or -1
  std::vector<int> patches = {};  ///< that hold the places, as in Sequence::patchOfFace(); for the page to colour
};

}  // namespace shapespline
