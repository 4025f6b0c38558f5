// Fuzz target of the glTF and GLB importer.
#include "one_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  shapespline::fuzz::oneInput("input.gltf", {data, size});
  return 0;
}
