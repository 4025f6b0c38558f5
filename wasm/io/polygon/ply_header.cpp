#include "io/polygon/ply_header.h"

#include <array>
#include <optional>
#include <utility>

#include "core/base/format.h"
#include "io/base/byte_text.h"

namespace shapespline {

namespace {

std::optional<PlyType> typeOf(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, PlyType>, 16> propertyNames{{
      {"char", PlyType::Int8},
      {"int8", PlyType::Int8},
      {"uchar", PlyType::UInt8},
      {"uint8", PlyType::UInt8},
      {"short", PlyType::Int16},
      {"int16", PlyType::Int16},
      {"ushort", PlyType::UInt16},
      {"uint16", PlyType::UInt16},
      {"int", PlyType::Int32},
      {"int32", PlyType::Int32},
      {"uint", PlyType::UInt32},
      {"uint32", PlyType::UInt32},
      {"float", PlyType::Float32},
      {"float32", PlyType::Float32},
      {"double", PlyType::Float64},
      {"float64", PlyType::Float64},
  }};
  for (const auto& [text, type] : propertyNames)
    if (text == name) return type;
  return std::nullopt;
}

struct HeaderReader {
  LineReader& lines;
  const std::string& where;
  PlyHeader header;

  Error malformed(const std::string& what) const {
    return {ErrorCode::MalformedFile,
            where + ", line " + grouped(lines.lineNumber()) + ": " + what + ". Export the file again."};
  }

  Status readFormat(std::string_view text) {
    const std::string_view name = takeWord(text);
    if (name == "ascii") header.format = PlyFormat::Ascii;
    else if (name == "binary_little_endian") header.format = PlyFormat::LittleEndian;
    else if (name == "binary_big_endian") header.format = PlyFormat::BigEndian;
    else return malformed("the format " + inQuotes(name) + " is unknown");
    return {};
  }

  Status readElement(std::string_view text) {
    PlyElement element;
    element.name = takeWord(text);
    std::string_view count = takeWord(text);
    if (!takeInteger(count, element.count) || !count.empty() || element.count < 0)
      return malformed("the number of " + inQuotes(element.name) + " elements is not a whole number");
    header.elements.push_back(std::move(element));
    return {};
  }

  Status readProperty(std::string_view text) {
    if (header.elements.empty()) return malformed("a property belongs to no element");
    PlyProperty property;
    std::string_view word = takeWord(text);
    property.isList = word == "list";
    if (property.isList) {
      const auto countType = typeOf(takeWord(text));
      if (!countType || *countType == PlyType::Float32 || *countType == PlyType::Float64)
        return malformed("the length of a list has an unknown type");
      property.countType = *countType;
      word = takeWord(text);
    }
    const auto type = typeOf(word);
    if (!type) return malformed("the type " + inQuotes(word) + " is unknown");
    property.type = *type;
    property.name = takeWord(text);
    header.elements.back().properties.push_back(std::move(property));
    return {};
  }

  Result<PlyHeader> read() {
    bool hasFormat = false;
    std::string_view line;
    while (lines.next(line) && takeWord(line).empty()) {  // skips up to "ply", checked before
    }
    while (lines.next(line)) {
      const std::string_view word = takeWord(line);
      Status status;
      if (word == "end_header") {
        if (!hasFormat) return malformed("the header does not state a format");
        return std::move(header);
      }
      if (word == "format") {
        status = readFormat(line);
        hasFormat = true;
      } else if (word == "element") status = readElement(line);
      else if (word == "property") status = readProperty(line);
      else if (word == "comment") header.byBlender |= line.find("Blender") != std::string_view::npos;
      else if (word != "obj_info" && !word.empty())
        status = malformed("the header has the unknown keyword " + inQuotes(word));
      if (!status) return status.error();
    }
    return Error{ErrorCode::TruncatedFile, where + " is cut off in its header. Copy or export it again."};
  }
};

}  // namespace

std::size_t plyTypeBytes(PlyType type) {
  switch (type) {
    case PlyType::Int8:
    case PlyType::UInt8: return 1;
    case PlyType::Int16:
    case PlyType::UInt16: return 2;
    case PlyType::Float64: return 8;
    default: return 4;
  }
}

Result<PlyHeader> readPlyHeader(LineReader& lines, const std::string& where) {
  return HeaderReader{lines, where, {}}.read();
}

}  // namespace shapespline
