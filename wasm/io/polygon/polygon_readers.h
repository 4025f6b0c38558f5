// OBJ, PLY and OFF -> one pose of polygons.
#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/base/status.h"
#include "io/base/given_files.h"
#include "io/base/named_bytes.h"
#include "io/polygon/polygon_mesh.h"

namespace shapespline {

/// Wavefront OBJ with its MTL and textures where they are among the files: v (with colours), vt, vn, f, usemtl, mtllib.
/// Lines, points and everything curved are left out. Coordinates belong to corners; a vertex has the mean of its
/// normals. With `objects`, the faces of these alone (o, or g where there is no o). Errors: MalformedFile,
/// IndexOutOfRange, NoTriangles, TooLarge, which name the line; InvalidOption of an object that is not there.
Result<PolygonMesh> readObj(const NamedBytes& file, const GivenFiles& files, const std::vector<std::string>& objects,
                            const std::string& where, const FractionReport& onProgress = {});

/// Stanford PLY 1.0: ascii, binary little and big endian; elements vertex, face and tristrips.
/// Errors: MalformedFile, TruncatedFile, IndexOutOfRange, NoTriangles, TooLarge.
Result<PolygonMesh> readPly(const NamedBytes& file, const std::string& where, const FractionReport& onProgress = {});

/// Object File Format: OFF, NOFF, COFF, STOFF and their combinations, as text.
/// Errors: MalformedFile, TruncatedFile, IndexOutOfRange, NoTriangles, TooLarge, Unsupported.
Result<PolygonMesh> readOff(const NamedBytes& file, const std::string& where, const FractionReport& onProgress = {});

/// Checks that every corner names a vertex and that there is a face; the last step of every reader.
Status checkPolygons(const PolygonMesh& mesh, const std::string& where);

/// A number is written with a decimal comma; `place`: the file, and the line where that is known.
Error decimalComma(const std::string& place);

/// Says so where faces of fewer than three corners were left out.
void warnOfLeftOut(PolygonMesh& mesh, int leftOut, const std::string& where);

}  // namespace shapespline
