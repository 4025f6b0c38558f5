// Fuzz target of the PC2 importer.
#include "one_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  shapespline::fuzz::oneInput("input.pc2", {data, size});
  return 0;
}
