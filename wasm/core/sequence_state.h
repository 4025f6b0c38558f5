// What a sequence holds, how it is prepared, and how a shape is made of it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/mesh.h"
#include "core/progress.h"
#include "core/sequence.h"
#include "core/shading.h"
#include "core/shape_motion.h"
#include "core/spline.h"
#include "core/weld.h"

namespace shapespline {

std::vector<double> timesOf(const Keyframes& keyframes);

/// Whether the method moves every vertex on its own: the baselines.
bool blendsVertices(Method method);
void blendVertices(const WeldedShape& shape, const Weights& weights, Positions& out);

struct Sequence::State {
  Keyframes raw;
  MotionOptions motion;
  int wantedGhostFaces = 0;
  Ghost ghost;
  Welding welding;
  WeldedShape shape;
  Shading shading;
  double diagonal = 0;
  Closing closing = Closing::Extra;
  Quaternion closingRotation = Quaternion::Identity();  // of the rigid motion from the first key to the last
  std::unique_ptr<ShapeMotion> shapeMotion;
  std::optional<Curve> curve;
  SequenceStats stats;
  std::vector<Warning> warnings;
  Eigen::MatrixXd gram;  // made when it is first asked for
  Crew* crew = nullptr;
  PlacedShape<float> placed;  // scratch, as the rest
  Positions weldedPositions, ghostPositions;

  Columns columns() const { return {shape.keys}; }

  void weldKeys(const EncodingOptions& encoding, const FractionReport& onProgress);
  void prepareShading(const FractionReport& onProgress);
  void findClosing();
  void decideAlignment(const FractionReport& onProgress);
  CurveOptions curveOptions(const MotionOptions& options) const;
  void describeGhost();
  void collectWarnings();
  // How far and how the whole shape is moved after its reconstruction at a wrapped time.
  struct Global {
    Mat3 rotation = Mat3::Identity();
    Vec3 pivot = Vec3::Zero(), translation = Vec3::Zero();
    bool moves = false;
    Vec3 apply(const Vec3& p) const { return rotation * (p - pivot) + pivot + translation; }
  };
  Global globalMotion(double t, const WrappedTime& wrapped, const Weights& weights) const;
  Vec3 meanPosition(const Weights& weights) const;
  int weldedShape(const Weights& weights, Positions& out);
  int placedShape(const Weights& weights);
  void fill(const Weights& weights, const Global& global, Frame& frame);
  void finish(const Global& global, Frame& frame);
  void fill(const Weights& weights, const Global& global, Positions& positions);
  const Eigen::MatrixXd& gramMatrix();
  // Takes weights over the curve's columns, as a row, to weights over the poses.
  Eigen::MatrixXd columnsToPoses() const;
  Eigen::VectorXd poseWeightsAt(double t) const;
};

}  // namespace shapespline
