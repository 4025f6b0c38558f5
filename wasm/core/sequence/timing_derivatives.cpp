#include "core/sequence/timing_derivatives.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace shapespline {

namespace {

// Shapes in single precision are too coarse for a much smaller step.
constexpr double step = 0.005;
constexpr std::vector<double> KeyTiming::* numbers[] = {&KeyTiming::earlier, &KeyTiming::swing};

// The timing with a step in each number of these intervals.
std::vector<KeyTiming> stepped(const KeyTiming& timing, const std::vector<int>& intervals, int keys) {
  std::vector<KeyTiming> all;
  for (const int interval : intervals)
    for (const auto number : numbers) {
      KeyTiming one = timing;
      (one.*number).resize(static_cast<std::size_t>(keys), 0);
      (one.*number)[interval] += step;
      all.push_back(std::move(one));
    }
  return all;
}

std::vector<int> intervalsAround(const std::vector<double>& keyTimes, double t) {
  const auto after = std::upper_bound(keyTimes.begin(), keyTimes.end(), t) - keyTimes.begin();
  const int last = static_cast<int>(keyTimes.size()) - 2, own = std::clamp(static_cast<int>(after) - 1, 0, last);
  std::vector<int> around;
  for (int k = std::max(own - 1, 0); k <= std::min(own + 1, last); ++k) around.push_back(k);
  return around;
}

// Shapes at points of a curve with parts, for given frames of the patches.
class Shapes {
 public:
  explicit Shapes(const EncodedShape& encoded) : encoded_(encoded) {}

  const Positions& at(const CurvePoint& point, const LocalFrames& frames) {
    encoded_.lri().withReconstructor([&]<class Real>(const Reconstructor<Real>& r) {
      r.reconstruct(point, frames, std::get<typename Reconstructor<Real>::Scratch>(scratch_), welded_);
    });
    return welded_;
  }

  void addDifference(const Positions& from, std::vector<float>& out) const {
    for (const int v : encoded_.input().welding.weldedOfRaw)
      for (int k = 0; k < 3; ++k) out.push_back(static_cast<float>((welded_[v][k] - from[v][k]) / step));
  }

 private:
  const EncodedShape& encoded_;
  std::tuple<Reconstructor<float>::Scratch, Reconstructor<double>::Scratch> scratch_;
  Positions welded_;
};

CurvePoint withParts(CurvePoint point, const CurvePoint& position, std::vector<CurvePoint> ofPart,
                     std::shared_ptr<const PatchParts> patches) {
  point.parts = std::make_shared<PartPoints>(PartPoints{position, std::move(ofPart), std::move(patches)});
  return point;
}

Status check(const EncodedShape& encoded, const Motion& motion, double t, const std::vector<int>& regionOf) {
  const auto invalid = [](const char* message) { return Error{ErrorCode::InvalidOption, message}; };
  if (motion.options().method != Method::Lri || encoded.lri().ghostMotion())
    return invalid("Derivatives by the timing require the method 'lri', without a ghost mesh.");
  if (regionOf.size() != encoded.lri().patches().coordinates().graph.area().size() ||
      std::any_of(regionOf.begin(), regionOf.end(), [](int region) { return region < 0; }))
    return invalid("Derivatives by the timing require a region for each patch.");
  if (t < motion.keyTimes().front() || t > motion.keyTimes().back())
    return invalid("Derivatives by the timing require a time between the keys.");
  return {};
}

}  // namespace

Result<TimingDerivatives> timingDerivatives(const EncodedShape& encoded, const Motion& motion, double t,
                                            const std::vector<int>& regionOf) {
  if (Status status = check(encoded, motion, t, regionOf); !status) return status.error();
  const PatchMotion& patches = encoded.lri().patches();
  TimingDerivatives result{intervalsAround(motion.keyTimes(), t), {}};
  const Curve curve =
      motion.curveWithParts(encoded.shape(), stepped(motion.options().timing, result.intervals, encoded.shape().keys));
  const CurvePoint plain = curve.at(t);
  const int regions = regionOf.empty() ? 0 : 1 + *std::max_element(regionOf.begin(), regionOf.end());

  PatchMotion::Scratch scratch;
  LocalFrames mean;
  patches.at(plain, motion.turns(), scratch, mean);
  const std::shared_ptr<PatchParts> all = std::make_shared<PatchParts>();
  all->ofPatch.assign(regionOf.size(), 0);
  for (const double angle : patches.disagreement(plain).ofPatch) all->rotatesWithMean.push_back(angle > pathsAgree);
  std::vector<std::shared_ptr<PatchParts>> alone(regions);
  for (int region = 0; region < regions; ++region) {
    alone[region] = std::make_shared<PatchParts>();
    for (const int one : regionOf) alone[region]->ofPatch.push_back(one == region ? 1 : 0);
  }

  Shapes shapes(encoded);
  const Positions shape = shapes.at(plain, mean);
  for (int part = 0; part < curve.partCount(); ++part) {
    const CurvePoint own = curve.partAt(t, part);
    LocalFrames advanced = mean;
    patches.advanceParts(withParts(plain, plain, {own}, all), motion.turns(), scratch, advanced);
    for (int region = 0; region < regions; ++region) {
      LocalFrames frames = mean;
      frames.part = alone[region]->ofPatch;
      for (std::size_t k = 0; k < regionOf.size(); ++k)
        if (regionOf[k] == region) frames.rotation[k] = advanced.rotation[k];
      shapes.at(withParts(plain, plain, {plain, own}, alone[region]), frames);
      shapes.addDifference(shape, result.shapes);
    }
    shapes.at(withParts(plain, own, {}, all), mean);
    shapes.addDifference(shape, result.shapes);
  }
  return result;
}

}  // namespace shapespline
