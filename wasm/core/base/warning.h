// A warning for users.
#pragma once

#include <string>
#include <vector>

namespace shapespline {

struct Warning {
  std::string code;     ///< stable, such as "non-manifold-edges"
  std::string message;  ///< one or two sentences: the problem, its location and a remedy; or what follows `about`
  int count = 0;        ///< number of occurrences, or 0 if not applicable
  int key = -1;         ///< 0-based key of the warning, or the key at the end of its interval; -1 for none
  int face = -1;        ///< an input face at the (worst) location, or -1
  std::vector<int> patches = {};  ///< patches at these locations, as in Sequence::patchOfFace(), for highlighting
  /// The start of the message, before the key's number: "Key", "Before key" or "Beyond key"; "Keys" for `count` keys up
  /// to `key`; "Between" for the interval that the key ends. The engine adds the numbers, because users' may differ.
  std::string about = {};
};

}  // namespace shapespline
