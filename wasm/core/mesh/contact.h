// Where parts of a shape are nearest to each other, in all its poses at once.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "core/base/compressed_rows.h"
#include "core/base/types.h"

namespace shapespline {

/// Two vertices, and the square of the largest of their distances over the poses.
struct Contact {
  double distance = std::numeric_limits<double>::infinity();
  int from = -1, to = -1;
};

/// Finds contacts with the vertices of parts, by a tree of boxes in several poses: whole parts first, and under each of
/// them its vertices, so no search wades through what is near and of the same part. The poses must outlive it.
/// Deterministic: equal distances go to the lower vertex.
class ContactSearch {
 public:
  /// partOf: of each vertex, in [0, parts), or -1 where it is not to be found.
  ContactSearch(std::span<const Positions* const> poses, const std::vector<int>& partOf, int parts);

  /// Of each subtree the label that all of its parts share, or -1. labelOfPart: none of them negative.
  std::vector<int> sharedLabels(std::span<const int> labelOfPart) const;

  /// Puts a contact of `from` with a vertex of another label than `own` into `best` where it is nearer: with one that
  /// is the nearest in some pose. lastFound: by calls before for the same label, most likely near; empty at first.
  void nearestOther(int from, const std::vector<int>& sharedLabels, int own, Contact& best,
                    std::vector<int>& lastFound) const;

  /// Of the vertices of another label that are nearer to `from` than `within` (a square) in all poses the lowest, if it
  /// is below `lowest`, which else stays; -1 stands for none.
  void lowestOther(int from, const std::vector<int>& sharedLabels, int own, double within, int& lowest) const {
    lowestOther(root(), from, sharedLabels, own, within, lowest);
  }

 private:
  using Box = Eigen::AlignedBox3d;

  // A leaf has a range of one part's vertices, anything else two halves, which come before it.
  struct Subtree {
    int first = 0, last = 0;
    int lower = -1, upper = -1;
    int part = -1;  // where it holds no other
  };
  // The nearest vertex so far in one pose.
  struct Nearest {
    std::size_t pose;
    Vec3 from;
    int own;
    double squared;
    int vertex = -1;

    void compare(int other, const Positions& positions) {
      const double distance = (positions[other] - from).squaredNorm();
      if (distance < squared || (distance == squared && other < vertex)) squared = distance, vertex = other;
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
  std::vector<Box> boxes_;  // of each subtree, one for each searched pose
};

/// At most `limit` of the items, evenly spread.
std::vector<int> spreadSample(const std::vector<int>& items, int limit);

}  // namespace shapespline
