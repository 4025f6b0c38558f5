#include "core/sequence/shared_shape.h"

#include <algorithm>
#include <utility>

#include "core/base/format.h"
#include "core/sequence/build_progress.h"

namespace shapespline {

namespace {

// Every key has a weight at every other one: numbers and work grow with the square.
constexpr int mostKeys = 2000;

}  // namespace

Result<std::shared_ptr<SharedShape>> SharedShape::encode(Keyframes keyframes, const EncodingOptions& options,
                                                         const StageProgress& progress, OrderSource order) {
  if (keyframes.keyCount() > mostKeys)
    return Error{ErrorCode::TooLarge, "There are " + grouped(keyframes.keyCount()) + " keys; a motion passes through " +
                                          grouped(mostKeys) + " at most. Take fewer keys."};
  double reached = 0;
  const StageProgress report = [&, withGhost = options.ghostFaces > 0](const char* stage, double fraction) {
    reached = std::max(reached, wholeProgress(stage, fraction, withGhost));
    if (progress) progress(stage, reached);
  };
  auto encoded = EncodedShape::build(std::move(keyframes), options, report, order);
  if (!encoded) return encoded.error();
  report("factorising", 1);
  return std::shared_ptr<SharedShape>(new SharedShape(std::move(*encoded)));
}

const Eigen::MatrixXd& SharedShape::gram() {
  if (gram_.size() == 0) gram_ = encoded_.gramMatrix();
  return gram_;
}

}  // namespace shapespline
