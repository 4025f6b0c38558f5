#include "core/sequence/shape_motion.h"

#include <algorithm>

#include "core/sequence/gram_matrix.h"

namespace shapespline {

namespace {

template <class Real>
class TypedMotion final : public ShapeMotion {
 public:
  explicit TypedMotion(const WeldedShape& shape) : shape_(shape) {}

  Status build(const EncodingOptions& options, SequenceStats& stats, const StageProgress& progress) {
    Stopwatch watch;
    const bool wantsGhost = options.ghostFaces > 0;
    const Stage simplifying{progress, "simplifying"}, encoding{progress, "encoding"};
    const ShapeParts parts = partsOf(shape_, wantsGhost ? partOf(simplifying, 0, 0) : partOf(encoding, 0, 0.2));
    if (parts.pieces.count == 0)
      return Error{ErrorCode::NoArea, "No triangle has area in every key. Use poses in which the shape is not collapsed."};
    stats.components = parts.pieces.count;
    const auto usedFaces = std::count(parts.hasArea.begin(), parts.hasArea.end(), 1);
    const bool withGhost = wantsGhost && options.ghostFaces < usedFaces;
    Status status = withGhost ? buildGhost(parts, options, stats, progress)
                              : buildPatches(parts, options, stats, partOf(encoding, 0.2, 0.7));
    if (!status) return status;
    watch.lap();
    const FramePoses frames = withGhost ? ghost_->poses() : patches_.poses();
    auto coordinates = encode<Real>(shape_, parts, frames, options.stretch, withGhost ? options.transfer : Transfer::Exact,
                                    partOf(encoding, withGhost ? 0 : 0.7, 1));
    ++stats.encodings;
    (withGhost ? stats.transferMs : stats.encodeMs) += watch.lap();
    progress("encoding", 1);
    status = reconstructor_.build({shape_, parts, frames.ofFace, source(), options.stretch, options.precision},
                                  std::move(coordinates), stats, progress);
    ++stats.factorisations;
    return status;
  }

  int at(const CurvePoint& point, Positions& welded) override {
    return reconstructor_.reconstruct(point, welded);
  }

  int at(const CurvePoint& point, PlacedShape<float>& placed, SequenceStats& stats, Crew* crew) override {
    if constexpr (std::is_same_v<Real, float>) {
      return reconstructor_.reconstruct(point, placed, &stats, crew);
    } else {
      const int lost = reconstructor_.reconstruct(point, placed_, &stats, crew);
      placed.places.assign(placed_.places.begin(), placed_.places.end());
      placed.move = placed_.move;
      return lost;
    }
  }

  Status previewAt(const CurvePoint& point, PlacedShape<float>& placed) override {
    return reconstructor_.preview(point, ghost_ ? ghost_->poses() : patches_.poses(), placed);
  }

  PatchMotion& patchMotion() override { return ghost_ ? ghost_->patchMotion() : patches_; }
  const PatchMotion& patchMotion() const override { return ghost_ ? ghost_->patchMotion() : patches_; }
  GhostMotion* ghost() override { return ghost_.get(); }
  const std::vector<int>& patchOfFace() const override {
    return ghost_ ? patchOfFace_ : patches_.coordinates().patches.ofFace;
  }
  const std::vector<int>& componentOfFace() const override { return reconstructor_.pieceOfFace(); }
  Eigen::MatrixXd gram(double diagonal) const override {
    if (ghost_) return gramMatrix(ghost_->patchMotion().coordinates(), ghost_->coordinates(), ghost_->shape(), diagonal);
    return gramMatrix(patches_.coordinates(), reconstructor_.coordinates(), shape_, diagonal);
  }
  const std::vector<Vec3>& meanPosition() const override { return reconstructor_.coordinates().meanPosition; }
  const std::vector<int>& placeOf() const override { return reconstructor_.placeOf(); }
  const std::vector<AmbiguousFaces>& ambiguousFaces() const override { return reconstructor_.coordinates().ambiguous; }
  CholeskyStats solverStats() const override { return reconstructor_.solverStats(); }

 private:
  FrameSource& source() {
    if (ghost_) return *ghost_;
    return patches_;
  }

  Status buildPatches(const ShapeParts& parts, const EncodingOptions& options, SequenceStats& stats, const FractionReport& onProgress) {
    Stopwatch watch;
    auto patches = encodePatches(shape_, parts, options.patches, onProgress);
    if (!patches) return patches.error();
    const Status status = patches_.build(shape_, std::move(*patches));
    ++stats.factorisations;
    stats.encodeMs += watch.lap();
    return status;
  }

  Status buildGhost(const ShapeParts& parts, const EncodingOptions& options, SequenceStats& stats, const StageProgress& progress) {
    ghost_ = std::make_unique<GhostMotion>();
    if (Status status = ghost_->build(shape_, parts, options, stats, progress); !status) return status;
    const std::vector<int>& patches = ghost_->patchMotion().coordinates().patches.ofFace;
    for (int c : ghost_->correspondence()) patchOfFace_.push_back(c >= 0 ? patches[c] : -1);
    return {};
  }

  const WeldedShape& shape_;
  PatchMotion patches_;                 // without a ghost
  std::unique_ptr<GhostMotion> ghost_;
  std::vector<int> patchOfFace_;        // with one
  Reconstructor<Real> reconstructor_;
  PlacedShape<Real> placed_;  // scratch
};

template <class Real>
Result<std::unique_ptr<ShapeMotion>> createTyped(const WeldedShape& shape, const EncodingOptions& options,
                                                 SequenceStats& stats, const StageProgress& progress) {
  auto motion = std::make_unique<TypedMotion<Real>>(shape);
  if (Status status = motion->build(options, stats, progress); !status) return status.error();
  return std::unique_ptr<ShapeMotion>(std::move(motion));
}

}  // namespace

Result<std::unique_ptr<ShapeMotion>> ShapeMotion::create(const WeldedShape& shape, const EncodingOptions& options,
                                                         SequenceStats& stats, const StageProgress& progress) {
  if (options.precision != Precision::Single) return createTyped<double>(shape, options, stats, progress);
  return createTyped<float>(shape, options, stats, progress);
}

}  // namespace shapespline
