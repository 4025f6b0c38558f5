#include "core/hold/pinned_motion.h"

#include <numeric>

#include "core/base/sort_indices.h"
#include "core/hold/hold_passes.h"
#include "core/hold/pin_region.h"

namespace shapespline {

namespace {

// Stiffness of the rest of the shape, relative to a vertex's share of the area.
constexpr double bodyWeight = 10;

double medianOf(const std::vector<double>& values) {
  std::vector<int> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  sortIndices(order, [&](int a, int b) { return values[a] < values[b]; });
  return values[order[order.size() / 2]];
}

std::vector<int> verticesIn(const std::vector<HeldVertex>& held) {
  std::vector<int> vertices;
  for (const HeldVertex& h : held) vertices.push_back(h.vertex);
  return vertices;
}

}  // namespace

Result<std::shared_ptr<const PinnedMotion>> PinnedMotion::create(const HoldInput& input, const Curve& curve,
                                                                 const std::vector<Pin>& pins,
                                                                 const std::vector<int>& weldedOf,
                                                                 const PinnedMotion* before) {
  std::shared_ptr<PinnedMotion> pinned(new PinnedMotion(input, curve, heldVertices(input, pins, weldedOf), pins));
  for (const Pin& pin : pins) {
    auto path = PinPath::create(pin.path, curve, input.mesh.shape.closing);
    if (!path) return path.error();
    pinned->path_.push_back(std::move(*path));
  }
  if (before && before->held_ == pinned->held_) {
    pinned->pull_ = before->pull_;
    return std::shared_ptr<const PinnedMotion>(std::move(pinned));
  }
  std::vector<double> weight = vertexAreas(input.mesh);
  for (double& w : weight) w *= bodyWeight;
  for (const HeldVertex& h : pinned->held_) weight[h.vertex] += h.weight;
  auto system = HoldSystem::create(input.mesh, weight, input.precision);
  if (!system) return system.error();
  AffineResponse modes(input, *system, pinned->held_, static_cast<int>(pins.size()));
  ArapRotation patches(input, modes);
  pinned->pull_ = std::make_shared<const Pull>(std::move(*system), std::move(modes), std::move(patches));
  return std::shared_ptr<const PinnedMotion>(std::move(pinned));
}

PinnedMotion::PinnedMotion(const HoldInput& input, const Curve& curve, std::vector<HeldVertex> held,
                           const std::vector<Pin>& pins)
    : held_(std::move(held)),
      vertices_(verticesIn(held_)),
      target_(input, curve, &vertices_),
      period_(curve.end() - curve.start()) {
  if (curve.closesOnLastKey()) closing_ = input.mesh.shape.closing;
  for (const Pin& pin : pins) {
    Stay& stay = stays_.emplace_back();
    if (pin.key < 0) continue;
    stay.pose = &input.mesh.shape.poses[pin.key];
    for (const KeySpan& span : curve.spans()) {
      if (span.from == pin.key) stay.time = span.start;
      else if (span.to == pin.key) stay.time = span.end;
    }
  }
}

RigidMotion PinnedMotion::motionOfPin(const Stay& stay, double t) const {
  return closing_ && stay.pose ? closing_->power((t - stay.time) / period_) : RigidMotion{};
}

// Each vertex is held as firmly as by its neighbours, in proportion to its share of the area.
std::vector<HeldVertex> PinnedMotion::heldVertices(const HoldInput& input, const std::vector<Pin>& pins,
                                                   const std::vector<int>& weldedOf) {
  const std::vector<double> area = vertexAreas(input.mesh);
  const double firm = medianOf(stiffnessDiagonal(input.mesh)) * static_cast<double>(area.size());
  std::vector<char> taken(area.size(), 0);
  std::vector<HeldVertex> held;
  for (std::size_t pin = 0; pin < pins.size(); ++pin)
    for (const int v : pinnedVertices(input, weldedOf[pins[pin].vertex], pins[pin].radius)) {
      if (taken[v]) continue;
      taken[v] = 1;
      held.push_back({v, static_cast<int>(pin), firm * area[v]});
    }
  return held;
}

std::vector<int> PinnedMotion::verticesOf(int pin) const {
  std::vector<int> vertices;
  for (const HeldVertex& h : held_)
    if (h.pin == pin) vertices.push_back(h.vertex);
  return vertices;
}

void PinnedMotion::apply(double t, const std::vector<Quaternion>& frames, const Vec3& mean, Positions& shape,
                         Scratch& scratch, ForkJoin* forkJoin) const {
  const SpanPosition inSpan = target_.path().spanPositionAt(t);
  if (inSpan.beyond >= 1) return;
  findDisplacement(t, inSpan, frames, mean, shape, scratch);
  const auto& [system, modes, patches] = *pull_;
  modes.fit(scratch.displacement, scratch.mode);
  patches.find(modes, scratch.mode, frames, scratch.turn);
  scratch.pulls.assign(shape.size(), Vec3::Zero());
  // Twice the displacement minus the predicted motion compensates for the softness of the pin.
  for (std::size_t i = 0; i < held_.size(); ++i)
    scratch.pulls[held_[i].vertex] = held_[i].weight * (2 * scratch.displacement[i] - modes.moved(i, scratch.mode));
  patches.addTo(scratch.pulls, scratch.turn);
  system.addSolved(scratch.pulls, shape, scratch.solve, forkJoin);
}

// Displacements from each held vertex's current position to its target position.
void PinnedMotion::findDisplacement(double t, const SpanPosition& inSpan, const std::vector<Quaternion>& frames,
                                    const Vec3& mean, const Positions& shape, Scratch& scratch) const {
  target_.at(t, frames, mean, scratch.target, scratch.body);
  scratch.displacement.clear();
  std::vector<Vec3> move;
  std::vector<RigidMotion> way;
  for (const auto& path : path_) move.push_back(path ? path->at(t) : Vec3::Zero());
  for (const Stay& stay : stays_) way.push_back(motionOfPin(stay, t));
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const HeldVertex& h = held_[i];
    const Positions* kept = stays_[h.pin].pose;
    const Vec3 wanted = kept ? way[h.pin]((*kept)[h.vertex]) : scratch.target[i];
    scratch.displacement.push_back(inSpan.within() * (wanted + move[h.pin] - shape[h.vertex]));
  }
}

}  // namespace shapespline
