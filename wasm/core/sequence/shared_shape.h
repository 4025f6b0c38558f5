// An encoded shape and what its frames are computed in: what all its motions share.
#pragma once

#include <memory>

#include <Eigen/Core>

#include "core/sequence/encoded_shape.h"
#include "core/sequence/evaluator.h"

namespace shapespline {

/// Encoded once, moved in any number of ways (sequence.h). Not thread-safe.
class SharedShape {
 public:
  /// keyframes: moved in where the caller needs them no more; freed once they are welded. progress: called with a
  /// stage's name and the fraction of the whole work that is done, in [0, 1] and never falling. order: as for
  /// EncodedShape::build. Errors: TooLarge for too many keys, and those of EncodedShape::build.
  static Result<std::shared_ptr<SharedShape>> encode(Keyframes keyframes, const EncodingOptions& options,
                                                     const StageProgress& progress = {}, OrderSource order = nullptr);

  const EncodedShape& encoded() const { return encoded_; }
  Evaluator& evaluator() { return evaluator_; }
  SequenceStats stats() const { return {encoded_.stats(), evaluator_.stats()}; }

  /// EncodedShape::gramMatrix(), made when it is first asked for.
  const Eigen::MatrixXd& gram();

 private:
  explicit SharedShape(EncodedShape encoded) : encoded_(std::move(encoded)) {}

  EncodedShape encoded_;
  Evaluator evaluator_;
  Eigen::MatrixXd gram_;
};

}  // namespace shapespline
