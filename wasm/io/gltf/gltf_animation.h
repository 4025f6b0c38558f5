// glTF animations: samplers and their values at a time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/status.h"
#include "io/gltf/gltf_document.h"
#include "io/gltf/gltf_nodes.h"

namespace shapespline {

/// Animated state: node transforms, morph weights (a list per node), and visibility of nodes.
struct SceneState {
  std::vector<NodeTransform> local;
  std::vector<std::vector<double>> weights;
  std::vector<char> visible;
};

/// One channel with its sampler's numbers.
struct AnimationCurve {
  enum class Path { Translation, Rotation, Scale, Weights, Visibility } path = Path::Translation;
  enum class Interpolation { Step, Linear, CubicSpline } interpolation = Interpolation::Linear;
  int node = -1;
  int first = 0;               ///< of the node's weights: the first one that moves
  int width = 3;               ///< numbers a value
  std::vector<double> times;   ///< strictly increasing seconds
  std::vector<double> values;  ///< width a time; for cubic splines in-tangent, value, out-tangent

  /// The value at time t, held beyond both ends. `out` has `width` numbers (glTF 2.0, appendix C).
  void sample(double t, double* out) const;

  /// Whether any value differs from the first one, more than by rounding.
  bool varies() const;
};

struct GltfAnimation {
  std::string name;
  std::vector<AnimationCurve> curves;
  std::vector<double> keyTimes;  ///< the distinct times of all curves, increasing
  bool weightsOnly = true;
  bool moves = true;  ///< more than one pose
};

/// All animations with a channel that moves a node, by name or by pointer (KHR_animation_pointer). Pointers that move
/// no vertex are ignored; others that cannot be applied give a warning. Errors: MalformedFile, NotFinite, TooLarge.
Result<std::vector<GltfAnimation>> readAnimations(const GltfDocument& doc, std::vector<Warning>& warnings);

/// Number of values that applyAnimation writes. Channels may share values, so a small file could ask for any amount.
std::uint64_t animationCost(const GltfAnimation& animation);

/// Writes the animation's values at time t into the state.
void applyAnimation(const GltfAnimation& animation, double t, SceneState& state);

}  // namespace shapespline
