// What a sequence holds, how it is prepared, and how a shape is made of it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/base/progress.h"
#include "core/sequence/sequence.h"
#include "core/mesh/vertex_normals.h"
#include "core/sequence/shape_motion.h"
#include "core/spline/spline.h"
#include "core/mesh/weld.h"

namespace shapespline {

std::vector<double> timesOf(const Keyframes& keyframes);

/// Whether the method moves every vertex on its own: the baselines.
bool blendsVertices(Method method);
void blendVertices(const WeldedShape& shape, const CurvePoint& point, Positions& out);

struct Sequence::State {
  Keyframes raw;
  MotionOptions motion;
  int wantedGhostFaces = 0;
  Ghost ghost;
  Welding welding;
  WeldedShape shape;               // in canonical order
  std::vector<int> rawOfFace;      // of each of its faces
  std::vector<int> patchOfRawFace;
  Shading shading;
  double diagonal = 0;  // the largest of one pose
  std::unique_ptr<ShapeMotion> shapeMotion;
  std::optional<Curve> curve;
  SequenceStats stats;
  std::vector<Warning> shapeWarnings;  // what the keys say, whatever the motion
  std::vector<Warning> warnings;
  std::vector<int> componentOfRawFace;  // numbered by their first faces in the input; -1 where it has no area
  std::vector<int> firstFaceOf;         // of each component, in the welded mesh
  Eigen::MatrixXd gram;  // made when it is first asked for
  Crew* crew = nullptr;
  PlacedShape<float> placed;  // scratch, as the rest
  Positions weldedPositions, ghostPositions;

  Columns columns() const { return {shape.keys}; }

  void weldKeys(const EncodingOptions& encoding, const FractionReport& onProgress);
  void orderShape(const FractionReport& onProgress);
  std::vector<int> ofRawFaces(const std::vector<int>& ofFaces) const;
  void prepareShading(const FractionReport& onProgress);
  void findClosing();
  void findMirroredKeys();
  CurveOptions curveOptions(const MotionOptions& options) const;
  void describeGhost();
  void numberComponents();
  std::vector<AddedTurns> turnsOfPatchPieces() const;
  void collectWarnings();
  RigidMotion globalMotion(double t, const WrappedTime& wrapped, const CurvePoint& point) const;
  int weldedShape(const CurvePoint& point, Positions& out);
  int placedShape(const CurvePoint& point);
  void fill(const CurvePoint& point, const RigidMotion& global, Frame& frame);
  void finish(const RigidMotion& global, Frame& frame);
  void fill(const CurvePoint& point, const RigidMotion& global, Positions& positions);
  PreviewError distance(const PlacedShape<float>& exact, const PlacedShape<float>& about) const;
  const Eigen::MatrixXd& gramMatrix();
  // Takes weights over the curve's columns, as a row, to weights over the poses.
  Eigen::MatrixXd columnsToPoses() const;
  Eigen::VectorXd poseWeightsAt(double t) const;
};

}  // namespace shapespline
