#include "core/sequence/sequence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/format.h"
#include "core/base/simd.h"
#include "core/sequence/uneven_times.h"

namespace shapespline {

namespace {

Status checkTime(double t) {
  if (std::isfinite(t)) return {};
  return Error{ErrorCode::InvalidOption, "The time is not a finite number."};
}

// Zero times a number is zero unless the number is infinite or NaN.
bool allFinite(const std::vector<float>& numbers) {
  Float4 sum = Float4::zero();
  const std::size_t last = numbers.size() - std::min<std::size_t>(numbers.size(), 4);  // at least three vertices
  for (std::size_t i = 0; i < last; i += 4) sum = sum + Float4::load(&numbers[i]) * Float4::zero();
  sum = sum + Float4::load(&numbers[last]) * Float4::zero();
  float lanes[4];
  sum.store(lanes);
  return lanes[0] + lanes[1] + lanes[2] + lanes[3] == 0;
}

Error notFinite(const std::string& what) {
  return {ErrorCode::NotFinite, what + " is not finite. Stay closer to the keys, or use keys of similar sizes."};
}

std::string shapeAtTime(double t) { return "The shape at " + shortNumber(t) + " s"; }

Status checkFrame(const Frame& frame, const std::string& what) {
  if (allFinite(frame.positions) && allFinite(frame.normals)) return {};
  return notFinite(what);
}

std::vector<double> timesOf(const Keyframes& keyframes) {
  std::vector<double> times;
  for (const Key& key : keyframes.keys) times.push_back(key.time);
  return times;
}

}  // namespace

Result<Sequence> Sequence::fit(std::shared_ptr<SharedShape> shape, std::vector<double> keyTimes,
                               const MotionOptions& motion, const Sequence* before, const StageProgress& progress,
                               OrderSource order) {
  if (Status status = shape->makeSpace(motion.method, progress, order); !status) return status.error();
  auto fitted = Motion::fit(shape->encoded(), std::move(keyTimes), motion, before ? &before->motion_ : nullptr);
  if (!fitted) return fitted.error();
  Sequence sequence(std::move(shape), std::move(*fitted));
  sequence.collectWarnings();
  return sequence;
}

Result<Sequence> Sequence::create(Keyframes keyframes, const EncodingOptions& encoding, const MotionOptions& motion,
                                  const StageProgress& progress, OrderSource order) {
  std::vector<double> times = timesOf(keyframes);
  auto shape = SharedShape::encode(std::move(keyframes), encoding, progress);
  if (!shape) return shape.error();
  return fit(std::move(*shape), std::move(times), motion, nullptr, progress, order);
}

void Sequence::collectWarnings() {
  warnings_ = motion_.warnings();
  const auto shapeAt = [this](double t, Positions& shape) {
    shape_->evaluator().positions(encoded(), motion_, t, shape);
  };
  const std::vector<Warning> uneven = unevenTimesWarnings(encoded(), motion_, shapeAt);
  warnings_.insert(warnings_.end(), uneven.begin(), uneven.end());
}

Status Sequence::update(const MotionOptions& options, const std::vector<double>& keyTimes) {
  if (Status status = shape_->makeSpace(options.method); !status) return status.error();
  auto motion = Motion::fit(encoded(), keyTimes, options, &motion_);
  if (!motion) return motion.error();
  motion_ = std::move(*motion);
  sliding_.reset();
  collectWarnings();
  return {};
}

Status Sequence::evaluate(double t, Frame& frame) {
  if (Status status = checkTime(t); !status) return status;
  shape_->evaluator().frame(encoded(), motion_, t, frame);
  return checkFrame(frame, shapeAtTime(t));
}

Status Sequence::evaluate(double t, Positions& positions) {
  if (Status status = checkTime(t); !status) return status;
  shape_->evaluator().positions(encoded(), motion_, t, positions);
  for (const Vec3& p : positions)
    if (!p.allFinite()) return notFinite(shapeAtTime(t));
  return {};
}

Result<double> Sequence::sliding(double t, const Positions& shape) {
  const auto [first, last] = range();
  if (!(t >= first && t <= last) || motion_.options().inPlace) return std::numeric_limits<double>::quiet_NaN();
  if (Status status = shape_->makeSpace(Method::Lri); !status) return status.error();
  if (!sliding_) sliding_ = std::make_unique<const Sliding>(encoded().lri().holdInput().mesh, motion_.naturalCurve());
  return sliding_->at(t, shape, encoded().input().welding.weldedOfRaw);
}

Status Sequence::evaluateBlend(const std::vector<double>& weights, Frame& frame) {
  const int keys = encoded().shape().keys;
  if (static_cast<int>(weights.size()) != keys)
    return Error{ErrorCode::InvalidOption, "There are " + grouped(static_cast<std::int64_t>(weights.size())) +
                                               " weights for " + grouped(keys) + " keys. Give one per key."};
  double sum = 0;
  for (const double w : weights) sum += w;
  if (!(std::abs(sum - 1) <= 1e-6)) return Error{ErrorCode::InvalidOption, "The weights must be finite and sum to 1."};
  shape_->evaluator().blend(encoded(), motion_, weights, frame);
  return checkFrame(frame, "This mixture of the keys");
}

Status Sequence::evaluateGhost(double t, std::vector<float>& positions) {
  if (Status status = checkTime(t); !status) return status;
  if (Status status = shape_->makeSpace(Method::Lri); !status) return status;
  if (!encoded().lri().ghostMotion())
    return Error{ErrorCode::InvalidOption,
                 "This sequence has no ghost mesh. Create the sequence with the option ghostFaces."};
  shape_->evaluator().ghost(encoded(), motion_, t, positions);
  if (!allFinite(positions)) return notFinite(shapeAtTime(t));
  return {};
}

Status Sequence::patchRotations(double t, std::vector<Quaternion>& rotations) {
  if (Status status = checkTime(t); !status) return status;
  if (Status status = shape_->makeSpace(Method::Lri); !status) return status;
  shape_->evaluator().patchRotations(encoded(), motion_, t, rotations);
  return {};
}

Result<TimingDerivatives> Sequence::timingDerivatives(double t, const std::vector<int>& regionOf) {
  if (Status status = checkTime(t); !status) return status.error();
  if (Status status = shape_->makeSpace(Method::Lri); !status) return status.error();
  return shapespline::timingDerivatives(encoded(), motion_, t, regionOf);
}

Result<FeatureCurve> Sequence::featureCurve() {
  if (Status status = shape_->makeSpace(Method::Lri); !status) return status.error();
  const auto shapeAt = [this](double t, Positions& shape) {
    shape_->evaluator().unmoved(encoded(), motion_, motion_.at(t), shape);
  };
  return FeatureCurve(encoded(), motion_, shape_->gram(), shapeAt);
}

}  // namespace shapespline
