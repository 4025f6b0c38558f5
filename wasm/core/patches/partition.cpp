#include "core/patches/partition.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <queue>

#include "core/patches/face_clusters.h"

namespace shapespline {

namespace {

// Number of rounds of growing and re-seeding. The cost hardly falls after the third.
constexpr int rounds = 4;

// Meshes with at least largeFaceCount faces are partitioned by clusters of clusterSize faces, if each patch has at
// least minClusters clusters.
constexpr int largeFaceCount = 60000, clusterSize = 8, minClusters = 8;

// Weight of the squared distance to the patch centre over the squared mean patch radius, relative to the rotation cost.
// It keeps patches compact where all rotations agree, and is below the cost of a rotation by 7 degrees in one key.
constexpr double distanceWeight = 0.03;

// Number of candidate faces or clusters for the initial seeds, as a multiple of the number of seeds.
constexpr int candidatesPerSeed = 48, candidateClustersPerSeed = 12;

// Approximate share of the run time.
constexpr double shareOfSeeds = 0.3;

// Rounds to steps of 2^-20. Ties in a symmetric mesh then go to the lower index. A common rigid motion of all keys
// changes costs by rounding only, so it does not change the partition.
double inSteps(double exact) { return std::nearbyint(exact * 0x1p20); }

// A growing patch.
struct Centre {
  std::vector<Quaternion> rotation;  // one per compared pose
  Vec3 position;
  double inverseRadiusSquared;
  int seed;
};

// Data of a face for growing, in one place. Faces are accessed in random order, so each separate access would wait for
// memory.
struct GrowingFace {
  static constexpr int manyNeighbours = -2;

  double cheapest;   // cost of the best claim so far; worse claims need not queue
  int claimant;      // patch of that claim, or -1
  int patch;         // -1 while unassigned
  int neighbour[3];  // -1 if missing; the first is manyNeighbours if the graph has more
};

class Partition {
 public:
  Partition(const PatchInput& input, const FractionReport& onProgress)
      : in_(input), onProgress_(onProgress), faceCount_(static_cast<int>(input.area.size())) {
    patches_.ofFace.assign(faceCount_, -1);
    growing_.resize(faceCount_);
    for (int f = 0; f < faceCount_; ++f) {
      const std::span<const int> neighbours = in_.graph.of(f);
      std::fill_n(growing_[f].neighbour, 3, -1);
      if (neighbours.size() > 3) growing_[f].neighbour[0] = GrowingFace::manyNeighbours;
      else std::copy(neighbours.begin(), neighbours.end(), growing_[f].neighbour);
    }
  }

  // Finds patches in rounds, from seeds far from each other.
  void find(int wanted, int candidates) {
    chooseSeeds(wanted, candidates);
    for (int round = 0; round < rounds; ++round) {
      const double share = (1 - shareOfSeeds) / rounds, begin = shareOfSeeds + share * round;
      if (round > 0) recentre(partOf(onProgress_, begin, begin + 0.3 * share));
      forget();
      for (std::size_t k = 0; k < centres_.size(); ++k) growing_[centres_[k].seed].patch = static_cast<int>(k);
      grow(partOf(onProgress_, round > 0 ? begin + 0.3 * share : begin, begin + 0.95 * share));
    }
  }

  // Refines patches of clusters: their inner faces stay, the rest is grown by faces.
  void refine(Partition& coarse, const FaceClusters& clusters) {
    coarse.recentre({});
    centres_ = std::move(coarse.centres_);
    patches_.componentOf = std::move(coarse.patches_.componentOf);
    const std::vector<int> within = coarse.within(centres_);
    forget();
    for (int f = 0; f < faceCount_; ++f)
      if (clusters.ofFace[f] >= 0) growing_[f].patch = within[clusters.ofFace[f]];
    grow(onProgress_);
  }

  Patches take() {
    patches_.count = static_cast<int>(centres_.size());
    numberByFaces();
    collectPairs();
    return std::move(patches_);
  }

 private:
  static double distanceCost(const Vec3& centroid, const Centre& centre) {
    return distanceWeight * (centroid - centre.position).squaredNorm() * centre.inverseRadiusSquared;
  }

  // rotation: the face's rotation in each key.
  static double cost(const Vec3& centroid, const Quaternion* rotation, const Centre& centre) {
    double rotationCost = 0;  // |R - G|_F^2 = 8 (1 - (q . g)^2)
    for (std::size_t j = 0; j < centre.rotation.size(); ++j) {
      const double dot = rotation[j].dot(centre.rotation[j]);
      rotationCost += 8 * (1 - dot * dot);
    }
    return inSteps(rotationCost + distanceCost(centroid, centre));
  }

  double cost(int face, const Centre& centre) const { return cost(in_.centroid[face], in_.rotations.of(face), centre); }

  Centre centreAt(int face, double inverseRadiusSquared) const {
    const Quaternion* rotation = in_.rotations.of(face);
    return {{rotation, rotation + in_.comparedPoses}, in_.centroid[face], inverseRadiusSquared, face};
  }

  void chooseSeeds(int wanted, int candidates) {
    std::vector<std::vector<int>> members(in_.components.count);
    int used = 0;
    for (int f = 0; f < faceCount_; ++f)
      if (in_.components.ofFace[f] >= 0) {
        members[in_.components.ofFace[f]].push_back(f);
        ++used;
      }
    for (int component = 0; component < in_.components.count; ++component) {
      const auto size = static_cast<int>(members[component].size());
      const auto share = static_cast<int>(std::lround(static_cast<double>(wanted) * size / std::max(1, used)));
      chooseSeedsOf(component, members[component], std::clamp(share, 1, size), wanted, candidates);
    }
  }

  void chooseSeedsOf(int component, const std::vector<int>& members, int count, int wanted, int perSeed) {
    double area = 0;
    Vec3 middle = Vec3::Zero();
    for (int f : members) {
      area += in_.area[f];
      middle += in_.area[f] * in_.centroid[f];
    }
    middle /= area;
    const double inverseRadiusSquared = count * std::numbers::pi / area;

    const int candidateCount = std::min<int>(static_cast<int>(members.size()), std::max(count * perSeed, 512));
    std::vector<int> candidates(candidateCount);
    for (int i = 0; i < candidateCount; ++i)
      candidates[i] =
          members[static_cast<std::int64_t>(i) * static_cast<std::int64_t>(members.size()) / candidateCount];

    // Stored contiguously, because every seed scans all candidates.
    Positions centroid;
    FaceRotations rotations(candidateCount, in_.comparedPoses);
    for (int i = 0; i < candidateCount; ++i) {
      centroid.push_back(in_.centroid[candidates[i]]);
      std::copy_n(in_.rotations.of(candidates[i]), rotations.poses, rotations.of(i));
    }

    const auto farness = [&](int f) { return inSteps((in_.centroid[f] - middle).squaredNorm() / area); };
    std::vector<double> nearest(candidateCount, std::numeric_limits<double>::infinity());
    int next = 0;
    for (int i = 1; i < candidateCount; ++i)  // the first seed is the farthest from the centre
      if (farness(candidates[i]) > farness(candidates[next])) next = i;
    for (int s = 0; s < count; ++s) {
      if (s % 16 == 0)
        reportFraction(onProgress_, shareOfSeeds * std::min(1.0, static_cast<double>(centres_.size()) / wanted));
      centres_.push_back(centreAt(candidates[next], inverseRadiusSquared));
      patches_.componentOf.push_back(component);
      nearest[next] = -1;
      inBlocks({}, nearest.size(), [&](std::size_t begin, std::size_t end) {
        const Centre& centre = centres_.back();
        for (std::size_t i = begin; i < end; ++i) {
          // Most candidates are too far away, so their rotations need no test.
          if (nearest[i] < 0 || inSteps(distanceCost(centroid[i], centre)) > nearest[i]) continue;
          nearest[i] = std::min(nearest[i], cost(centroid[i], rotations.of(static_cast<int>(i)), centre));
        }
      });
      next = static_cast<int>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
      if (nearest[next] < 0) break;  // every candidate is a seed
    }
  }

  // Calls visit(face, patch) for all assigned faces.
  template <class Visit>
  void eachFace(const FractionReport& onProgress, Visit visit) const {
    inBlocks(onProgress, patches_.ofFace.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
        if (patches_.ofFace[f] >= 0) visit(static_cast<int>(f), patches_.ofFace[f]);
    });
  }

  void forget() {
    for (GrowingFace& face : growing_) {
      face.cheapest = std::numeric_limits<double>::infinity();
      face.claimant = face.patch = -1;
    }
  }

  // The patch of each inner face, else -1. Inner faces are connected to the seed by faces whose neighbours are all in
  // the same patch.
  std::vector<int> within(const std::vector<Centre>& centres) const {
    const std::vector<int>& patch = patches_.ofFace;
    std::vector<int> result(faceCount_, -1), queue;
    for (const Centre& centre : centres) {
      result[centre.seed] = patch[centre.seed];
      queue.push_back(centre.seed);
    }
    const auto isInside = [&](int f) {
      const std::span<const int> neighbours = in_.graph.of(f);
      return std::all_of(neighbours.begin(), neighbours.end(), [&](int g) { return patch[g] == patch[f]; });
    };
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (const int f : in_.graph.of(queue[i]))
        if (result[f] < 0 && patch[f] == patch[queue[i]] && isInside(f)) {
          result[f] = patch[f];
          queue.push_back(f);
        }
    return result;
  }

  // Floods all patches at once from their present faces, the cheapest face first, so they stay connected.
  void grow(const FractionReport& onProgress) {
    struct Claim {
      double cost;
      int face, patch;
      bool operator<(const Claim& o) const {  // reversed, because the priority queue serves the greatest claim
        if (cost != o.cost) return cost > o.cost;
        return face != o.face ? face > o.face : patch > o.patch;
      }
    };
    std::priority_queue<Claim> queue;
    const auto claim = [&](int g, int patch) {
      GrowingFace& face = growing_[g];
      if (face.patch >= 0 || face.claimant == patch) return;
      const double c = cost(g, centres_[patch]);
      if (c > face.cheapest || (c == face.cheapest && face.claimant < patch)) return;
      face.cheapest = c;
      face.claimant = patch;
      queue.push({c, g, patch});
    };
    const auto claimNeighbours = [&](int f, int patch) {
      const int(&neighbour)[3] = growing_[f].neighbour;
      if (neighbour[0] == GrowingFace::manyNeighbours) {
        for (const int g : in_.graph.of(f)) claim(g, patch);
        return;
      }
      for (const int g : neighbour)
        if (g >= 0) claim(g, patch);
    };
    for (int f = 0; f < faceCount_; ++f)
      if (growing_[f].patch >= 0) claimNeighbours(f, growing_[f].patch);
    // The number of claims cannot exceed the number of faces.
    inBlocks(onProgress, static_cast<std::size_t>(faceCount_), [&](std::size_t claimed, std::size_t end) {
      while (claimed < end && !queue.empty()) {
        const Claim next = queue.top();
        queue.pop();
        if (growing_[next.face].patch >= 0) continue;
        ++claimed;
        growing_[next.face].patch = next.patch;
        claimNeighbours(next.face, next.patch);
      }
    });
    for (int f = 0; f < faceCount_; ++f) patches_.ofFace[f] = growing_[f].patch;
  }

  // Moves each centre to its patch's means, and seeds it with the face closest to them.
  void recentre(const FractionReport& onProgress) {
    const int count = static_cast<int>(centres_.size());
    const auto keys = static_cast<std::size_t>(in_.comparedPoses);
    std::vector<Vec3> position(count, Vec3::Zero());
    std::vector<double> area(count, 0);
    std::vector<RotationMean> mean(count * keys);
    eachFace(partOf(onProgress, 0, 0.5), [&](int f, int k) {
      area[k] += in_.area[f];
      position[k] += in_.area[f] * in_.centroid[f];
      for (std::size_t j = 0; j < keys; ++j) mean[k * keys + j].add(in_.rotations.of(f)[j], in_.area[f]);
    });
    for (int k = 0; k < count; ++k) {
      centres_[k].position = position[k] / area[k];
      for (std::size_t j = 0; j < keys; ++j) centres_[k].rotation[j] = mean[k * keys + j].mean();
    }
    std::vector<double> best(count, std::numeric_limits<double>::infinity());
    eachFace(partOf(onProgress, 0.5, 1), [&](int f, int k) {
      const double c = cost(f, centres_[k]);
      if (c < best[k]) {
        best[k] = c;
        centres_[k].seed = f;
      }
    });
  }

  // Numbers patches by their first faces. The order of the seeds is arbitrary, and trees in the graph of patches depend
  // on numbers.
  void numberByFaces() {
    std::vector<int> number(patches_.count, -1), componentOf;
    eachFace({}, [&](int, int k) {
      if (number[k] >= 0) return;
      number[k] = static_cast<int>(componentOf.size());
      componentOf.push_back(patches_.componentOf[k]);
    });
    assert(static_cast<int>(componentOf.size()) == patches_.count);
    for (int& k : patches_.ofFace)
      if (k >= 0) k = number[k];
    patches_.componentOf = std::move(componentOf);
  }

  void collectPairs() {
    std::vector<std::pair<int, int>> links;
    eachFace({}, [&](int f, int a) {
      for (int g : in_.graph.of(f))
        if (a < patches_.ofFace[g]) links.emplace_back(a, patches_.ofFace[g]);
    });
    std::sort(links.begin(), links.end());
    for (std::size_t i = 0, j; i < links.size(); i = j) {
      for (j = i + 1; j < links.size() && links[j] == links[i]; ++j) {
      }
      patches_.pairs.push_back({links[i].first, links[i].second, static_cast<int>(j - i)});
    }
  }

  const PatchInput& in_;
  const FractionReport& onProgress_;
  int faceCount_;
  std::vector<Centre> centres_;
  std::vector<GrowingFace> growing_;
  Patches patches_;
};

}  // namespace

int defaultPatchCount(int faceCount) { return std::max(1, static_cast<int>(std::lround(std::sqrt(faceCount)))); }

Patches partitionFaces(const PatchInput& input, int wanted, const FractionReport& onProgress) {
  const int faces = static_cast<int>(input.area.size());
  if (faces < largeFaceCount || wanted > faces / (clusterSize * minClusters)) {
    Partition partition(input, onProgress);
    partition.find(wanted, candidatesPerSeed);
    return partition.take();
  }
  const FaceClusters clusters = clusterFaces(input, clusterSize, partOf(onProgress, 0, 0.2));
  const PatchInput coarseInput{clusters.graph,    clusters.components, clusters.area,
                               clusters.centroid, clusters.rotations,  input.comparedPoses};
  const FractionReport coarseProgress = partOf(onProgress, 0.2, 0.6), fineProgress = partOf(onProgress, 0.6, 1);
  Partition coarse(coarseInput, coarseProgress), fine(input, fineProgress);
  coarse.find(wanted, candidateClustersPerSeed);
  fine.refine(coarse, clusters);
  return fine.take();
}

}  // namespace shapespline
