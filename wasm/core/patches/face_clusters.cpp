#include "core/patches/face_clusters.h"

#include <algorithm>

namespace shapespline {

namespace {

// Grows breadth first from a face over unassigned faces.
void growCluster(const FaceGraph& graph, int first, int cluster, std::size_t largest, FaceClusters& clusters) {
  const std::size_t begin = clusters.member.size();
  const auto take = [&](int f) {
    if (clusters.ofFace[f] >= 0 || clusters.member.size() == begin + largest) return;
    clusters.ofFace[f] = cluster;
    clusters.member.push_back(f);
  };
  take(first);
  for (std::size_t i = begin; i < clusters.member.size(); ++i)
    for (const int g : graph.of(clusters.member[i])) take(g);
}

// Sums over the members' areas, then means.
void average(const PatchInput& input, std::span<const int> members, int cluster, FaceClusters& clusters) {
  const int poses = input.comparedPoses;
  const Quaternion* first = input.rotations.of(members[0]);
  double area = 0;
  Vec3 centroid = Vec3::Zero();
  Quaternion* mean = clusters.rotations.of(cluster);
  for (int p = 0; p < poses; ++p) mean[p].coeffs().setZero();
  for (const int f : members) {
    area += input.area[f];
    centroid += input.area[f] * input.centroid[f];
    const Quaternion* rotation = input.rotations.of(f);
    for (int p = 0; p < poses; ++p)  // choose the sign of each quaternion that is closer to the first
      mean[p].coeffs() += (rotation[p].dot(first[p]) < 0 ? -input.area[f] : input.area[f]) * rotation[p].coeffs();
  }
  for (int p = 0; p < poses; ++p) mean[p].normalize();
  clusters.area.push_back(area);
  clusters.centroid.push_back(centroid / area);
  clusters.components.ofFace.push_back(input.components.ofFace[members[0]]);
}

}  // namespace

FaceClusters clusterFaces(const PatchInput& input, int largest, const FractionReport& onProgress) {
  FaceClusters clusters;
  const std::size_t faces = input.area.size();
  clusters.ofFace.assign(faces, -1);
  clusters.member.reserve(faces);
  std::vector<int> ends = {0};  // end of each cluster's members
  inBlocks(partOf(onProgress, 0, 0.4), faces, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      if (input.components.ofFace[f] < 0 || clusters.ofFace[f] >= 0) continue;
      const int cluster = static_cast<int>(ends.size()) - 1;
      growCluster(input.graph, static_cast<int>(f), cluster, static_cast<std::size_t>(largest), clusters);
      ends.push_back(static_cast<int>(clusters.member.size()));
    }
  });
  const int count = static_cast<int>(ends.size()) - 1;
  clusters.components.count = input.components.count;
  clusters.rotations = FaceRotations(count, input.comparedPoses);
  std::vector<int> lastMet(count, -1);  // last cluster that met each cluster
  inBlocks(partOf(onProgress, 0.4, 1), static_cast<std::size_t>(count), [&](std::size_t begin, std::size_t end) {
    for (int c = static_cast<int>(begin); c < static_cast<int>(end); ++c) {
      const std::span<const int> members{clusters.member.data() + ends[c], clusters.member.data() + ends[c + 1]};
      average(input, members, c, clusters);
      lastMet[c] = c;
      for (const int f : members)
        for (const int g : input.graph.of(f)) {
          const int other = clusters.ofFace[g];
          if (lastMet[other] != c) {
            lastMet[other] = c;
            clusters.graph.item.push_back(other);
          }
        }
      clusters.graph.start.push_back(static_cast<int>(clusters.graph.item.size()));
    }
  });
  return clusters;
}

}  // namespace shapespline
