#include "core/shading.h"

#include <algorithm>
#include <cmath>

namespace shapespline {

void Shading::normals(const std::vector<Triangle>& faces, const std::vector<float>& p, std::vector<float>& normals) {
  std::fill(sum_.begin(), sum_.end(), 0.0f);
  for (const Triangle& f : faces) {
    const float* a = &p[3 * static_cast<std::size_t>(f[0])];
    const float* b = &p[3 * static_cast<std::size_t>(f[1])];
    const float* c = &p[3 * static_cast<std::size_t>(f[2])];
    const float ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
    const float vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
    const float nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    for (int v : f) {
      float* s = &sum_[3 * static_cast<std::size_t>(group_[v])];
      s[0] += nx, s[1] += ny, s[2] += nz;
    }
  }
  for (std::size_t g = 0; g < sum_.size(); g += 3) {
    // in double: the squares of a small mesh's areas leave the range of float
    const double x = sum_[g], y = sum_[g + 1], z = sum_[g + 2];
    const double length = std::sqrt(x * x + y * y + z * z);
    if (length > 0) {
      sum_[g] = static_cast<float>(x / length), sum_[g + 1] = static_cast<float>(y / length), sum_[g + 2] = static_cast<float>(z / length);
    } else {
      sum_[g] = sum_[g + 1] = 0, sum_[g + 2] = 1;
    }
  }
  normals.resize(p.size());
  for (std::size_t v = 0; v < group_.size(); ++v)
    std::copy_n(&sum_[3 * static_cast<std::size_t>(group_[v])], 3, &normals[3 * v]);
}

}  // namespace shapespline
