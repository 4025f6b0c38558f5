#include "core/lri/lri.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/centroid.h"

namespace shapespline {

namespace {

// Principal logarithms below a quarter turn in every pose need no unwrapping.
constexpr double tameAngle = std::numbers::pi / 2;
// Frames do not rotate in the reference pose. Smaller measured rotations are rounding.
constexpr double roundedTurn = 1e-9;

template <class Real>
class Encoder {
 public:
  Encoder(const WeldedShape& shape, const ShapeTopology& topology, const LocalFramePoses& frames, Stretch stretch,
          Transfer transfer)
      : shape_(shape), topology_(topology), frames_(frames), stretch_(stretch), rests_(transfer == Transfer::Paper) {}

  LriCoordinates<Real> run(const FractionReport& onProgress) {
    out_.face =
        FaceCoordinates<Real>(shape_.faceCount(), shape_.columns(), stretch_ == Stretch::Log ? Real(0) : Real(1));
    if (!rests_) encodeFaces(partOf(onProgress, 0, 0.9));
    CarriedComponents carried = encodeCarriedComponents(shape_, topology_, frames_, rests_);
    out_.joints = std::move(carried.joints);
    out_.loose = std::move(carried.loose);
    out_.torn = encodeTornFaces(shape_, topology_, frames_, rests_);
    reportFraction(onProgress, 0.95);
    for (const Positions& pose : shape_.poses) out_.meanPosition.push_back(centroidOf(pose));
    return std::move(out_);
  }

 private:
  const Quaternion& localFrameOf(int f, int column) const { return frames_.rotation[column][frames_.ofFace[f]]; }

  void encodeFaces(const FractionReport& onProgress) {
    const int columns = shape_.columns();
    out_.face.store();
    std::vector<int> wild, turning;
    double area = 0;
    const auto encodeFace = [&](int f) {
      const FaceFrame frame = referenceFrame(shape_, f);
      double largest = 0;
      area += frame.area;
      for (int c = 0; c < columns; ++c) {
        if (c == shape_.reference) {
          const Vec3 r = logRotation(localFrameOf(f, c).conjugate());
          if (r.norm() > roundedTurn) out_.face.setRotation(f, c, r);
          continue;  // the identity deformation
        }
        const FaceDeformation d = deformationOf(shape_, f, frame, c);
        const Vec3 r = logRotation(Quaternion(localFrameOf(f, c).conjugate() * Quaternion(d.rotation)));
        out_.face.setRotation(f, c, r);
        largest = std::max(largest, r.norm());
        const Mat2 s = stretch_ == Stretch::Log ? logSymmetric(d.stretch) : d.stretch;
        out_.face.set(f, c, 3, static_cast<Real>(s(0, 0)));
        out_.face.set(f, c, 4, static_cast<Real>((s(0, 1) + s(1, 0)) / 2));
        out_.face.set(f, c, 5, static_cast<Real>(s(1, 1)));
      }
      if (largest > tameAngle) wild.push_back(f);
      if (largest > ambiguousTurn / 2) turning.push_back(f);
    };
    topology_.eachUsedFace(encodeFace, partOf(onProgress, 0, 0.9));
    unwrapWildFaces(wild);
    findAmbiguousFaces(turning, area);
    reportFraction(onProgress, 0.95);
    out_.face.dropIfAtRest(shape_.reference);
  }

  // Unwraps faces with large rotations in their frames. Their branches must agree with the previous pose and with a
  // resolved neighbour in the same frame. Spreads from resolved neighbours. Faces without one follow their previous
  // poses only.
  void unwrapWildFaces(const std::vector<int>& wild) {
    std::vector<char> open(shape_.faceCount(), 0);
    for (int f : wild) open[f] = 1;
    std::vector<std::pair<int, int>> next;  // a queue of faces with a resolved neighbour or -1
    std::size_t taken = 0;
    const auto spread = [&](int settled) {
      for (int g : topology_.graph.of(settled))
        if (open[g] && frames_.ofFace[g] == frames_.ofFace[settled]) next.emplace_back(g, settled);
    };
    for (int f : wild)
      for (int g : topology_.graph.of(f))
        if (!open[g] && frames_.ofFace[g] == frames_.ofFace[f]) {
          next.emplace_back(f, g);
          break;
        }
    const auto drain = [&] {
      while (taken < next.size()) {
        const auto [f, neighbour] = next[taken++];
        if (!open[f]) continue;
        open[f] = 0;
        unwrapFace(f, neighbour);
        spread(f);
      }
    };
    drain();
    for (int f : wild)
      if (open[f]) {
        next.emplace_back(f, -1);
        drain();
      }
  }

  // Proceeds from the reference pose, which has no rotation, to both ends. Reversed keys then unwrap equally.
  void unwrapFace(int f, int neighbour) {
    const int reference = shape_.reference;
    for (int c = reference - 1; c >= 0; --c) unwrapPose(f, neighbour, c, c + 1);
    for (int c = reference + 1; c < shape_.columns(); ++c) unwrapPose(f, neighbour, c, shape_.before(c));
  }

  void unwrapPose(int f, int neighbour, int column, int before) {
    // The least-squares fit to two targets is the nearest to their midpoint.
    Vec3 target = out_.face.rotation(f, before);
    if (neighbour >= 0) target = (target + out_.face.rotation(neighbour, column)) / 2;
    out_.face.setRotation(f, column, nearestRepresentative(out_.face.rotation(f, column), target));
  }

  void findAmbiguousFaces(const std::vector<int>& turning, double area) {
    out_.ambiguous.resize(shape_.keys - 1);
    for (int j = 0; j + 1 < shape_.keys; ++j) {
      AmbiguousFaces& found = out_.ambiguous[j];
      double furthest = ambiguousTurn;
      for (const int f : turning) {
        const double angle = (out_.face.rotation(f, j + 1) - out_.face.rotation(f, j)).norm();
        if (angle <= ambiguousTurn) continue;
        ++found.count;
        found.area += referenceFrame(shape_, f).area / area;
        if (angle > furthest) {
          furthest = angle;
          found.worst = f;
        }
      }
    }
  }

  const WeldedShape& shape_;
  const ShapeTopology& topology_;
  const LocalFramePoses& frames_;
  Stretch stretch_;
  bool rests_;
  LriCoordinates<Real> out_;
};

}  // namespace

template <class Real>
LriCoordinates<Real> encode(const WeldedShape& shape, const ShapeTopology& topology, const LocalFramePoses& frames,
                            Stretch stretch, Transfer transfer, const FractionReport& onProgress) {
  return Encoder<Real>(shape, topology, frames, stretch, transfer).run(onProgress);
}

template LriCoordinates<float> encode<float>(const WeldedShape&, const ShapeTopology&, const LocalFramePoses&, Stretch,
                                             Transfer, const FractionReport&);
template LriCoordinates<double> encode<double>(const WeldedShape&, const ShapeTopology&, const LocalFramePoses&,
                                               Stretch, Transfer, const FractionReport&);

}  // namespace shapespline
