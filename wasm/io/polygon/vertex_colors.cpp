#include "io/polygon/vertex_colors.h"

#include <algorithm>
#include <cmath>

namespace shapespline {

namespace {

double rangeOf(double largest, ColorType type) {
  if (type == ColorType::Byte) return 255;
  // Rounding or a bright light can exceed 1 a little.
  if (type == ColorType::Any && largest <= 2) return 1;
  return largest <= 255 ? 255 : 65535;
}

}  // namespace

float linearColor(double srgb) {
  const double c = srgb >= 0 ? std::min(srgb, 1.0) : 0;
  return static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
}

void setColors(PolygonMesh& mesh, std::vector<float> numbers, ColorType rgb, ColorType opacity) {
  float largest = 0, largestOpacity = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    float& most = i % 4 == 3 ? largestOpacity : largest;
    if (std::isfinite(numbers[i])) most = std::max(most, numbers[i]);
  }
  const double range = rangeOf(largest, rgb), opacityRange = rangeOf(largestOpacity, opacity);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (std::isnan(numbers[i])) numbers[i] = 1;
    else if (i % 4 < 3) numbers[i] = linearColor(numbers[i] / range);
    else numbers[i] = static_cast<float>(std::clamp(numbers[i] / opacityRange, 0.0, 1.0));
  }
  numbers.resize(4 * mesh.positions.size(), 1);
  mesh.scene.colors = std::move(numbers);
}

void warnOfFaceColors(PolygonMesh& mesh, const std::string& where) {
  if (!mesh.scene.colors.empty()) return;
  mesh.warnings.push_back(
      {"face-colors", where + ": the colours of its faces are left out. Export colours of vertices, or glTF.", 1});
}

}  // namespace shapespline
