// Reads one pose of polygons from OBJ, PLY and OFF.
#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/base/status.h"
#include "io/base/named_bytes.h"
#include "io/base/source_files.h"
#include "io/polygon/polygon_mesh.h"

namespace shapespline {

/// Wavefront OBJ with its MTL and textures if given: v (with colours), vt, vn, f, usemtl, mtllib. Lines, points and
/// curves are ignored. Coordinates belong to corners; a vertex gets the mean of its normals. `objects` selects faces by
/// object (o, or g in files without o). Errors, with the line number: MalformedFile, IndexOutOfRange, NoTriangles,
/// TooLarge. UnknownObject for a name in `objects` that the file does not have.
Result<PolygonMesh> readObj(const NamedBytes& file, const SourceFiles& files, const std::vector<std::string>& objects,
                            const std::string& where, const FractionReport& onProgress = {});

/// Stanford PLY 1.0: ascii, binary little and big endian; elements vertex, face and tristrips.
/// Errors: MalformedFile, TruncatedFile, IndexOutOfRange, NoTriangles, TooLarge.
Result<PolygonMesh> readPly(const NamedBytes& file, const std::string& where, const FractionReport& onProgress = {});

/// Object File Format: OFF, NOFF, COFF, STOFF and their combinations, as text.
/// Errors: MalformedFile, TruncatedFile, IndexOutOfRange, NoTriangles, TooLarge, Unsupported.
Result<PolygonMesh> readOff(const NamedBytes& file, const std::string& where, const FractionReport& onProgress = {});

/// Checks that every corner refers to a vertex and that a face exists. Every reader ends with this check.
Status checkPolygons(const PolygonMesh& mesh, const std::string& where);

/// Error for a number with a comma. `place`: the file, and the line if known.
Error decimalComma(const std::string& place);

/// Warns if faces with fewer than three corners were omitted.
void warnOfLeftOut(PolygonMesh& mesh, int leftOut, const std::string& where);

}  // namespace shapespline
