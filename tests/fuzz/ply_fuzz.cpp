// Fuzz target of the PLY importer.
#include "one_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  shapespline::fuzz::oneInput("input.ply", {data, size});
  return 0;
}
