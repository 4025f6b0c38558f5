#include "core/sequence/motion.h"

#include <algorithm>
#include <numbers>
#include <string>

#include "core/base/format.h"
#include "core/sequence/timing_regions.h"
#include "core/sequence/torn_warnings.h"
#include "core/sequence/turn_warnings.h"

namespace shapespline {

namespace {

/// Upper bound on added turns. Same as MAX_TURNS in web/engine/api/option-table.ts.
constexpr int maxTurns = 100;

Status checkTurns(const std::vector<AddedTurns>& turns, int keyCount, int components) {
  const auto number = [](int index) { return std::to_string(static_cast<std::int64_t>(index) + 1); };  // counted from 1
  for (const AddedTurns& t : turns) {
    if (t.key < 1 || t.key >= keyCount || t.turns < -maxTurns || t.turns > maxTurns)
      return Error{ErrorCode::InvalidOption, "Full turns can be added to keys 2 to " + std::to_string(keyCount) +
                                                 ", up to " + grouped(maxTurns) + " each; got " +
                                                 std::to_string(t.turns) + " for key " + number(t.key) + "."};
    if (t.component < -1 || t.component >= components)
      return Error{ErrorCode::InvalidOption, "Full turns are added to component " + number(t.component) +
                                                 ", but the shape has " + grouped(components) +
                                                 (components == 1 ? " component." : " components.")};
  }
  return {};
}

bool addsTurns(const MotionOptions& o) {
  return std::any_of(o.turns.begin(), o.turns.end(), [](const AddedTurns& t) { return t.turns != 0; });
}

// These methods rotate each face separately, without patches. So they cannot add turns, hold resting parts or pin.
Status checkFaceMethod(const MotionOptions& o) {
  if (!turnsFaces(o.method) || (!o.hold && o.pins.empty() && !addsTurns(o))) return {};
  return Error{ErrorCode::InvalidOption,
               "This method supports no holding, no pins and no full turns. Use the method 'lri'."};
}

CurveOptions curveOptions(const WeldedShape& shape, const MotionOptions& o) {
  return {.linear = o.method == Method::Geodesic || o.method == Method::Linear,
          .boundary = o.boundary,
          .startSpeed = o.startSpeed,
          .endSpeed = o.endSpeed,
          .startShape = shape.startTangent >= 0,
          .endShape = shape.endTangent >= 0,
          .closing = shape.closing ? Closing::LastKey : Closing::Extra,
          .period = o.period,
          .tension = o.tension,
          .bias = o.bias,
          .timing = o.timing};
}

}  // namespace

Result<Motion> Motion::fit(const EncodedShape& encoded, std::vector<double> keyTimes, const MotionOptions& options,
                           const Motion* before) {
  const WeldedShape& shape = encoded.shape();
  if (Status status = validateTimes(keyTimes, shape.keys); !status) return status.error();
  if (Status status = checkTurns(options.turns, shape.keys, encoded.componentCount()); !status) return status.error();
  if (Status status = checkFaceMethod(options); !status) return status.error();
  CurveOptions ofCurve = curveOptions(shape, options);
  std::shared_ptr<PatchParts> parts;
  if (!options.regions.empty()) {
    if (options.method != Method::Lri)
      return Error{ErrorCode::InvalidOption, "Only the method 'lri' supports regions with timings of their own."};
    auto timings = regionTimings(encoded, options.timing, options.regions);
    if (!timings) return timings.error();
    ofCurve.timing = std::move(timings->mean);
    ofCurve.parts = std::move(timings->parts);
    parts = std::move(timings->patches);
  }
  Result<Curve> curve = Curve::fit(keyTimes, ofCurve);
  if (!curve) return curve.error();
  Motion motion(std::move(*curve), std::move(keyTimes), options);
  motion.parts_ = std::move(parts);
  if (motion.parts_) motion.findRotationsOfParts(encoded.lri().patches());
  if (!motion.blendsVertices()) motion.turns_ = encoded.turnsOfPatches(options.turns);
  if (Status status = motion.hold(encoded, before); !status) return status.error();
  motion.collectWarnings(encoded);
  return motion;
}

void Motion::findRotationsOfParts(const PatchMotion& patches) {
  parts_->rotatesWithMean.assign(parts_->ofPatch.size(), 0);
  if (!curve_.isTimed() || curve_.partCount() < 3) return;
  for (const KeySpan& span : curve_.spans()) {
    const std::vector<double> angle = patches.disagreement(curve_.at((span.start + span.end) / 2)).ofPatch;
    for (std::size_t k = 0; k < angle.size(); ++k)
      if (angle[k] > pathsAgree) parts_->rotatesWithMean[k] = 1;
  }
}

CurvePoint Motion::at(double t) const {
  const double inside = curve_.wrap(t).time;
  CurvePoint point = curve_.at(inside);
  if (!parts_ || !curve_.isTimed() || point.beyond >= 0) return point;
  auto parts = std::make_shared<PartPoints>(PartPoints{curve_.partAt(inside, 0), {}, parts_});
  if (curve_.partCount() > 2)
    for (int part = 1; part < curve_.partCount(); ++part) parts->ofPart.push_back(curve_.partAt(inside, part));
  point.parts = std::move(parts);
  return point;
}

Status Motion::hold(const EncodedShape& encoded, const Motion* before) {
  const std::vector<int>& weldedOf = encoded.input().welding.weldedOfRaw;
  const int vertices = static_cast<int>(weldedOf.size()), keys = encoded.shape().keys;
  if (Status status = checkPins(options_.pins, vertices, keys); !status) return status;
  if (options_.method != Method::Lri) return {};
  const Curve plain = curve_.withoutTiming();  // resting and pinned parts keep the plain time
  if (options_.hold && keys > 2) {
    auto held = HeldMotion::create(encoded.lri().holdInput(), plain, options_.turns, before ? before->held() : nullptr);
    if (!held) return held.error();
    held_ = std::move(*held);
  }
  if (!options_.pins.empty()) {
    auto pinned = PinnedMotion::create(encoded.lri().holdInput(), plain, options_.pins, weldedOf,
                                       before ? before->pinned() : nullptr);
    if (!pinned) return pinned.error();
    pinned_ = std::move(*pinned);
  }
  return {};
}

Curve Motion::unshapedCurve(const WeldedShape& shape) const {
  CurveOptions options = curveOptions(shape, options_);
  options.tension.clear();
  options.bias.clear();
  options.timing = {};
  // A curve that fits with values per key also fits without.
  Result<Curve> curve = Curve::fit(times_, options);
  return std::move(*curve);
}

Curve Motion::curveWithParts(const WeldedShape& shape, std::vector<KeyTiming> parts) const {
  CurveOptions options = curveOptions(shape, options_);
  options.parts = std::move(parts);
  Result<Curve> curve = Curve::fit(times_, options);
  return std::move(*curve);
}

Curve Motion::naturalCurve() const {
  // The times have passed an earlier fit, so they are valid.
  Result<Curve> curve = Curve::fit(times_, CurveOptions{});
  return std::move(*curve);
}

void Motion::collectWarnings(const EncodedShape& encoded) {
  warnings_ = encoded.warnings();
  warnOfTurnedLoop(encoded.shape());
  if (blendsVertices()) return;
  const LriSpace& lri = encoded.lri();
  warnings_.insert(warnings_.end(), lri.warnings().begin(), lri.warnings().end());
  std::vector<Warning> turns = options_.method == Method::RotationStrain
                                   ? tornWarnings(encoded.shape(), encoded.rotationStrain())
                                   : patchWarnings(encoded);
  for (Warning& w : turns)
    if (w.face >= 0) w.face = encoded.input().inputFaceOf[w.face];
  warnings_.insert(warnings_.end(), turns.begin(), turns.end());
  if (held_) warnOfTurnsNotHeld();
}

void Motion::warnOfTurnedLoop(const WeldedShape& shape) {
  constexpr double minTurn = std::numbers::pi / 180;
  if (!curve_.closesOnLastKey() || options_.inPlace) return;
  const double angle = shape.closing->rotation.angularDistance(Quaternion::Identity());
  if (angle < minTurn) return;
  warnings_.push_back({"loop-turns",
                       "Each period of the loop ends " + angleText(angle) +
                           " from its start. An exported period jumps back when it is repeated, unless it is exported "
                           "without travel (on the command line, --in-place).",
                       1, shape.keys - 1});
}

void Motion::warnOfTurnsNotHeld() {
  const std::vector<KeySpan> spans = curve_.spans();
  for (std::size_t s = 0; s < held_->heldShare().size(); ++s) {
    if (held_->heldShare()[s] > 0) continue;
    warnings_.push_back({"unheld-turn",
                         "still parts are not held, because of the full turns added to the keys.",
                         1,
                         spans[s].to,
                         -1,
                         {},
                         "Between"});
  }
}

std::vector<Warning> Motion::patchWarnings(const EncodedShape& encoded) const {
  const LriSpace& lri = encoded.lri();
  return turnWarnings(encoded.shape(), lri.patches(), lri.ambiguousFaces(), lri.patchOfFace(),
                      encoded.turnsOfPatchComponents(options_.turns), curve_);
}

Vec3 Motion::loopMove(const EncodedShape& encoded, const CurvePoint& point) const {
  Vec3 move = Vec3::Zero();
  if (!curve_.closesOnLastKey()) return move;
  const std::vector<Vec3>& mean = encoded.meanPosition();
  for (const KeyWeight& k : point.position().unrolled)
    if (k.period != 0) move += k.weight * (encoded.shape().closing->power(k.period)(mean[k.key]) - mean[k.key]);
  return move;
}

// In a loop that does not close in place, every period adds the rigid motion from the first key to the last. It also
// applies to keys of other periods that influence the curve.
RigidMotion Motion::globalMotion(const EncodedShape& encoded, double t, const CurvePoint& point) const {
  if (curve_.closesOnLastKey()) {
    const RigidMotion& closing = *encoded.shape().closing;
    const Vec3 move = loopMove(encoded, point);
    double exponent = curve_.wrap(t).periods;
    if (options_.inPlace) exponent -= (t - curve_.start()) / (curve_.end() - curve_.start());
    const RigidMotion further = closing.power(exponent);
    return {further.rotation, further(move)};
  }
  RigidMotion global;
  if (options_.inPlace && !curve_.periodic()) {
    const std::vector<Vec3>& mean = encoded.meanPosition();
    const double span = times_.back() - times_.front();
    global.translation -= (t - times_.front()) / span * (mean[encoded.shape().keys - 1] - mean[0]);
  }
  return global;
}

}  // namespace shapespline
