#include "core/patches/patch_coordinates.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/patches/central_key.h"
#include "core/patches/turn_branches.h"
#include "core/rotation/turn_choice.h"

namespace shapespline {

namespace {

std::vector<Quaternion> turnsOf(const std::vector<Quaternion>& from, const std::vector<Quaternion>& to) {
  std::vector<Quaternion> turns;
  for (std::size_t k = 0; k < from.size(); ++k) turns.push_back(to[k] * from[k].conjugate());
  return turns;
}

class PatchEncoder {
 public:
  PatchEncoder(const WeldedShape& shape, const ShapeTopology& topology) : shape_(shape), topology_(topology) {
    out_.origin = centralKey(shape, topology);
  }

  Result<PatchCoordinates> run(int wantedPatches, const FractionReport& onProgress) {
    partition(wantedPatches, onProgress);
    makeReferenceUnrotated();
    encodePairs();
    if (Status status = encodeConnections(shape_, collectLinks(), std::move(area_), out_); !status)
      return status.error();
    return std::move(out_);
  }

 private:
  void partition(int wantedPatches, const FractionReport& onProgress) {
    const int m = shape_.faceCount();
    std::vector<int> columns;  // columns with computed rotations; the origin has none
    for (int c = 0; c < shape_.columns(); ++c)
      if (c != out_.origin && !shape_.repeatsFirst(c)) columns.push_back(c);
    const int compared = static_cast<int>(columns.size());  // the last key of a loop repeats the first
    if (shape_.closing) columns.push_back(shape_.keys - 1);
    std::vector<double> area(m, 0);
    Positions centroid(m, Vec3::Zero());
    FaceRotations rotations(m, static_cast<int>(columns.size()));
    const auto measure = [&](int f) {
      const FaceFrame frame = frameIn(shape_, f, out_.origin);
      area[f] = topology_.whole(f) * frame.area;
      centroid[f] = centroidOf(shape_.poses[out_.origin], shape_.faces[f]);
      Quaternion* rotation = rotations.of(f);
      for (const int c : columns) *rotation++ = Quaternion(deformationOf(shape_, f, frame, c).rotation);
    };
    topology_.eachUsedFace(measure, partOf(onProgress, 0, 0.3));
    const int used = topology_.usedFaces();
    const int wanted = wantedPatches > 0 ? std::min(wantedPatches, used) : defaultPatchCount(used);
    out_.patches = partitionFaces({topology_.graph, topology_.components, area, centroid, rotations, compared}, wanted,
                                  partOf(onProgress, 0.3, 0.9));
    area_.assign(out_.patches.count, 0);
    topology_.eachUsedFace([&](int f) { area_[out_.patches.ofFace[f]] += area[f]; });
    averageRotations(area, rotations, columns, partOf(onProgress, 0.9, 1));
    findSenses(area, rotations, columns);
    for (int f = 0; f < m; ++f)
      if (topology_.anchor[f] >= 0) out_.patches.ofFace[f] = out_.patches.ofFace[topology_.anchor[f]];
    out_.faceArea = std::move(area);
  }

  // G_k: the projection to SO(3) of the area-weighted mean of R_f over the patch.
  void averageRotations(const std::vector<double>& area, const FaceRotations& rotations,
                        const std::vector<int>& columns, const FractionReport& onProgress) {
    std::vector<RotationMean> mean(columns.size() * out_.patches.count);
    const auto add = [&](int f) {
      RotationMean* sum = &mean[columns.size() * out_.patches.ofFace[f]];
      for (std::size_t i = 0; i < columns.size(); ++i) sum[i].add(rotations.of(f)[i], area[f]);
    };
    topology_.eachUsedFace(add, onProgress);
    out_.rotation.assign(shape_.columns(), std::vector<Quaternion>(out_.patches.count, Quaternion::Identity()));
    for (std::size_t i = 0; i < columns.size(); ++i)
      for (int k = 0; k < out_.patches.count; ++k) out_.rotation[columns[i]][k] = mean[columns.size() * k + i].mean();
  }

  // Rotates each frame by a constant, so it does not rotate in the reference pose.
  void makeReferenceUnrotated() {
    if (shape_.reference == out_.origin) return;
    const std::vector<Quaternion> reference = out_.rotation[shape_.reference];
    for (std::vector<Quaternion>& column : out_.rotation)
      for (std::size_t k = 0; k < column.size(); ++k) column[k] = (column[k] * reference[k].conjugate()).normalized();
    for (Quaternion& q : out_.rotation[shape_.reference]) q.setIdentity();
  }

  // Finds senses for faces, independent of the patches. A patch takes the sense of most of its area.
  void findSenses(const std::vector<double>& area, const FaceRotations& rotations, const std::vector<int>& columns) {
    std::vector<TurnJoint> joints;
    topology_.eachUsedFace([&](int f) {
      for (const int g : topology_.graph.of(f))
        if (f < g) joints.push_back({f, g, std::sqrt(std::min(area[f], area[g]))});
    });
    std::vector<int> indexOf(shape_.columns(), -1);  // -1: no rotation
    for (std::size_t i = 0; i < columns.size(); ++i) indexOf[columns[i]] = static_cast<int>(i);
    const auto rotationOf = [&](int f, int column) {
      return indexOf[column] < 0 ? Quaternion::Identity() : rotations.of(f)[indexOf[column]];
    };
    std::vector<Quaternion> turn(shape_.faceCount(), Quaternion::Identity());
    out_.turn.resize(KeySteps{shape_.keys}.count());
    out_.openTurns.resize(out_.turn.size());
    for (int s = 0; s < static_cast<int>(out_.turn.size()); ++s) {
      const auto [from, to] = posesOf(shape_, s);
      if (from < 0 || s == KeySteps{shape_.keys}.turnedClosing()) continue;
      topology_.eachUsedFace([&](int f) { turn[f] = rotationOf(f, to) * rotationOf(f, from).conjugate(); });
      out_.openTurns[s] = chooseTurnSenses(joints, area, turn);
      for (OpenTurn& open : out_.openTurns[s]) open.part = out_.patches.ofFace[open.part];
      out_.turn[s] = turnsOf(out_.rotation[from], out_.rotation[to]);
      std::vector<double> agreement(out_.patches.count, 0);
      topology_.eachUsedFace([&](int f) {
        const int k = out_.patches.ofFace[f];
        agreement[k] += area[f] * turn[f].dot(out_.turn[s][k]);
      });
      for (int k = 0; k < out_.patches.count; ++k)
        if (agreement[k] < 0) out_.turn[s][k].coeffs() *= -1;
    }
  }

  // Logarithms for the metric (space/gram_matrix.h): the representatives nearest to the previous pose.
  void encodePairs() {
    for (int c = 0; c < shape_.columns(); ++c) {
      std::vector<Vec3> column;
      for (const PatchPair& p : out_.patches.pairs) {
        const auto& g = out_.rotation[c];
        const Vec3 x = logRotation(Quaternion(g[p.first].conjugate() * g[p.second]));
        column.push_back(c > 0 ? nearestRepresentative(x, out_.pair[shape_.before(c)][column.size()]) : x);
      }
      out_.pair.push_back(std::move(column));
    }
  }

  std::vector<PatchLink> collectLinks() {
    std::vector<PatchLink> links;
    for (const PatchPair& p : out_.patches.pairs) links.push_back({p.first, p.second, p.sharedEdges});
    for (const int component : topology_.tree.order) {
      const ComponentLink& link = topology_.tree.link[component];
      if (link.parent < 0) continue;
      links.push_back({out_.patches.ofFace[link.anchorFace], out_.patches.ofFace[link.contactFace], 0});
      out_.bridgedComponent.push_back(component);
    }
    return links;
  }

  const WeldedShape& shape_;
  const ShapeTopology& topology_;
  std::vector<double> area_;  // area of each patch in the origin
  PatchCoordinates out_;
};

class ConnectionEncoder {
 public:
  ConnectionEncoder(const WeldedShape& shape, PatchCoordinates& out) : shape_(shape), steps_{shape.keys}, out_(out) {}

  Status run(std::vector<PatchLink> links, std::vector<double> area) {
    out_.graph = PatchGraph(std::move(links), std::move(area));
    orient();
    for (int c = 0; c < shape_.columns(); ++c) {
      std::vector<Quaternion> column;
      for (const PatchLink& link : out_.graph.links()) column.push_back(connection(c, link));
      out_.connection.key.push_back(std::move(column));
    }
    out_.connection.increment.resize(steps_.count());
    out_.residual.resize(steps_.count());
    out_.turn.resize(steps_.count());
    out_.openTurns.resize(steps_.count());
    for (int s = 0; s < steps_.count(); ++s) {
      const auto [from, to] = posesOf(shape_, s);
      if (from < 0 || s == steps_.turnedClosing()) continue;
      if (out_.turn[s].empty()) findSenses(s, from, to);
      auto chosen = chooseTurnBranches(out_.graph, out_.connection.key[from], out_.connection.key[to], out_.turn[s]);
      if (!chosen) return chosen.error();
      out_.connection.increment[s] = std::move(chosen->increment);
      out_.residual[s] = std::move(chosen->residual);
    }
    chooseBridgeTurns();
    joinSenses();
    if (shape_.closing) closeOnLastKey();
    out_.connection.finish(steps_);
    return {};
  }

 private:
  Quaternion connection(int column, const PatchLink& link) const {
    return (out_.rotation[column][link.from].conjugate() * out_.rotation[column][link.to]).normalized();
  }

  // For input with patches only.
  void findSenses(int step, int from, int to) {
    std::vector<TurnJoint> joints;
    for (const PatchLink& link : out_.graph.links())
      if (link.sharedEdges > 0) joints.push_back({link.from, link.to, static_cast<double>(link.sharedEdges)});
    out_.turn[step] = turnsOf(out_.rotation[from], out_.rotation[to]);
    out_.openTurns[step] = chooseTurnSenses(joints, out_.graph.area(), out_.turn[step]);
  }

  // The cumulative form is not symmetric in the two patches. Links therefore lead away from the middle of the shape,
  // regardless of patch numbers.
  void orient() {
    std::vector<double> cost;
    for (const PatchLink& link : out_.graph.links()) {
      double squares = 0, sixths = 0;
      for (int s = 0; s <= steps_.closing(); ++s) {
        const auto [from, to] = posesOf(shape_, s);
        const double angle = connection(from, link).angularDistance(connection(to, link));
        squares += angle * angle;
        sixths += std::pow(angle / 2, 6);
      }
      cost.push_back(0.1 + std::sqrt(squares) + 3 * sixths);
    }
    out_.graph.orient(out_.graph.centreTree(cost));
  }

  // A component that rotates by almost half a turn takes the direction with the least bending. The closing step follows
  // the other steps, because an open motion does not take it.
  void chooseBridgeTurns() {
    auto& increment = out_.connection.increment;
    for (std::size_t l = out_.patches.pairs.size(); l < out_.graph.links().size(); ++l) {
      std::vector<TurnOptions> options;
      for (int s = 0; s < steps_.closing(); ++s) options.push_back(turnOptions(increment[s][l]));
      const std::vector<char> other = chooseTurns(options);
      for (int s = 0; s < steps_.closing(); ++s)
        if (other[s]) increment[s][l] = options[s].other;
      Vec3& closing = increment[steps_.closing()][l];
      TurnOptions last = turnOptions(increment[steps_.closing() - 1][l]), first = turnOptions(increment[0][l]);
      last.isOpen = first.isOpen = false;
      const TurnOptions between = turnOptions(closing);
      if (chooseTurns({last, between, first})[1]) closing = between.other;
    }
  }

  // The senses of a component follow its bridge. Parents come before their children.
  void joinSenses() {
    const std::size_t first = out_.patches.pairs.size();
    for (int s = 0; s < steps_.count(); ++s) {
      std::vector<Quaternion>& turn = out_.turn[s];
      for (std::size_t b = 0; b < out_.bridgedComponent.size() && !turn.empty(); ++b) {
        const auto [from, to, edges] = out_.graph.links()[first + b];
        const bool exceedsHalfTurn = out_.connection.increment[s][first + b].norm() > std::numbers::pi;
        if ((turn[from].dot(turn[to]) < 0) == exceedsHalfTurn) continue;
        for (std::size_t k = 0; k < turn.size(); ++k)
          if (out_.patches.componentOf[k] == out_.bridgedComponent[b]) turn[k].coeffs() *= -1;
      }
    }
  }

  // The step to a last key that repeats the first has the same direction as the step to the last key.
  void closeOnLastKey() {
    const auto [from, to] = posesOf(shape_, steps_.turnedClosing());
    const auto& key = out_.connection.key;
    const std::vector<Vec3>& alike = out_.connection.increment[shape_.keys - 2];
    std::vector<Vec3> closing;
    for (std::size_t l = 0; l < alike.size(); ++l)
      closing.push_back(
          nearestRepresentative(logRotation(Quaternion(key[from][l].conjugate() * key[to][l])), alike[l]));
    out_.connection.increment[steps_.turnedClosing()] = std::move(closing);
  }

  const WeldedShape& shape_;
  KeySteps steps_;
  PatchCoordinates& out_;
};

}  // namespace

StepPoses posesOf(const WeldedShape& shape, int step) {
  const KeySteps steps{shape.keys};
  if (step == steps.closing()) return {shape.keys - 1, 0};
  if (step == steps.turnedClosing()) return shape.closing ? StepPoses{shape.keys - 2, 0} : StepPoses{-1, -1};
  if (step == steps.startTangent())
    return shape.startTangent >= 0 ? StepPoses{0, shape.startTangent} : StepPoses{-1, -1};
  if (step == steps.endTangent())
    return shape.endTangent >= 0 ? StepPoses{shape.keys - 1, shape.endTangent} : StepPoses{-1, -1};
  return {step, step + 1};
}

Status encodeConnections(const WeldedShape& shape, std::vector<PatchLink> links, std::vector<double> area,
                         PatchCoordinates& patches) {
  return ConnectionEncoder(shape, patches).run(std::move(links), std::move(area));
}

Result<PatchCoordinates> encodePatches(const WeldedShape& shape, const ShapeTopology& topology, int wantedPatches,
                                       const FractionReport& onProgress) {
  return PatchEncoder(shape, topology).run(wantedPatches, onProgress);
}

}  // namespace shapespline
