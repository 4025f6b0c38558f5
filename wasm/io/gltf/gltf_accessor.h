// Reads numbers from glTF accessors. Every byte range is checked before it is read.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/status.h"
#include "io/gltf/gltf_document.h"

namespace shapespline {

/// Number of elements of accessor `index`, or 0 if it does not exist.
std::size_t accessorCount(const GltfDocument& doc, int index);

/// Reads the first `most` elements of the accessor, `components` numbers per element. Normalised integers are mapped to
/// [-1, 1] or [0, 1], and sparse substitutions are applied. `what`: name of the accessor in messages ("POSITION of mesh
/// 0").
/// Errors: MalformedFile, TooLarge.
Result<std::vector<double>> readNumbers(const GltfDocument& doc, int index, int components, const std::string& what,
                                        std::size_t most = ~std::size_t{0}, const FractionReport& onProgress = {});

/// Reads an accessor of an unsigned integer type, `components` numbers per element.
Result<std::vector<std::uint32_t>> readWholeNumbers(const GltfDocument& doc, int index, int components,
                                                    const std::string& what, const FractionReport& onProgress = {});

}  // namespace shapespline
