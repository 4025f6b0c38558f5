// A shape, what its frames are computed in, and what all its motions share.
#pragma once

#include <memory>

#include <Eigen/Core>

#include "core/sequence/encoded_shape.h"
#include "core/sequence/evaluator.h"

namespace shapespline {

/// Made once, moved in any number of ways (sequence.h). Not thread-safe.
class SharedShape {
 public:
  /// keyframes: move them if the caller no longer needs them; freed once welded. progress: called with a stage's name
  /// and the finished fraction of the work, in [0, 1], never decreasing. Errors: TooLarge for too many keys, and those
  /// of EncodedShape::build.
  static Result<std::shared_ptr<SharedShape>> encode(Keyframes keyframes, const EncodingOptions& options,
                                                     const StageProgress& progress = {});

  /// Makes the space that a method's motions need, where it is not there. progress: as above. order: as for
  /// LriSpace::create. Errors: those of LriSpace::create
  /// and of EncodedShape::makeFaceSpace.
  Status makeSpace(Method method, const StageProgress& progress = {}, OrderSource order = nullptr);
  /// The same of all that a motion needs.
  Status makeSpaces(const MotionOptions& motion, const StageProgress& progress = {}, OrderSource order = nullptr);

  const EncodedShape& encoded() const { return encoded_; }
  Evaluator& evaluator() { return evaluator_; }
  SequenceStats stats() const { return {encoded_.stats(), evaluator_.stats()}; }

  /// LriSpace::gramMatrix(), made when it is first asked for. LRI space must have been made.
  const Eigen::MatrixXd& gram();

 private:
  SharedShape(EncodedShape encoded, bool wantsGhost) : encoded_(std::move(encoded)), wantsGhost_(wantsGhost) {}

  Status makeLri(const StageProgress& progress, OrderSource order);

  EncodedShape encoded_;
  bool wantsGhost_;
  Evaluator evaluator_;
  Eigen::MatrixXd gram_;
};

}  // namespace shapespline
