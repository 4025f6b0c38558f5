#include "core/hold/pin_path.h"

namespace shapespline {

Result<std::unique_ptr<const PinPath>> PinPath::create(const std::vector<PathKey>& keys, const Curve& along,
                                                       const std::optional<RigidMotion>& closing) {
  std::vector<PathKey> kept;
  std::vector<double> times;
  for (const PathKey& key : keys) {
    if (along.periodic() && !(key.time >= along.start() && key.time < along.end())) continue;
    kept.push_back(key);
    times.push_back(key.time);
  }
  if (kept.empty()) return std::unique_ptr<const PinPath>();
  std::unique_ptr<PinPath> path(new PinPath(kept, along, along.closesOnLastKey() ? closing : std::nullopt));
  if (Status status = path->fit(times, along); !status) return status.error();
  return std::unique_ptr<const PinPath>(std::move(path));
}

PinPath::PinPath(const std::vector<PathKey>& keys, const Curve& along, const std::optional<RigidMotion>& closing)
    : start_(along.start()), period_(along.end() - along.start()), closing_(closing) {
  keys_.keys = static_cast<int>(keys.size());
  for (const PathKey& key : keys) keys_.poses.push_back({turned(key.time).transpose() * key.move});
}

Status PinPath::fit(const std::vector<double>& times, const Curve& along) {
  if (times.size() < 2) return {};
  CurveOptions options;
  if (along.periodic()) {
    options.boundary = BoundaryKind::Periodic;
    options.period = period_;
  }
  auto curve = Curve::fit(times, options);
  if (!curve) return curve.error();
  curve_ = std::move(*curve);
  path_.emplace(keys_, *curve_, PathRest{PathRest::AtEnds});
  return {};
}

// Rotation of a loop that does not close in place. Offsets rotate with it, so they keep their direction relative to the
// path.
Mat3 PinPath::turned(double t) const {
  return closing_ ? closing_->power((t - start_) / period_).rotation.toRotationMatrix() : Mat3::Identity();
}

Vec3 PinPath::at(double t) const {
  if (!path_) return turned(t) * keys_.poses[0][0];
  Positions at;
  path_->positionsAt(curve_->wrap(t).time, at);
  return turned(t) * at[0];
}

}  // namespace shapespline
