#include "samples/rig.h"

#include <string>
#include <utility>

#include "samples/remesh.h"
#include "samples/skin.h"

namespace shapespline {

Keyframes posedKeyframes(const Body& body, const std::vector<Pose>& poses, double spacing, int smoothing) {
  Surface surface = makeSurface(body);
  const Binding binding = bindSurface(surface, body, smoothing);
  Keyframes result;
  for (std::size_t j = 0; j < poses.size(); ++j) {
    const std::vector<Rigid> joints = jointTransforms(body, poses[j]);
    result.keys.push_back({"pose " + std::to_string(j + 1), double(j) * spacing, skin(surface, binding, joints)});
  }
  result.faces = std::move(surface.faces);
  return result;
}

}  // namespace shapespline
