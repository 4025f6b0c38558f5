// What moves while a sequence is made: its patches, as rigid pieces.
#pragma once

#include <memory>
#include <vector>

#include "core/reconstruct/preview_embedding.h"
#include "core/sequence/encoded_shape.h"
#include "core/sequence/options.h"
#include "core/spline/spline.h"

namespace shapespline {

/// The motion as the patches alone have it: every vertex keeps to where the keys have it in the frame of its patch.
/// Meets every key. Neither hold nor pins are in it.
class Sketch {
 public:
  /// Null where a motion is no curve through the patches (blends of vertices), is moved along as a whole (a loop that
  /// ends elsewhere, in place) or has turns added, and where something fails. The shape's parts must outlive it.
  static std::unique_ptr<Sketch> create(const PatchedShape& patched, const std::vector<double>& keyTimes,
                                        const MotionOptions& options);

  /// xyz of the input's vertices at time t, from the first key to the last.
  void positions(double t, std::vector<float>& out);

 private:
  Sketch(const PatchedShape& patched, const std::vector<double>& keyTimes, const MotionOptions& options);

  const WeldedShape& shape_;
  const PatchMotion& patches_;
  const std::vector<int>& weldedOf_;  // of each vertex of the input
  Result<Curve> curve_;
  Result<PreviewEmbedding> embedding_;
  PatchMotion::Scratch patchScratch_;
  PreviewEmbedding::Scratch scratch_;
  Frames frames_;
  std::vector<float> places_;
};

/// Told of a sketch, and with null before that ends.
using SketchListener = void (*)(Sketch*);

/// Makes the sketch of a sequence, and has a listener know of it for as long as this lives.
class SketchShow : public PatchesListener {
 public:
  /// What is given must outlive it. listener: null where nobody listens.
  SketchShow(const std::vector<double>& keyTimes, const MotionOptions& options, SketchListener listener)
      : keyTimes_(keyTimes), options_(options), listener_(listener) {}
  ~SketchShow() {
    if (sketch_) listener_(nullptr);
  }
  SketchShow(const SketchShow&) = delete;
  SketchShow& operator=(const SketchShow&) = delete;

  void onPatches(const PatchedShape& patched) override {
    sketch_ = Sketch::create(patched, keyTimes_, options_);
    if (sketch_) listener_(sketch_.get());
  }

 private:
  const std::vector<double>& keyTimes_;
  const MotionOptions& options_;
  SketchListener listener_;
  std::unique_ptr<Sketch> sketch_;
};

}  // namespace shapespline
