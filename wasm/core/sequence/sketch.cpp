#include "core/sequence/sketch.h"

#include <utility>

#include "core/sequence/motion.h"
#include "core/sequence/preview.h"

namespace shapespline {

namespace {

bool isSketched(const MotionOptions& options, const WeldedShape& shape) {
  const bool travels = options.boundary == BoundaryKind::Periodic && shape.closing;
  return (options.method == Method::Lri || options.method == Method::Geodesic) && !travels && !options.inPlace &&
         options.turns.empty();
}

}  // namespace

std::unique_ptr<Sketch> Sketch::create(const PatchedShape& patched, const std::vector<double>& keyTimes,
                                       const MotionOptions& options) {
  if (!isSketched(options, patched.shape)) return nullptr;
  std::unique_ptr<Sketch> sketch(new Sketch(patched, keyTimes, options));
  if (!sketch->curve_ || !sketch->embedding_) return nullptr;
  return sketch;
}

Sketch::Sketch(const PatchedShape& patched, const std::vector<double>& keyTimes, const MotionOptions& options)
    : shape_(patched.shape),
      patches_(patched.patches),
      weldedOf_(patched.input.welding.weldedOfRaw),
      curve_(fitCurve(patched.shape, keyTimes, options)),
      embedding_(makePatchPreview(patched)) {}

void Sketch::positions(double t, std::vector<float>& out) {
  const CurvePoint point = curve_->at(t);
  patches_.at(point, {}, patchScratch_, frames_);
  embedding_->at(poseWeights(point, shape_.roles()), frames_.rotation, scratch_, places_);
  out.resize(3 * weldedOf_.size());
  float* p = out.data();
  for (const int w : weldedOf_)
    for (int k = 0; k < 3; ++k) *p++ = places_[4 * static_cast<std::size_t>(w) + k];
}

}  // namespace shapespline
