#include "core/mesh/contact.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

namespace shapespline {

namespace {

// The search uses at most this number of poses. Distances are measured in all poses.
constexpr int searchedPoses = 4;
constexpr int leafSize = 8;

std::vector<int> evenlyChosen(int count, int wanted) {
  std::vector<int> chosen;
  const int take = std::min(count, wanted);
  for (int i = 0; i < take; ++i) chosen.push_back(take == 1 ? 0 : i * (count - 1) / (take - 1));
  return chosen;
}

// Moves the lower half of the items along an axis to the front. Returns the start of the upper half.
int divide(std::span<int> items, const Positions& position, int axis) {
  const auto middle = static_cast<std::ptrdiff_t>(items.size() / 2);
  std::nth_element(items.begin(), items.begin() + middle, items.end(), [&](int a, int b) {
    const double x = position[a][axis], y = position[b][axis];
    return x != y ? x < y : a < b;
  });
  return static_cast<int>(middle);
}

}  // namespace

ContactSearch::ContactSearch(std::span<const Positions* const> poses, const std::vector<int>& partOf, int parts)
    : poses_(poses) {
  for (int pose : evenlyChosen(static_cast<int>(poses.size()), searchedPoses)) searched_.push_back(poses[pose]);
  const auto verticesOf = compressedRows<int>(parts, [&](auto addItem) {
    for (int v = 0; v < static_cast<int>(partOf.size()); ++v)
      if (partOf[v] >= 0) addItem(partOf[v], v);
  });
  vertices_.reserve(verticesOf.item.size());
  Positions centre;
  for (int p = 0; p < parts; ++p) {
    Box box;
    for (int v : verticesOf.of(p)) box.extend((*searched_[0])[v]);
    centre.push_back(box.center());
  }
  std::vector<int> all(parts);
  std::iota(all.begin(), all.end(), 0);
  addParts(all, verticesOf, centre, 0);
}

int ContactSearch::addParts(std::span<int> parts, const CompressedRows<int>& verticesOf, const Positions& centre,
                            int axis) {
  if (parts.size() == 1) {
    const std::span<const int> vertices = verticesOf.of(parts[0]);
    const int first = static_cast<int>(vertices_.size());
    vertices_.insert(vertices_.end(), vertices.begin(), vertices.end());
    return addVertices(parts[0], first, static_cast<int>(vertices_.size()), axis);
  }
  const int middle = divide(parts, centre, axis);
  const int lower = addParts(parts.first(middle), verticesOf, centre, (axis + 1) % 3);
  const int upper = addParts(parts.subspan(middle), verticesOf, centre, (axis + 1) % 3);
  return add({0, 0, lower, upper, -1});
}

int ContactSearch::addVertices(int part, int first, int last, int axis) {
  if (last - first <= leafSize) return add({first, last, -1, -1, part});
  const std::span<int> range(vertices_.data() + first, static_cast<std::size_t>(last - first));
  const int middle = first + divide(range, *searched_[0], axis);
  const int lower = addVertices(part, first, middle, (axis + 1) % 3);
  const int upper = addVertices(part, middle, last, (axis + 1) % 3);
  return add({0, 0, lower, upper, part});
}

int ContactSearch::add(const Subtree& subtree) {
  for (std::size_t k = 0; k < searched_.size(); ++k) {
    Box box;
    for (int i = subtree.first; i < subtree.last; ++i) box.extend((*searched_[k])[vertices_[i]]);
    for (const int half : {subtree.lower, subtree.upper})
      if (half >= 0) box.extend(boxOf(half, k));
    boxes_.push_back(box);
  }
  subtrees_.push_back(subtree);
  return root();
}

std::vector<int> ContactSearch::sharedLabels(std::span<const int> labelOfPart) const {
  std::vector<int> labels;
  labels.reserve(subtrees_.size());
  for (const Subtree& s : subtrees_) {
    if (s.part >= 0) labels.push_back(labelOfPart[s.part]);
    else labels.push_back(labels[s.lower] == labels[s.upper] ? labels[s.lower] : -1);
  }
  return labels;
}

void ContactSearch::nearestOther(int from, const std::vector<int>& sharedLabels, int own, Contact& best,
                                 std::vector<int>& lastFound) const {
  lastFound.resize(searched_.size(), -1);
  for (std::size_t k = 0; k < searched_.size(); ++k) {
    Nearest nearest{k, (*searched_[k])[from], own, best.distance};
    if (lastFound[k] >= 0) nearest.compare(lastFound[k], *searched_[k]);
    search(root(), sharedLabels, nearest);
    if (nearest.vertex < 0) return;  // if no vertex is nearer in one pose, none is nearer in all
    lastFound[k] = nearest.vertex;
    if (const double d = distance(from, nearest.vertex); d < best.distance) best = {d, from, nearest.vertex};
  }
}

void ContactSearch::search(int subtree, const std::vector<int>& sharedLabels, Nearest& nearest) const {
  if (sharedLabels[subtree] == nearest.own) return;
  const Subtree& s = subtrees_[subtree];
  for (int i = s.first; i < s.last; ++i) nearest.compare(vertices_[i], *searched_[nearest.pose]);
  if (s.lower < 0) return;
  const auto distanceTo = [&](int half) { return boxOf(half, nearest.pose).squaredExteriorDistance(nearest.from); };
  std::pair near(distanceTo(s.lower), s.lower), far(distanceTo(s.upper), s.upper);
  if (far < near) std::swap(near, far);
  if (near.first <= nearest.squared) search(near.second, sharedLabels, nearest);
  if (far.first <= nearest.squared) search(far.second, sharedLabels, nearest);
}

void ContactSearch::lowestOther(int subtree, int from, const std::vector<int>& sharedLabels, int own, double within,
                                int& lowest) const {
  if (sharedLabels[subtree] == own || !isWithin(subtree, from, within)) return;
  const Subtree& s = subtrees_[subtree];
  for (int i = s.first; i < s.last; ++i) {
    const int v = vertices_[i];
    if ((lowest < 0 || v < lowest) && distance(from, v) < within) lowest = v;
  }
  if (s.lower < 0) return;
  lowestOther(s.lower, from, sharedLabels, own, within, lowest);
  lowestOther(s.upper, from, sharedLabels, own, within, lowest);
}

bool ContactSearch::isWithin(int subtree, int from, double within) const {
  for (std::size_t k = 0; k < searched_.size(); ++k)
    if (boxOf(subtree, k).squaredExteriorDistance((*searched_[k])[from]) > within) return false;
  return true;
}

double ContactSearch::distance(int a, int b) const {
  double largest = 0;
  for (const Positions* p : poses_) largest = std::max(largest, ((*p)[a] - (*p)[b]).squaredNorm());
  return largest;
}

std::vector<int> spreadSample(const std::vector<int>& items, int limit) {
  const auto size = static_cast<std::int64_t>(items.size());
  if (size <= limit) return items;
  std::vector<int> kept(limit);
  for (int i = 0; i < limit; ++i) kept[i] = items[i * size / limit];
  return kept;
}

}  // namespace shapespline
