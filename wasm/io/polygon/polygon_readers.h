// OBJ, PLY and OFF -> one pose of polygons.
#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/base/status.h"
#include "io/base/given_files.h"
#include "io/base/named_bytes.h"
#include "io/polygon/polygon_mesh.h"

namespace shapespline {

/// Wavefront OBJ with its MTL and textures if given: v (with colours), vt, vn, f, usemtl, mtllib. Lines, points and
/// curves are left out. Coordinates belong to corners; a vertex gets the mean of its normals. With `objects`, only
/// their faces (o, or g without any o). Errors: MalformedFile, IndexOutOfRange, NoTriangles, TooLarge, which name the
/// line; InvalidOption for an unknown object.
Result<PolygonMesh> readObj(const NamedBytes& file, const GivenFiles& files, const std::vector<std::string>& objects,
                            const std::string& where, const FractionReport& onProgress = {});

/// Stanford PLY 1.0: ascii, binary little and big endian; elements vertex, face and tristrips.
/// Errors: MalformedFile, TruncatedFile, IndexOutOfRange, NoTriangles, TooLarge.
Result<PolygonMesh> readPly(const NamedBytes& file, const std::string& where, const FractionReport& onProgress = {});

/// Object File Format: OFF, NOFF, COFF, STOFF and their combinations, as text.
/// Errors: MalformedFile, TruncatedFile, IndexOutOfRange, NoTriangles, TooLarge, Unsupported.
Result<PolygonMesh> readOff(const NamedBytes& file, const std::string& where, const FractionReport& onProgress = {});

/// Checks that every corner refers to a vertex and that there is a face; the last step of every reader.
Status checkPolygons(const PolygonMesh& mesh, const std::string& where);

/// Error for a number with a decimal comma; `place`: the file, and the line if known.
Error decimalComma(const std::string& place);

/// Warns if faces with fewer than three corners were left out.
void warnOfLeftOut(PolygonMesh& mesh, int leftOut, const std::string& where);

}  // namespace shapespline
