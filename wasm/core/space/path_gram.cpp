#include "core/space/path_gram.h"

#include <algorithm>
#include <cmath>

namespace shapespline {

namespace {

// The step from the previous column to this one.
int stepTo(const WeldedShape& shape, int column) {
  const KeySteps steps{shape.keys};
  if (column == shape.startTangent) return steps.startTangent();
  return column == shape.endTangent ? steps.endTangent() : column - 1;
}

}  // namespace

std::vector<double> areaShares(const WeldedKeys& keys, const LriSpace& lri) {
  const WeldedShape& shape = keys.shape;
  std::vector<double> share(static_cast<std::size_t>(shape.faceCount()), 0);
  double total = 0;
  lri.withReconstructor([&](const auto& r) {
    for (int f = 0; f < shape.faceCount(); ++f)
      if (lri.patchOfFace()[f] >= 0) total += share[r.coordinates().face.slot(f)] = referenceFrame(shape, f).area;
  });
  for (double& s : share) s /= total;
  return share;
}

template <class Real>
Eigen::MatrixXd pathGram(const WeldedKeys& keys, const LriSpace& lri, const RotationPaths<Real>& paths,
                         const std::vector<double>& weight) {
  const WeldedShape& shape = keys.shape;
  const int columns = shape.columns();
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(columns, columns);
  std::vector<double> three(static_cast<std::size_t>(columns) * 3);
  const auto put = [&](int column, const Vec3& v) {
    std::copy_n(v.data(), 3, &three[3 * static_cast<std::size_t>(column)]);
  };
  const auto at = [&](int column) -> Vec3 {
    return Eigen::Map<const Vec3>(&three[3 * static_cast<std::size_t>(column)]);
  };
  for (std::size_t slot = 0; slot < weight.size(); ++slot) {
    if (weight[slot] == 0) continue;
    put(0, Vec3::Zero());
    for (int c = 1; c < columns; ++c)
      put(c, at(shape.before(c)) + paths.increment(stepTo(shape, c), static_cast<int>(slot)));
    addProducts(gram, weight[slot], three);
  }
  lri.withReconstructor([&](const auto& r) {
    const auto& face = r.coordinates().face;
    const std::vector<double> share = areaShares(keys, lri);
    for (int f = 0; f < shape.faceCount(); ++f) {
      for (int c = 0; c < columns; ++c) put(c, {face.at(f, c, 3), std::sqrt(2.0) * face.at(f, c, 4), face.at(f, c, 5)});
      addProducts(gram, share[face.slot(f)], three);
    }
  });
  for (int c = 0; c < columns; ++c) put(c, keys.meanPosition[c] - keys.meanPosition[0]);
  addProducts(gram, 1 / (keys.diagonal * keys.diagonal), three);
  return gram;
}

template Eigen::MatrixXd pathGram(const WeldedKeys&, const LriSpace&, const RotationPaths<float>&,
                                  const std::vector<double>&);
template Eigen::MatrixXd pathGram(const WeldedKeys&, const LriSpace&, const RotationPaths<double>&,
                                  const std::vector<double>&);

}  // namespace shapespline
