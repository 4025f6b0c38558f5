// Parses the header of a PLY file: its elements and their properties.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/status.h"
#include "io/polygon/text_reader.h"

namespace shapespline {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };
enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

std::size_t plyTypeBytes(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;
  bool isList = false;
  PlyType countType = PlyType::UInt8;
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::Ascii;
  std::vector<PlyElement> elements;
  bool byBlender = false;  ///< according to a comment
};

/// Reads up to and including end_header. Errors: MalformedFile, TruncatedFile.
Result<PlyHeader> readPlyHeader(LineReader& lines, const std::string& where);

}  // namespace shapespline
