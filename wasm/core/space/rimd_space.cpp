#include "core/space/rimd_space.h"

#include <algorithm>
#include <cmath>

#include "core/patches/patch_coordinates.h"
#include "core/space/path_gram.h"

namespace shapespline {

namespace {

// Steps per frame. More steps move away from LRI space without reducing the error.
constexpr int rounds = 3;
// Pairs with large relative rotations in a step have less weight, but never zero.
constexpr double minAgreement = 1e-5;

// The rotation nearest to a matrix: Newton's iteration for the polar factor (Higham 1986), until it converges.
Quaternion nearestRotation(const Mat3& matrix) {
  const double determinant = matrix.determinant(), size = matrix.norm();
  if (!(determinant > 1e-6 * size * size * size)) return Quaternion(projectToRotation(matrix));
  Mat3 x = matrix / std::cbrt(determinant);
  for (int i = 0; i < 20; ++i) {
    const Mat3 next = (x + x.inverse().transpose()) / 2;
    const double moved = (next - x).squaredNorm();
    x = next;
    if (moved < 1e-30) break;
  }
  return Quaternion(x).normalized();
}

struct Pair {
  int first, second;
};

// Both directions: a product of increments and the product of their inverses are different paths.
std::vector<Pair> pairsOf(const ShapeTopology& topology) {
  std::vector<Pair> pairs;
  topology.eachUsedFace([&](int f) {
    for (const int g : topology.graph.of(f)) pairs.push_back({f, g});
  });
  return pairs;
}

RotationSplines differencesOf(const WeldedShape& shape, const std::vector<Pair>& pairs) {
  const KeySteps steps{shape.keys};
  RotationSplines paths;
  for (int c = 0; c < shape.columns(); ++c) {
    std::vector<Quaternion>& key = paths.key.emplace_back();
    for (const Pair& p : pairs)
      key.push_back((rotationOf(shape, p.first, c).conjugate() * rotationOf(shape, p.second, c)).normalized());
  }
  paths.increment.resize(steps.count());
  for (int s = 0; s < steps.count(); ++s) {
    const auto [from, to] = posesOf(shape, s);
    for (std::size_t p = 0; from >= 0 && p < pairs.size(); ++p)
      paths.increment[s].push_back(logRotation(Quaternion(paths.key[from][p].conjugate() * paths.key[to][p])));
  }
  return paths;
}

// Between keys only.
double agreementOf(const RotationSplines& differences, int keys, std::size_t pair) {
  double largest = 0;
  for (int s = 0; s + 1 < keys; ++s) largest = std::max(largest, differences.increment[s][pair].norm());
  return minAgreement + std::pow(agreement(largest), 6);
}

}  // namespace

RimdSpace::RimdSpace(const WeldedKeys& keys, const LriSpace& lri) : keys_(&keys), lri_(&lri) {
  const WeldedShape& shape = keys.shape;
  const ShapeTopology topology = topologyOf(shape);
  const std::vector<Pair> pairs = pairsOf(topology);
  const RotationSplines differences = differencesOf(shape, pairs);
  pairs_ = static_cast<int>(pairs.size());
  for (int f = 0; f < shape.faceCount(); ++f)
    frame_.push_back(topology.turns[f] ? referenceFrame(shape, f) : FaceFrame{});
  topology.eachUsedFace([&](int f) { used_.push_back(f); });
  neighbours_ = compressedRows<Side>(shape.faceCount(), [&](auto add) {
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      const auto [f, g] = pairs[p];
      const double weight = (frame_[f].area + frame_[g].area) / 4 * agreementOf(differences, shape.keys, p);
      add(f, {g, static_cast<int>(p), weight, true});
      add(g, {f, static_cast<int>(p), weight, false});
    }
  });
  std::vector<int> slotOfPair(pairs.size());
  for (std::size_t p = 0; p < pairs.size(); ++p) slotOfPair[p] = static_cast<int>(p);
  differences_ = RotationPaths<double>(differences, KeySteps{shape.keys}, slotOfPair);
  lri.withReconstructor([&](const auto& r) {
    for (int f = 0; f < shape.faceCount(); ++f) slotOf_.push_back(r.coordinates().face.slot(f));
  });
}

// The rotation of a face that best fits the shape and its neighbours.
Quaternion RimdSpace::agreeing(int face, const Scratch& scratch) const {
  const FaceFrame& frame = frame_[face];
  const FaceDeformation now = deformationIn(scratch.positions, face);
  const std::size_t at = rotationAt(slotOf_[face], 0) / rotationBlock * stretchBlock + slotOf_[face] % faceLanes;
  Mat2 wanted;
  wanted << scratch.stretch[at], scratch.stretch[at + faceLanes], scratch.stretch[at + faceLanes],
      scratch.stretch[at + 2 * faceLanes];
  Mat3 product = Mat3::Identity();
  product.topLeftCorner<2, 2>() = now.stretch * wanted;
  Mat3 sum = Mat3::Zero();
  // Skips collapsed faces.
  if (now.rotation.allFinite() && now.stretch.allFinite())
    sum = frame.area * (now.rotation * frame.basis * product * frame.basis.transpose());
  for (const Side& side : neighbours_.of(face)) {
    const Quaternion difference = rotationOf(scratch.differences, side.pair);
    const Quaternion said = scratch.before[side.face] * (side.isFirst ? difference.conjugate() : difference);
    sum += side.weight * said.toRotationMatrix();
  }
  return nearestRotation(sum);
}

FaceDeformation RimdSpace::deformationIn(const Positions& positions, int face) const {
  const Triangle& t = keys_->shape.faces[face];
  return deformation(frame_[face], positions[t[0]], positions[t[1]], positions[t[2]]);
}

template <class Real>
Reconstruction RimdSpace::improve(const CurvePoint& point, const Reconstructor<Real>& reconstructor, Scratch& scratch,
                                  typename Reconstructor<Real>::Scratch& ofReconstructor, PaddedShape<Real>& shape,
                                  ForkJoin* forkJoin) const {
  const int faces = keys_->shape.faceCount();
  std::vector<Real> stretch;
  RotationBlocks<Real> rotations(rotationNumbers(faces), Real(0));
  differences_.at(point, Quaternion::Identity(), scratch.differences, forkJoin);
  reconstructor.stretchesAt(point, stretch);
  scratch.stretch.assign(stretch.begin(), stretch.end());
  reconstructor.positionsOf(shape, scratch.positions);
  scratch.rotation.assign(static_cast<std::size_t>(faces), Quaternion::Identity());
  for (const int f : used_) scratch.rotation[f] = startOf(scratch.positions, f);
  Reconstruction found;
  for (int round = 0; round < rounds; ++round) {
    scratch.before = scratch.rotation;
    for (const int f : used_) scratch.rotation[f] = agreeing(f, scratch);
    for (const int f : used_) setRotation(rotations, slotOf_[f], scratch.rotation[f]);
    found = reconstructor.reconstruct(point, rotations, ofReconstructor, shape, forkJoin);
    reconstructor.positionsOf(shape, scratch.positions);
  }
  return found;
}

Quaternion RimdSpace::startOf(const Positions& positions, int face) const {
  const FaceDeformation d = deformationIn(positions, face);
  return d.rotation.allFinite() ? Quaternion(d.rotation).normalized() : Quaternion::Identity();
}

Eigen::MatrixXd RimdSpace::gramMatrix() const {
  return pathGram(*keys_, *lri_, differences_, std::vector<double>(static_cast<std::size_t>(pairs_), 1.0 / pairs_));
}

template Reconstruction RimdSpace::improve(const CurvePoint&, const Reconstructor<float>&, Scratch&,
                                           Reconstructor<float>::Scratch&, PaddedShape<float>&, ForkJoin*) const;
template Reconstruction RimdSpace::improve(const CurvePoint&, const Reconstructor<double>&, Scratch&,
                                           Reconstructor<double>::Scratch&, PaddedShape<double>&, ForkJoin*) const;

}  // namespace shapespline
