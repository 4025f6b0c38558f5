// Evaluates glTF animations.
#pragma once

#include <cstdint>
#include <optional>
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
  int first = 0;               ///< first animated morph weight of the node
  int width = 3;               ///< numbers per value
  std::vector<double> times;   ///< seconds, never decreasing; at equal times, the value jumps to the last one
  std::vector<double> values;  ///< `width` numbers per time; cubic splines store in-tangent, value, out-tangent

  /// Writes the value at time t to `out`, which has `width` numbers. Values are constant beyond both ends (glTF 2.0,
  /// appendix C).
  void sample(double t, double* out) const;

  /// Whether any value differs from the first by more than rounding.
  bool varies() const;

  /// The times at which the value jumps.
  std::vector<double> cuts() const;
};

struct GltfAnimation {
  int index = 0;  ///< in the file
  std::string name;
  std::vector<AnimationCurve> curves;
  std::vector<double> keyTimes;  ///< distinct times of all curves, increasing
  bool weightsOnly = true;
  bool moves = true;           ///< false if all poses are equal
  std::vector<double> cuts{};  ///< distinct times at which the mesh jumps, increasing
  int object = -1;             ///< the only object that it moves (objectsOf), or -1 for several
  /// Why it cannot be read. Its curves then only name their nodes: -1 for a node that does not exist.
  std::optional<Error> error{};
};

/// Reads all animations with a channel that moves a node, by name or by pointer (KHR_animation_pointer). Pointers that
/// move no vertex are ignored. Other unsupported pointers give a warning. Errors of an animation are in the animation,
/// because the file may have others: MalformedFile, NotFinite, TooLarge.
std::vector<GltfAnimation> readAnimations(const GltfDocument& doc, std::vector<Warning>& warnings);

/// Sorts times and removes repeated ones.
void sortOnce(std::vector<double>& times);

/// Number of values written by applyAnimation. Channels may share values, so a small file could demand any amount.
std::uint64_t animationCost(const GltfAnimation& animation);

/// Applies the animation's values at time t to the state.
void applyAnimation(const GltfAnimation& animation, double t, SceneState& state);

}  // namespace shapespline
