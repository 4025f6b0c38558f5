// Fuzz target of the OBJ importer.
#include "one_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  shapespline::fuzz::oneInput("input.obj", {data, size});
  return 0;
}
