#include "core/sequence/shared_shape.h"

#include <algorithm>
#include <utility>

#include "core/base/format.h"
#include "core/sequence/build_progress.h"

namespace shapespline {

namespace {

// Plots take memory and time that grow with the square of the number of keys. Same limit as MAX_MOTION_KEYS in
// web/engine/caller/fitted-motion.ts.
constexpr int maxKeys = 2000;

}  // namespace

Result<std::shared_ptr<SharedShape>> SharedShape::encode(Keyframes keyframes, const EncodingOptions& options,
                                                         const StageProgress& progress) {
  if (keyframes.keyCount() > maxKeys)
    return Error{ErrorCode::TooLarge, "There are " + grouped(keyframes.keyCount()) +
                                          " keys, but a motion can have at most " + grouped(maxKeys) +
                                          ". Use fewer keys."};
  auto encoded = EncodedShape::build(std::move(keyframes), options, progress);
  if (!encoded) return encoded.error();
  return std::shared_ptr<SharedShape>(new SharedShape(std::move(*encoded), options.ghostFaces > 0));
}

Status SharedShape::makeSpace(Method method, const StageProgress& progress, OrderSource order) {
  if (blendsVertices(method)) {
    encoded_.makeVertices();
    return {};
  }
  if (Status status = makeLri(progress, order); !status) return status;
  return turnsFaces(method) ? encoded_.makeFaceSpace(method) : Status();
}

Status SharedShape::makeLri(const StageProgress& progress, OrderSource order) {
  if (encoded_.hasLri()) return {};
  double reached = 0;
  const StageProgress report = [&](const char* stage, double fraction) {
    reached = std::max(reached, wholeProgress(stage, fraction, wantsGhost_));
    if (progress) progress(stage, reached);
  };
  if (Status status = encoded_.makeLri(report, order); !status) return status;
  report("factorising", 1);
  return {};
}

const Eigen::MatrixXd& SharedShape::gram() {
  if (gram_.size() == 0) gram_ = encoded_.lri().gramMatrix();
  return gram_;
}

}  // namespace shapespline
