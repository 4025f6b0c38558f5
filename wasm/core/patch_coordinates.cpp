#include "core/patch_coordinates.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shapespline {

namespace {

class PatchEncoder {
 public:
  PatchEncoder(const WeldedShape& shape, const ShapeParts& parts) : shape_(shape), parts_(parts) {}

  PatchCoordinates run(int wantedPatches, const FractionReport& onProgress) {
    partition(wantedPatches, onProgress);
    encodePairs();
    encodeTurns();
    return std::move(out_);
  }

 private:
  void partition(int wantedPatches, const FractionReport& onProgress) {
    const int m = shape_.faceCount(), columns = shape_.columns();
    std::vector<double> area(m, 0);
    Positions centroid(m, Vec3::Zero());
    FaceRotations rotations(m, columns);
    const auto measure = [&](int f) {
      const FaceFrame frame = referenceFrame(shape_, f);
      area[f] = frame.area;
      centroid[f] = centroidOf(shape_.poses[shape_.reference], shape_.faces[f]);
      for (int c = 0; c < columns; ++c) rotations.of(f)[c] = Quaternion(deformationOf(shape_, f, frame, c).rotation);
    };
    parts_.eachUsedFace(measure, partOf(onProgress, 0, 0.3));
    const int used = static_cast<int>(std::count(parts_.hasArea.begin(), parts_.hasArea.end(), 1));
    const int wanted = wantedPatches > 0 ? std::min(wantedPatches, used) : defaultPatchCount(used);
    out_.patches = partitionFaces({parts_.graph, parts_.pieces, area, centroid, rotations}, wanted, partOf(onProgress, 0.3, 0.9));
    out_.area.assign(out_.patches.count, 0);
    parts_.eachUsedFace([&](int f) { out_.area[out_.patches.ofFace[f]] += area[f]; });
    averageRotations(area, rotations, partOf(onProgress, 0.9, 1));
  }

  // G_k: the projection to SO(3) of the area-weighted mean of R_f over the patch.
  void averageRotations(const std::vector<double>& area, const FaceRotations& rotations, const FractionReport& onProgress) {
    const int columns = shape_.columns();
    for (int c = 0; c < columns; ++c) {
      std::vector<RotationMean> mean(out_.patches.count);
      const auto add = [&](int f) { mean[out_.patches.ofFace[f]].add(rotations.of(f)[c], area[f]); };
      parts_.eachUsedFace(add, partOf(onProgress, static_cast<double>(c) / columns, (c + 1.0) / columns));
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
      addWinding(out_.pairWinding, static_cast<int>(p), out_.pair[0][p], out_.pair[shape_.keys - 1][p]);
    }
  }

  void encodeTurns() {
    for (int piece : parts_.tree.order) {
      const ComponentLink& link = parts_.tree.link[piece];
      if (link.parent < 0) continue;
      ComponentTurn turn{piece, out_.patches.ofFace[link.anchorFace], out_.patches.ofFace[link.contactFace], {}, {}};
      for (int c = 0; c < shape_.columns(); ++c) {
        const Quaternion anchor = rotationOf(shape_, link.anchorFace, c);
        appendNearest(turn.anchorRotation, shape_, logRotation(Quaternion(out_.rotation[c][turn.anchorPatch].conjugate() * anchor)));
        appendNearest(turn.rotation, shape_, logRotation(Quaternion(anchor.conjugate() * out_.rotation[c][turn.contactPatch])));
      }
      out_.turns.push_back(std::move(turn));
    }
  }

  const WeldedShape& shape_;
  const ShapeParts& parts_;
  PatchCoordinates out_;
};

}  // namespace

PatchCoordinates encodePatches(const WeldedShape& shape, const ShapeParts& parts, int wantedPatches,
                               const FractionReport& onProgress) {
  return PatchEncoder(shape, parts).run(wantedPatches, onProgress);
}

double pairWeight(double angle) {
  const double half = (1 + std::cos(std::min(angle, std::numbers::pi))) / 2;
  return 1e-5 + std::pow(half, 6);
}

}  // namespace shapespline
