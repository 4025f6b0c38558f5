// Converts the colours of OBJ, PLY and OFF. None of them states the range of its numbers.
#pragma once

#include <string>
#include <vector>

#include "io/polygon/polygon_mesh.h"

namespace shapespline {

/// Converts sRGB to linear.
float linearColor(double srgb);

/// Type of colour numbers. Integers go up to 255 or 65535, and other numbers also up to 1. The largest number decides.
enum class ColorType { Byte, Integer, Any };

/// Stores colours, given as 4 numbers per vertex: sRGB and opacity. Numbers that are NaN or missing at the end are 1.
void setColors(PolygonMesh& mesh, std::vector<float> numbers, ColorType rgb, ColorType opacity);

/// Warns that colours of faces are left out, if vertices have none.
void warnOfFaceColors(PolygonMesh& mesh, const std::string& where);

}  // namespace shapespline
