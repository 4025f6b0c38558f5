// A sample as the bytes that the app fetches.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/status.h"
#include "samples/sample.h"

namespace shapespline {

/// One GLB with the first key as its mesh, a morph target for every other key and a LINEAR weight animation whose key
/// times are the keys' times. Positions are float32; there are no normals, which every reader can compute.
Result<std::vector<std::uint8_t>> sampleGlb(const Sample& sample);

/// samples.json: an array of {"id", "title", "description", "files", "times", "boundary", "hold", "credit"}, in
/// the order offered; files are named relative to it.
std::string sampleList(const std::vector<Sample>& samples);

/// The name of a sample's file.
std::string sampleFileName(const Sample& sample);

}  // namespace shapespline
