#include "core/patches/patch_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

namespace shapespline {

namespace {

// Steps of a frame. Halfway, the cross-sections of a bar twisted by two turns are 1.9 % off with one step and 1 % with
// two. If maps disagree strongly, a second step would move towards minima that disappear over time. It therefore
// moves only links that nearly agree.
constexpr std::array frameSteps = {1, 16};
// Shorter rotation vectors have no usable axis.
constexpr double noAxis = 1e-6;
// Parts with smaller rotations may be at rest, with an axis determined by noise.
constexpr double atRest = 0.01;
// A root with a smaller rotation does not take the other direction.
constexpr double surelyShort = 0.5;
// A bend is the squared change of a rotation from step to step. The smallest bend above rounding, in radians squared;
// and the share of the mean bend below which a rotation counts as even.
constexpr double minBend = 1e-6, minShare = 0.3;
// The shares of a step at which paths are compared.
constexpr std::array<double, 3> shares = {0.25, 0.5, 0.75};

// The chosen direction as the only option.
TurnOptions chosen(const TurnOptions& o, bool other) {
  return other ? TurnOptions{o.other, o.other, o.otherCost, o.otherCost, false}
               : TurnOptions{o.turn, o.turn, o.cost, o.cost, false};
}

// Axis times angle, up to a full turn. Uses -q for the other direction.
Vec3 rotationVector(const Quaternion& q, bool flipped) {
  const double sign = flipped ? -1 : 1, sine = q.vec().norm();
  return sine < noAxis / 2 ? Vec3(Vec3::Zero()) : Vec3(sign * 2 * std::atan2(sine, sign * q.w()) / sine * q.vec());
}

// The axis with the largest moment of inertia of a set of points: that of a wheel.
Vec3 wheelAxis(const Positions& positions, const std::vector<Triangle>& faces, const std::vector<char>& ofPart) {
  Vec3 mean = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  double count = 0;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int v : faces[f])
      if (ofPart[f]) {
        mean += positions[v];
        second += positions[v] * positions[v].transpose();
        count += 1;
      }
  const Mat3 covariance = second / count - mean / count * (mean / count).transpose();
  return Eigen::SelfAdjointEigenSolver<Mat3>(covariance).eigenvectors().col(0);  // the flat direction
}

}  // namespace

Result<PatchMotion> PatchMotion::create(const WeldedShape& shape, PatchCoordinates coordinates) {
  PatchMotion motion(shape, std::move(coordinates));
  const std::vector<int> open = motion.stepsOf(shape, false), loop = motion.stepsOf(shape, true);
  for (const auto& [solver, steps] : {std::pair(&motion.open_, &open), std::pair(&motion.loop_, &loop)}) {
    Result<Solver> made = motion.makeSolver(*steps);
    if (!made) return made.error();
    *solver = std::move(*made);
  }
  motion.findOwnPaths(open);
  motion.open_->alignment = motion.makeAlignment(*motion.open_, open);
  motion.loop_->alignment = motion.makeAlignment(*motion.loop_, loop);
  motion.findAxes();
  return motion;
}

PatchMotion::PatchMotion(const WeldedShape& shape, PatchCoordinates coordinates)
    : steps_{shape.keys}, closing_(shape.closing), patches_(std::move(coordinates)) {
  for (int s = 0; s < steps_.count(); ++s) posesOf_.push_back(posesOf(shape, s));
  own_.key = patches_.rotation;
  own_.increment.resize(steps_.count());
  isOpen_.assign(steps_.count(), 0);
}

void PatchMotion::findOwnPaths(const std::vector<int>& open) {
  std::vector<OwnTurns> keys;
  for (const int s : open) {
    OwnTurns turns = ownTurns(*open_, s);
    if (s < steps_.closing()) keys.push_back(std::move(turns));
    else take(s, turns, chooseTurns({turns.options})[0] != 0);
  }
  std::vector<TurnOptions> options;
  for (const OwnTurns& turns : keys) options.push_back(turns.options);
  const std::vector<char> other = chooseTurns(options);
  for (int s = 0; s < steps_.closing(); ++s) take(s, keys[s], other[s] != 0);
  const OwnTurns last = ownTurns(*loop_, steps_.closing());
  take(steps_.closing(), last,
       chooseTurns({chosen(options.back(), other.back()), last.options, chosen(options[0], other[0])})[1] != 0);
  if (closing_) closeOwnPaths();
  own_.finish(steps_);
}

void PatchMotion::take(int step, const OwnTurns& turns, bool other) {
  own_.increment[step] = other ? turns.other : turns.first;
  isOpen_[step] = turns.options.isOpen;
}

// Both directions of the whole in a step, the shorter first.
PatchMotion::OwnTurns PatchMotion::ownTurns(const Solver& solver, int step) const {
  const int root = solver.system.tree().root();
  FractionRotations atFraction;
  for (std::size_t i = 0; i < shares.size(); ++i) solveAtFraction(solver, step, shares[i], atFraction[i]);
  const bool flipped = patches_.turn[step][root].w() < 0;
  OwnTurns turns{ownIncrements(solver, step, atFraction, flipped), {}, {}};
  const auto cost = [&](const std::vector<Vec3>& increment) {
    const std::vector<double>& area = patches_.graph.area();
    double sum = 0, total = 0;
    for (std::size_t k = 0; k < area.size(); ++k) {
      sum += area[k] * increment[k].squaredNorm();
      total += area[k];
    }
    return sum / total;
  };
  TurnOptions& o = turns.options;
  o.turn = o.other = meanTurn(step, turns.first);
  o.cost = o.otherCost = cost(turns.first);
  o.isOpen = turns.first[root].norm() > surelyShort;
  if (!o.isOpen) return turns;
  turns.other = ownIncrements(solver, step, atFraction, !flipped);
  o.other = meanTurn(step, turns.other);
  o.otherCost = cost(turns.other);
  if (o.otherCost < o.cost) {
    std::swap(o.cost, o.otherCost);
    std::swap(o.turn, o.other);
    std::swap(turns.first, turns.other);
  }
  const double openCost = std::pow(ambiguousTurn / (twoPi - ambiguousTurn), 2);
  o.isOpen = o.cost > openCost * o.otherCost;
  return turns;
}

// Own paths close in the direction of the step to the last key, like the paths of pairs.
void PatchMotion::closeOwnPaths() {
  const auto [from, to] = posesOf_[steps_.turnedClosing()];
  for (std::size_t k = 0; k < own_.key[0].size(); ++k) {
    const Quaternion turned = closing_->rotation * own_.key[to][k];
    own_.increment[steps_.turnedClosing()].push_back(nearestRepresentative(
        logRotation(Quaternion(own_.key[from][k].conjugate() * turned)), own_.increment[steps_.keys - 2][k]));
  }
}

void PatchMotion::findAxes() {
  for (int s = 0; s < steps_.closing(); ++s) {
    const Vec3 turn = worldTurn(s);
    axis_.push_back(turn.norm() > atRest ? Vec3(turn.normalized()) : Vec3(Vec3::UnitY()));
  }
}

std::vector<int> PatchMotion::stepsOf(const WeldedShape& shape, bool loop) const {
  std::vector<int> result;
  for (int s = 0; s < steps_.closing(); ++s) result.push_back(s);
  if (loop) result.push_back(steps_.closing());
  for (const int s : {steps_.startTangent(), steps_.endTangent()})
    if (!loop && posesOf(shape, s).from >= 0) result.push_back(s);
  return result;
}

// The weight of a link grows linearly with the number of shared edges. Links with large rotations, or whose maps
// disagree with the others, have less weight. For small angles a, the factor ((1 + cos a) / 2)^6 is 1 - O(a^2), so
// smooth shapes hardly change.
Result<PatchMotion::Solver> PatchMotion::makeSolver(const std::vector<int>& steps) const {
  const std::size_t count = patches_.graph.links().size();
  std::vector<double> weight, cost;
  for (std::size_t l = 0; l < count; ++l) {
    double largest = 0, squares = 0, residual = 0;
    for (const int s : steps) {
      const double angle = patches_.connection.increment[s][l].norm();
      largest = std::max(largest, angle);
      squares += angle * angle;
      residual = std::max(residual, patches_.residual[s][l]);
    }
    const double shared = patches_.graph.links()[l].sharedEdges / patches_.graph.meanSharedEdges();
    weight.push_back(1e-4 + std::pow(agreement(largest), 6) * (0.05 + shared) +
                     0.03 * std::pow(agreement(residual), 4));
    cost.push_back(0.1 + std::sqrt(squares) + 4 * residual);
  }
  auto system = PatchRotationSystem::create(patches_.graph, patches_.graph.centreTree(cost), std::move(weight));
  if (!system) return system.error();
  return Solver{std::move(*system), {}};
}

// Rotations at a share of one step from the maps, up to a common rotation.
void PatchMotion::solveAtFraction(const Solver& solver, int step, double share,
                                  std::vector<Quaternion>& rotation) const {
  const int from = posesOf_[step].from;
  std::vector<Quaternion> connection = patches_.connection.key[from];
  for (std::size_t l = 0; l < connection.size(); ++l)
    connection[l] = connection[l] * expQuaternion(share * patches_.connection.increment[step][l]);
  PatchRotationSystem::Scratch scratch;
  solver.system.solve(connection, frameSteps, scratch, rotation);
}

// The same rotations, with the root on its own path.
void PatchMotion::turnAtFraction(const Solver& solver, int step, double share, const Vec3& rootTurn,
                                 std::vector<Quaternion>& rotation) const {
  const int root = solver.system.tree().root();
  const Quaternion wanted = own_.key[posesOf_[step].from][root] * expQuaternion(share * rootTurn);
  const Quaternion turn = wanted * rotation[root].conjugate();
  for (Quaternion& q : rotation) q = (turn * q).normalized();
}

// Neighbours show how many turns a patch made in a step. Among increments that differ by two full turns, the one whose
// path is nearest to the shape's is chosen. (The increment nearest to a neighbour's would lose turns near 360 degrees.)
// The sense decides whether the number of extra full turns is even or odd.
std::vector<Vec3> PatchMotion::ownIncrements(const Solver& solver, int step, const FractionRotations& atFraction,
                                             bool flipped) const {
  const int from = posesOf_[step].from, root = solver.system.tree().root();
  const std::vector<Quaternion>& turn = patches_.turn[step];
  std::vector<Vec3> increment;
  for (std::size_t k = 0; k < turn.size(); ++k)
    increment.push_back(own_.key[from][k].conjugate() * rotationVector(turn[k], flipped));
  FractionRotations rotation = atFraction;
  for (std::size_t i = 0; i < shares.size(); ++i) turnAtFraction(solver, step, shares[i], increment[root], rotation[i]);
  for (std::size_t k = 0; k < increment.size(); ++k) {
    if (static_cast<int>(k) == root || increment[k].norm() < noAxis) continue;
    const Vec3 first = increment[k], turns = first.normalized() * (2 * twoPi);
    double least = std::numeric_limits<double>::infinity();
    for (const int n : {0, -1, 1}) {
      const Vec3 candidate = first + n * turns;
      double distance = 0;
      for (std::size_t i = 0; i < shares.size(); ++i)
        distance +=
            std::pow(rotation[i][k].angularDistance(own_.key[from][k] * expQuaternion(shares[i] * candidate)), 2);
      if (distance < least * (1 - 1e-9) - 1e-12) {
        least = distance;
        increment[k] = candidate;
      }
    }
  }
  return increment;
}

GlobalAlignment PatchMotion::makeAlignment(const Solver& solver, const std::vector<int>& steps) const {
  std::vector<std::vector<Quaternion>> halfway;
  for (const int s : steps) {
    std::vector<Quaternion> x;
    solveAtFraction(solver, s, 0.5, x);
    const int root = solver.system.tree().root();
    turnAtFraction(solver, s, 0.5, own_.increment[s][root], x);
    const int from = posesOf_[s].from;
    for (std::size_t k = 0; k < x.size(); ++k)
      x[k] = own_.key[from][k] * expQuaternion(own_.increment[s][k] / 2) * x[k].conjugate();
    halfway.push_back(std::move(x));
  }
  return GlobalAlignment(halfway, evennessWeights(steps.back() == steps_.closing()));
}

// Weight of each patch for the rotation of the whole shape: its area, increased if it rotates evenly. Splines miss most
// of an uneven rotation, such as that of the end of a limb, which is the sum of the rotations of all its joints.
std::vector<double> PatchMotion::evennessWeights(bool isLoop) const {
  const int last = isLoop ? steps_.closing() : steps_.closing() - 1;
  std::vector<double> weight = patches_.graph.area(), bend;
  double sum = 0, total = 0;
  for (std::size_t k = 0; k < weight.size(); ++k) {
    const auto turn = [&](int s) -> Vec3 { return own_.key[posesOf_[s].from][k] * own_.increment[s][k]; };
    bend.push_back(minBend);
    for (int s = 1; s <= last; ++s) bend[k] += (turn(s) - turn(s - 1)).squaredNorm();
    if (isLoop) bend[k] += (turn(0) - turn(last)).squaredNorm();
    else if (closing_) bend[k] += (closing_->rotation * turn(0) - turn(last)).squaredNorm();
    sum += weight[k] * bend[k];
    total += weight[k];
  }
  for (std::size_t k = 0; k < weight.size(); ++k) weight[k] /= bend[k] * total / sum + minShare;
  return weight;
}

Vec3 PatchMotion::worldTurn(int step) const { return meanTurn(step, own_.increment[step]); }

Vec3 PatchMotion::meanTurn(int step, const std::vector<Vec3>& increment) const {
  const int from = posesOf_[step].from;
  const std::vector<double>& area = patches_.graph.area();
  Vec3 sum = Vec3::Zero();
  double total = 0;
  for (std::size_t k = 0; k < area.size(); ++k) {
    sum += area[k] * (own_.key[from][k] * increment[k]);
    total += area[k];
  }
  return sum / total;
}

// Axis in the reference pose of the attached component: that of its increment, of its first other increment with a
// rotation, or its axle.
Vec3 PatchMotion::turnAxis(const WeldedShape& shape, int step, std::size_t bridge) const {
  const std::size_t link = patches_.patches.pairs.size() + bridge;
  Vec3 axis = patches_.connection.increment[step][link];
  for (int s = 0; s < steps_.closing() && axis.norm() < atRest; ++s) axis = patches_.connection.increment[s][link];
  if (axis.norm() > atRest) return axis.normalized();
  const std::vector<int>& ofFace = patches_.patches.ofFace;
  std::vector<char> ofPart;
  for (const int patch : ofFace)
    ofPart.push_back(patch >= 0 && patches_.patches.componentOf[patch] == patches_.bridgedComponent[bridge]);
  return wheelAxis(shape.poses[shape.reference], shape.faces, ofPart);
}

PatchTurns PatchMotion::addedTurns(const WeldedShape& shape, const std::vector<AddedTurns>& turns) const {
  PatchTurns result;
  result.whole.assign(steps_.count(), 0);
  const auto add = [&](int step, const AddedTurns& t) {
    const auto component = std::find(patches_.bridgedComponent.begin(), patches_.bridgedComponent.end(), t.component);
    if (component == patches_.bridgedComponent.end()) {  // the whole, or the root component
      result.whole[step] += t.turns;
      return;
    }
    const auto bridge = static_cast<std::size_t>(component - patches_.bridgedComponent.begin());
    const Vec3 axis = turnAxis(shape, t.key - 1, bridge);
    result.bridges.push_back({step, patches_.patches.pairs.size() + bridge, t.turns * twoPi * axis});
  };
  for (const AddedTurns& t : turns) {
    add(t.key - 1, t);
    if (closing_ && t.key == steps_.keys - 1) add(steps_.turnedClosing(), t);
  }
  return result;
}

// A full turn of the whole about its own axis, scaled by the step's share: the identity at every key.
Quaternion PatchMotion::addedTurn(const CurvePoint& point, const PatchTurns& turns) const {
  Quaternion turn = Quaternion::Identity();
  for (const StepShare& s : point.steps) {
    if (turns.whole.empty() || turns.whole[s.step] == 0) continue;
    Vec3 axis = axis_[s.step == steps_.turnedClosing() ? steps_.keys - 2 : s.step];
    if (closing_ && !point.closes) axis = closing_->power(s.period).rotation * axis;
    turn = turn * expQuaternion(twoPi * turns.whole[s.step] * s.share * axis);
  }
  return turn;
}

PatchMotion::Disagreement PatchMotion::disagreement(const CurvePoint& point) const {
  Scratch scratch;
  LocalFrames frames;
  at(point, {}, scratch, frames);
  Disagreement result;
  const Quaternion periods = turnOfPeriods(point);
  for (std::size_t k = 0; k < scratch.path.size(); ++k)
    result.ofPatch.push_back((periods * scratch.path[k]).angularDistance(frames.rotation[k]));
  for (std::size_t l = 0; l < scratch.connection.size(); ++l) {
    const auto [from, to, edges] = patches_.graph.links()[l];
    const Quaternion between = frames.rotation[from].conjugate() * frames.rotation[to];
    result.ofLinks = std::max(result.ofLinks, between.angularDistance(scratch.connection[l]));
  }
  return result;
}

std::vector<double> PatchMotion::overshoot(const CurvePoint& point) const {
  std::vector<Vec3> past(own_.increment.front().size(), Vec3::Zero());
  for (const StepShare& s : point.steps) {
    const double outside = s.share - std::clamp(s.share, 0.0, 1.0);
    for (std::size_t k = 0; k < past.size(); ++k) past[k] += outside * own_.increment[s.step][k];
  }
  std::vector<double> angle;
  for (const Vec3& vector : past) angle.push_back(vector.norm());
  return angle;
}

void PatchMotion::at(const CurvePoint& point, const PatchTurns& turns, Scratch& scratch, LocalFrames& frames) const {
  const Solver& solver = point.closes ? *loop_ : *open_;
  patches_.connection.at(point, turns.bridges, scratch.connection);
  solver.system.solve(scratch.connection, frameSteps, scratch.turn, frames.rotation);
  own_.at(point, {}, scratch.path);
  Quaternion turn = solver.alignment.at(scratch.path, frames.rotation);
  turn = addedTurn(point, turns) * turnOfPeriods(point) * turn;
  for (Quaternion& g : frames.rotation) g = (turn * g).normalized();
  frames.gradient.clear();
  frames.part.clear();
  if (point.parts && !point.parts->ofPart.empty()) advanceParts(point, turns, scratch, frames);
}

Quaternion PatchMotion::turnOfPeriods(const CurvePoint& point) const {
  return closing_ && !point.closes ? closing_->power(point.basePeriod).rotation : Quaternion::Identity();
}

// To first order, this equals the rotations from the maps at each part's weights, which differ little from the mean.
void PatchMotion::advanceParts(const CurvePoint& point, const PatchTurns& turns, const Scratch& scratch,
                               LocalFrames& frames) const {
  const PatchParts& patches = *point.parts->patches;
  frames.part = patches.ofPatch;
  const Quaternion back = (addedTurn(point, turns) * turnOfPeriods(point)).conjugate();
  for (std::size_t part = 0; part < point.parts->ofPart.size(); ++part) {
    const CurvePoint& own = point.parts->ofPart[part];
    const Quaternion whole = addedTurn(own, turns) * turnOfPeriods(own);
    for (std::size_t k = 0; k < frames.rotation.size(); ++k) {
      if (patches.ofPatch[k] != static_cast<int>(part) || patches.rotatesWithMean[k]) continue;
      Quaternion& g = frames.rotation[k];
      // In the world of the keys: the turn of the whole and of the periods comes last.
      g = (whole * (back * g) * scratch.path[k].conjugate() * own_.pathAt(own, {}, k)).normalized();
    }
  }
}

}  // namespace shapespline
