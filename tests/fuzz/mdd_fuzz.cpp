// Fuzz target of the MDD importer.
#include "one_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  shapespline::fuzz::oneInput("input.mdd", {data, size});
  return 0;
}
