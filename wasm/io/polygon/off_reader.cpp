// Object File Format (Geomview).
#include <algorithm>
#include <limits>

#include "core/base/format.h"
#include "io/base/limits.h"
#include "io/polygon/polygon_readers.h"
#include "io/polygon/text_reader.h"
#include "io/polygon/vertex_colors.h"

namespace shapespline {

namespace {

struct OffReader {
  LineReader lines;
  std::size_t size;
  const std::string& where;
  const FractionReport& onProgress;
  PolygonMesh mesh;
  bool hasNormals = false, hasCoordinates = false, hasFaceColors = false;
  int leftOut = 0;
  std::vector<float> colors{};  // as in the file, 4 per vertex

  Error malformed(const std::string& what) const {
    return {ErrorCode::MalformedFile,
            where + ", line " + grouped(lines.lineNumber()) + ": " + what + ". Export the file again."};
  }

  // The next line that is neither empty nor a comment.
  bool nextLine(std::string_view& line) {
    while (lines.next(line)) {
      const std::size_t end = std::min(line.find('#'), line.size());
      mesh.writtenZUp |= line.substr(end).find("Blender") != std::string_view::npos;
      line = line.substr(0, end);
      std::string_view rest = line;
      if (!takeWord(rest).empty()) return true;
    }
    return false;
  }

  Error cutOff(const std::string& what, std::int64_t declared, std::size_t have) const {
    return {ErrorCode::TruncatedFile, where + " is cut off: it declares " + grouped(declared) + " " + what +
                                          " but has only " + grouped(static_cast<std::int64_t>(have)) +
                                          ". Copy or export it again."};
  }

  // Reads the keyword and the counts, which follow on the same line or the next.
  Status readHeader(std::int64_t& vertices, std::int64_t& faces) {
    std::string_view line;
    if (!nextLine(line)) return malformed("the header is missing");
    std::string_view keyword = takeWord(line);
    if (!keyword.ends_with("OFF")) return malformed("the header is missing");
    if (keyword.find('4') != std::string_view::npos || keyword.find('n') != std::string_view::npos)
      return Error{ErrorCode::Unsupported,
                   where + " has points with more than three dimensions, which are not supported. Export it in 3D."};
    const std::string_view kinds = keyword.substr(0, keyword.size() - 3);
    hasNormals = kinds.find('N') != std::string_view::npos;
    hasCoordinates = kinds.starts_with("ST");
    std::string_view rest = line;
    if (takeWord(rest) == "BINARY")
      return Error{ErrorCode::Unsupported,
                   where + " is a binary OFF file, which is not supported. Export it as text or as PLY."};
    rest = line;
    if (takeWord(rest).empty() && !nextLine(line)) return malformed("the numbers of vertices and faces are missing");
    double count[2];
    if (!takeNumber(line, count[0]) || !takeNumber(line, count[1]) || !(count[0] >= 0) || !(count[1] >= 0))
      return malformed("the numbers of vertices and faces are missing");
    if (count[0] > maxElements || count[1] > 2 * maxElements)
      return Error{ErrorCode::TooLarge, where + " declares " + shortNumber(count[0]) + " vertices and " +
                                            shortNumber(count[1]) +
                                            " faces, more than is supported. Simplify the mesh first."};
    vertices = static_cast<std::int64_t>(count[0]);
    faces = static_cast<std::int64_t>(count[1]);
    return {};
  }

  Status readVertex(std::string_view line) {
    double value[6];
    const int wanted = hasNormals ? 6 : 3;
    for (int c = 0; c < wanted; ++c)
      if (!takeNumber(line, value[c]))
        return hasDecimalComma(line) ? decimalComma(where + ", line " + grouped(lines.lineNumber()))
                                     : malformed("a vertex needs " + std::to_string(wanted) + " numbers");
    mesh.positions.emplace_back(value);
    if (hasNormals) mesh.normals.push_back(Vec3(value + 3).normalized());
    readColor(line);
    return {};
  }

  // Reads 3 or 4 numbers. Some programs write them without the keyword COFF.
  void readColor(std::string_view line) {
    double value[6];
    int count = 0;
    while (count < 6 && takeNumber(line, value[count])) ++count;
    if (hasCoordinates) count -= 2;  // at the end of the line
    if (count < 3) return;
    colors.resize(4 * mesh.positions.size(), std::numeric_limits<float>::quiet_NaN());
    for (int c = 0; c < std::min(count, 4); ++c) colors[colors.size() - 4 + c] = static_cast<float>(value[c]);
  }

  Status readFace(std::string_view line) {
    double number;
    if (!takeNumber(line, number) || !(number >= 0) || number > static_cast<double>(line.size()))
      return malformed("a face has no number of corners");
    const int corners = static_cast<int>(number);
    const std::size_t start = mesh.corners.size();
    for (int c = 0; c < corners; ++c) {
      if (!takeNumber(line, number)) return malformed("a face has fewer corners than it declares");
      const bool usable = number >= 0 && number < static_cast<double>(mesh.positions.size());
      mesh.corners.push_back(usable ? static_cast<int>(number) : -1);
      if (!usable)
        return Error{ErrorCode::IndexOutOfRange,
                     where + ", line " + grouped(lines.lineNumber()) + ": face " + grouped(mesh.polygonCount()) +
                         " refers to vertex " + shortNumber(number) + " (counted from 0), but there are " +
                         grouped(static_cast<std::int64_t>(mesh.positions.size())) +
                         " vertices. Export the mesh again.",
                     -1, -1, mesh.polygonCount()};
    }
    if (corners >= 3) mesh.ends.push_back(static_cast<int>(mesh.corners.size()));
    else {
      mesh.corners.resize(start);
      ++leftOut;
    }
    int further = 0;
    while (further < 3 && takeNumber(line, number)) ++further;
    hasFaceColors |= further == 3;
    return {};
  }

  Result<PolygonMesh> read() {
    std::int64_t vertices = 0, faces = 0;
    if (Status header = readHeader(vertices, faces); !header) return header.error();
    std::string_view line;
    for (std::int64_t v = 0; v < vertices; ++v) {
      if (!nextLine(line)) return cutOff("vertices", vertices, mesh.positions.size());
      reportLine(onProgress, lines, size);
      if (Status vertex = readVertex(line); !vertex) return vertex.error();
    }
    for (std::int64_t f = 0; f < faces; ++f) {
      if (!nextLine(line)) return cutOff("faces", faces, static_cast<std::size_t>(f));
      reportLine(onProgress, lines, size);
      if (Status face = readFace(line); !face) return face.error();
    }
    if (Status polygons = checkPolygons(mesh, where); !polygons) return polygons.error();
    mesh.scene.groups = {{0, mesh.polygonCount(), -1}};
    warnOfLeftOut(mesh, leftOut, where);
    if (!colors.empty()) setColors(mesh, std::move(colors), ColorType::Any, ColorType::Any);
    if (hasFaceColors) warnOfFaceColors(mesh, where);
    return std::move(mesh);
  }
};

}  // namespace

Result<PolygonMesh> readOff(const NamedBytes& file, const std::string& where, const FractionReport& onProgress) {
  return OffReader{LineReader(file.bytes), file.bytes.size(), where, onProgress, {}}.read();
}

}  // namespace shapespline
