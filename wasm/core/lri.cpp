#include "core/lri.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "core/face_frame.h"

namespace shapespline {

namespace {

// Principal logarithms below a quarter turn in every pose are the nearest representatives already.
constexpr double tameAngle = std::numbers::pi / 2;

Vec3 centroidOf(const Positions& p, const Triangle& f) { return (p[f[0]] + p[f[1]] + p[f[2]]) / 3; }

std::vector<char> facesWithArea(const WeldedShape& shape) {
  std::vector<char> use(shape.faceCount());
  for (int f = 0; f < shape.faceCount(); ++f) {
    const Triangle& t = shape.faces[f];
    use[f] = std::none_of(shape.poses.begin(), shape.poses.end(),
                          [&](const Positions& p) { return isDegenerate(p[t[0]], p[t[1]], p[t[2]]); });
  }
  return use;
}

template <class Real>
class Encoder {
 public:
  Encoder(const WeldedShape& shape, int wantedPatches, Stretch stretch)
      : shape_(shape), wantedPatches_(wantedPatches), stretch_(stretch) {}

  LriCoordinates<Real> run() {
    out_.hasArea = facesWithArea(shape_);
    graph_ = dualGraph(shape_.vertexCount(), shape_.faces, out_.hasArea);
    out_.pieces = connectedPieces(graph_, out_.hasArea);
    partition();
    encodePairs();
    encodeFaces();
    encodeHolds();
    encodeLoose();
    for (const Positions& pose : shape_.poses) out_.meanPosition.push_back(meanOf(pose));
    return std::move(out_);
  }

 private:
  FaceFrame referenceFrame(int f) const {
    const Positions& p = shape_.poses[shape_.reference];
    const Triangle& t = shape_.faces[f];
    return faceFrame(p[t[0]], p[t[1]], p[t[2]]);
  }

  FaceDeformation deformationOf(int f, const FaceFrame& frame, int column) const {
    const Positions& p = shape_.poses[column];
    const Triangle& t = shape_.faces[f];
    return deformation(frame, p[t[0]], p[t[1]], p[t[2]]);
  }

  Quaternion rotationOf(int f, int column) const {
    return Quaternion(deformationOf(f, referenceFrame(f), column).rotation);
  }

  static Vec3 meanOf(const Positions& pose) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : pose) sum += p;
    return sum / static_cast<double>(pose.size());
  }

  template <class Visit>
  void eachUsedFace(Visit visit) const {
    for (int f = 0; f < shape_.faceCount(); ++f)
      if (out_.hasArea[f]) visit(f);
  }

  void partition() {
    const int m = shape_.faceCount(), columns = shape_.columns();
    std::vector<double> area(m, 0);
    Positions centroid(m, Vec3::Zero());
    std::vector<std::vector<Quaternion>> rotations(columns, std::vector<Quaternion>(m, Quaternion::Identity()));
    eachUsedFace([&](int f) {
      const FaceFrame frame = referenceFrame(f);
      area[f] = frame.area;
      centroid[f] = centroidOf(shape_.poses[shape_.reference], shape_.faces[f]);
      for (int c = 0; c < columns; ++c)
        rotations[c][f] = Quaternion(deformationOf(f, frame, c).rotation);
    });
    const int used = static_cast<int>(std::count(out_.hasArea.begin(), out_.hasArea.end(), 1));
    const int wanted = wantedPatches_ > 0 ? std::min(wantedPatches_, used) : defaultPatchCount(used);
    out_.patches = partitionFaces({graph_, out_.pieces, area, centroid, rotations}, wanted);
    out_.patchArea.assign(out_.patches.count, 0);
    eachUsedFace([&](int f) { out_.patchArea[out_.patches.ofFace[f]] += area[f]; });
    averageRotations(area);
  }

  // G_k: the projection to SO(3) of the area-weighted mean of R_f over the patch.
  void averageRotations(const std::vector<double>& area) {
    for (int c = 0; c < shape_.columns(); ++c) {
      std::vector<RotationMean> mean(out_.patches.count);
      eachUsedFace([&](int f) { mean[out_.patches.ofFace[f]].add(rotationOf(f, c), area[f]); });
      std::vector<Quaternion> rotation(out_.patches.count);
      for (int k = 0; k < out_.patches.count; ++k) rotation[k] = mean[k].mean();
      out_.rotation.push_back(std::move(rotation));
    }
  }

  void encodePairs() {
    const auto& pairs = out_.patches.pairs;
    const int columns = shape_.columns();
    out_.pair.assign(columns, std::vector<Vec3>(pairs.size()));
    out_.pairWeight.resize(pairs.size());
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      double largest = 0;
      for (int c = 0; c < columns; ++c) {
        const auto& g = out_.rotation[c];
        Vec3 x = logRotation(Quaternion(g[pairs[p].first].conjugate() * g[pairs[p].second]));
        if (c > 0) {
          const Vec3& before = out_.pair[shape_.before(c)][p];
          x = nearestRepresentative(x, before);
          if (c < shape_.keys) out_.largestPairTurn = std::max(out_.largestPairTurn, (x - before).norm());
        }
        out_.pair[c][p] = x;
        largest = std::max(largest, x.norm());
      }
      out_.pairWeight[p] = pairWeight(largest);
      const Vec3& first = out_.pair[0][p];
      addWinding(out_.pairWinding, static_cast<int>(p), first, out_.pair[shape_.keys - 1][p]);
    }
  }

  static void addWinding(std::vector<Winding>& windings, int index, const Vec3& first, const Vec3& last) {
    const Vec3 closing = nearestRepresentative(first, last);
    if ((closing - first).squaredNorm() > 1) windings.push_back({index, closing - first});  // a whole turn or none
  }

  void encodeFaces() {
    const int columns = shape_.columns();
    out_.face = FaceCoordinates<Real>(shape_.faceCount(), columns);
    std::vector<int> wild;
    eachUsedFace([&](int f) {
      const FaceFrame frame = referenceFrame(f);
      double largest = 0;
      for (int c = 0; c < columns; ++c) {
        const FaceDeformation d = deformationOf(f, frame, c);
        const Quaternion& g = out_.rotation[c][out_.patches.ofFace[f]];
        const Vec3 r = logRotation(Quaternion(g.conjugate() * Quaternion(d.rotation)));
        out_.face.setRotation(f, c, r);
        largest = std::max(largest, r.norm());
        const Mat2 s = stretch_ == Stretch::Log ? logSymmetric(d.stretch) : d.stretch;
        out_.face.at(f, c, 3) = static_cast<Real>(s(0, 0));
        out_.face.at(f, c, 4) = static_cast<Real>((s(0, 1) + s(1, 0)) / 2);
        out_.face.at(f, c, 5) = static_cast<Real>(s(1, 1));
      }
      if (largest > tameAngle) wild.push_back(f);
    });
    keepRest();
    unwrapWildFaces(wild);
  }

  // Faces without area and the padding behind the last face rest at the identity, so that no sum over lanes counts them.
  void keepRest() {
    const Real one = stretch_ == Stretch::Log ? Real(0) : Real(1);
    for (int f = 0; f < out_.face.paddedFaces(); ++f)
      for (int c = 0; c < shape_.columns() && (f >= shape_.faceCount() || !out_.hasArea[f]); ++c)
        out_.face.at(f, c, 3) = out_.face.at(f, c, 5) = one;
  }

  // Faces that turn far against their patch: branches agree with the pose before and with a neighbour in the patch that is
  // settled. Spreads from settled neighbours; what no neighbour reaches follows its own past alone.
  void unwrapWildFaces(const std::vector<int>& wild) {
    std::vector<char> open(shape_.faceCount(), 0);
    for (int f : wild) open[f] = 1;
    std::queue<std::pair<int, int>> next;  // face, settled neighbour or -1
    const auto spread = [&](int settled) {
      for (int g : graph_.of(settled))
        if (open[g] && out_.patches.ofFace[g] == out_.patches.ofFace[settled]) next.emplace(g, settled);
    };
    for (int f : wild)
      for (int g : graph_.of(f))
        if (!open[g] && out_.patches.ofFace[g] == out_.patches.ofFace[f]) {
          next.emplace(f, g);
          break;
        }
    const auto drain = [&] {
      while (!next.empty()) {
        const auto [f, neighbour] = next.front();
        next.pop();
        if (!open[f]) continue;
        open[f] = 0;
        unwrapFace(f, neighbour);
        spread(f);
      }
    };
    drain();
    for (int f : wild)
      if (open[f]) next.emplace(f, -1), drain();
    for (int f : wild)
      addWinding(out_.faceWinding, f, out_.face.rotation(f, 0), out_.face.rotation(f, shape_.keys - 1));
  }

  void unwrapFace(int f, int neighbour) {
    for (int c = 0; c < shape_.columns(); ++c) {
      const Vec3 r = out_.face.rotation(f, c);
      const bool hasBefore = c > 0;
      if (!hasBefore && neighbour < 0) continue;
      // nearest to two targets in least squares = nearest to their midpoint
      Vec3 target = Vec3::Zero();
      if (hasBefore) target += out_.face.rotation(f, shape_.before(c));
      if (neighbour >= 0) target += out_.face.rotation(neighbour, c);
      if (hasBefore && neighbour >= 0) target /= 2;
      out_.face.setRotation(f, c, nearestRepresentative(r, target));
    }
  }

  void encodeHolds() {
    std::vector<const Positions*> poses;
    for (const Positions& p : shape_.poses) poses.push_back(&p);
    out_.tree = linkComponents(shape_.faces, out_.pieces, poses);
    out_.hold.resize(out_.pieces.count);
    for (int piece = 0; piece < out_.pieces.count; ++piece) {
      ComponentHold& hold = out_.hold[piece];
      hold.link = out_.tree.link[piece];
      if (hold.link.parent < 0) continue;
      const int a = hold.link.anchorFace, b = hold.link.contactFace;
      for (int c = 0; c < shape_.columns(); ++c) {
        const Quaternion anchor = rotationOf(a, c);
        const Vec3 anchorLog = logRotation(Quaternion(out_.rotation[c][out_.patches.ofFace[a]].conjugate() * anchor));
        const Vec3 turn = logRotation(Quaternion(anchor.conjugate() * out_.rotation[c][out_.patches.ofFace[b]]));
        const bool first = c == 0;
        hold.anchorRotation.push_back(first ? anchorLog : nearestRepresentative(anchorLog, hold.anchorRotation[shape_.before(c)]));
        hold.rotation.push_back(first ? turn : nearestRepresentative(turn, hold.rotation[shape_.before(c)]));
        const Positions& p = shape_.poses[c];
        hold.offset.push_back(anchor.conjugate() * (centroidOf(p, shape_.faces[b]) - centroidOf(p, shape_.faces[a])));
      }
    }
  }

  void encodeLoose() {
    std::vector<int> faceAt(shape_.vertexCount(), -1);  // a face with area
    eachUsedFace([&](int f) {
      for (int v : shape_.faces[f])
        if (faceAt[v] < 0) faceAt[v] = f;
    });
    std::vector<int> anchor = faceAt;
    spreadOverFacesWithoutArea(anchor);
    int rootFace = -1;
    for (int f = 0; f < shape_.faceCount() && rootFace < 0; ++f)
      if (out_.pieces.ofFace[f] == out_.tree.root()) rootFace = f;
    for (int v = 0; v < shape_.vertexCount(); ++v) {
      if (faceAt[v] >= 0) continue;
      LooseVertex loose{v, anchor[v] >= 0 ? anchor[v] : rootFace, {}};
      for (int c = 0; c < shape_.columns(); ++c) {
        const Positions& p = shape_.poses[c];
        loose.offset.push_back(rotationOf(loose.anchorFace, c).conjugate() *
                               (p[v] - centroidOf(p, shape_.faces[loose.anchorFace])));
      }
      out_.loose.push_back(std::move(loose));
    }
  }

  // Vertices held only by faces without area take the anchor of the nearest vertex that such faces join them to.
  void spreadOverFacesWithoutArea(std::vector<int>& anchor) const {
    const VertexFaces facesAt = facesOfVertices(shape_.vertexCount(), shape_.faces);
    std::queue<int> settled;
    for (int v = 0; v < shape_.vertexCount(); ++v)
      if (anchor[v] >= 0) settled.push(v);
    while (!settled.empty()) {
      const int v = settled.front();
      settled.pop();
      for (int f : facesAt.of(v)) {
        if (out_.hasArea[f]) continue;
        for (int u : shape_.faces[f])
          if (anchor[u] < 0) anchor[u] = anchor[v], settled.push(u);
      }
    }
  }

  const WeldedShape& shape_;
  int wantedPatches_;
  Stretch stretch_;
  FaceGraph graph_;
  LriCoordinates<Real> out_;
};

}  // namespace

double pairWeight(double angle) {
  const double half = (1 + std::cos(std::min(angle, std::numbers::pi))) / 2;
  return 1e-5 + std::pow(half, 6);
}

template <class Real>
LriCoordinates<Real> encode(const WeldedShape& shape, int wantedPatches, Stretch stretch) {
  return Encoder<Real>(shape, wantedPatches, stretch).run();
}

template LriCoordinates<float> encode<float>(const WeldedShape&, int, Stretch);
template LriCoordinates<double> encode<double>(const WeldedShape&, int, Stretch);

}  // namespace shapespline
