// A shape with its scratch memory, and the data shared by all its motions.
#pragma once

#include <memory>

#include <Eigen/Core>

#include "core/sequence/encoded_shape.h"
#include "core/sequence/evaluator.h"

namespace shapespline {

/// Encoded once, used by any number of motions (sequence.h). Not thread-safe.
class SharedShape {
 public:
  /// keyframes: move them if the caller no longer needs them; freed after welding. progress: receives the name of a
  /// stage and the completed fraction of the work, in [0, 1], never decreasing. Errors: TooLarge for too many keys, and
  /// those of EncodedShape::build.
  static Result<std::shared_ptr<SharedShape>> encode(Keyframes keyframes, const EncodingOptions& options,
                                                     const StageProgress& progress = {});

  /// Builds the space for a method's motions unless it exists. progress: as above. order: as for LriSpace::create.
  /// Errors: those of LriSpace::create and of EncodedShape::makeFaceSpace.
  Status makeSpace(Method method, const StageProgress& progress = {}, OrderSource order = nullptr);

  const EncodedShape& encoded() const { return encoded_; }
  Evaluator& evaluator() { return evaluator_; }
  SequenceStats stats() const { return {encoded_.stats(), evaluator_.stats()}; }

  /// LriSpace::gramMatrix(), computed on first use. LRI space must exist.
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
