// Finds the points where parts of a shape are closest in all poses at once.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "core/base/compressed_rows.h"
#include "core/base/types.h"

namespace shapespline {

/// Two vertices and the square of their largest distance over the poses.
struct Contact {
  double distance = std::numeric_limits<double>::infinity();
  int from = -1, to = -1;
};

/// Finds contacts with vertices of other parts. Uses a tree of boxes in several poses, with parts above their vertices,
/// so searches skip whole parts. The poses must outlive it. Deterministic: ties go to the lower vertex.
class ContactSearch {
 public:
  /// partOf: part of each vertex in [0, parts), or -1 to exclude the vertex.
  ContactSearch(std::span<const Positions* const> poses, const std::vector<int>& partOf, int parts);

  /// For each subtree, the common label of all its parts, or -1. labelOfPart: not negative.
  std::vector<int> sharedLabels(std::span<const int> labelOfPart) const;

  /// Updates `best` if `from` has a nearer contact with a vertex whose label is not `own`. Candidates are the nearest
  /// vertices in single poses. lastFound: results of earlier calls for the same label, as starting guesses; initially
  /// empty.
  void nearestOther(int from, const std::vector<int>& sharedLabels, int own, Contact& best,
                    std::vector<int>& lastFound) const;

  /// Updates `lowest` with the lowest vertex of another label that is nearer to `from` than `within` (a square) in all
  /// poses. -1 stands for none.
  void lowestOther(int from, const std::vector<int>& sharedLabels, int own, double within, int& lowest) const {
    lowestOther(root(), from, sharedLabels, own, within, lowest);
  }

 private:
  using Box = Eigen::AlignedBox3d;

  // A leaf has a range of one part's vertices. An inner node has two halves with lower indices.
  struct Subtree {
    int first = 0, last = 0;
    int lower = -1, upper = -1;
    int part = -1;  // the only part inside, or -1
  };
  // The nearest vertex found so far in one pose.
  struct Nearest {
    std::size_t pose;
    Vec3 from;
    int own;
    double squared;
    int vertex = -1;

    void compare(int other, const Positions& positions) {
      const double distance = (positions[other] - from).squaredNorm();
      if (distance < squared || (distance == squared && other < vertex)) {
        squared = distance;
        vertex = other;
      }
    }
  };

  int addParts(std::span<int> parts, const CompressedRows<int>& verticesOf, const Positions& centre, int axis);
  int addVertices(int part, int first, int last, int axis);
  int add(const Subtree& subtree);
  int root() const { return static_cast<int>(subtrees_.size()) - 1; }
  const Box& boxOf(int subtree, std::size_t pose) const {
    return boxes_[searched_.size() * static_cast<std::size_t>(subtree) + pose];
  }

  void search(int subtree, const std::vector<int>& sharedLabels, Nearest& nearest) const;
  void lowestOther(int subtree, int from, const std::vector<int>& sharedLabels, int own, double within,
                   int& lowest) const;
  bool isWithin(int subtree, int from, double within) const;
  double distance(int a, int b) const;

  std::span<const Positions* const> poses_;
  std::vector<const Positions*> searched_;
  std::vector<int> vertices_;
  std::vector<Subtree> subtrees_;
  std::vector<Box> boxes_;  // boxes of each subtree, one per searched pose
};

/// At most `limit` evenly spread items.
std::vector<int> spreadSample(const std::vector<int>& items, int limit);

}  // namespace shapespline
