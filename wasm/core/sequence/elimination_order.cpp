#include "core/sequence/elimination_order.h"

#include <utility>

#include "core/lri/welded_shape.h"
#include "core/reconstruct/poisson.h"
#include "core/sequence/weld_keys.h"

namespace shapespline {

Result<std::vector<int>> eliminationOrder(Keyframes keyframes, const EncodingOptions& options) {
  auto keys = weldKeys(std::move(keyframes), options);
  if (!keys) return keys.error();
  const WeldedShape& shape = keys->shape;
  const ShapeTopology topology = topologyOf(shape, {});
  return eliminationOrder(
      cotangentLaplacian(shape.faces, topology.hasArea, topology.solved, shape.poses[shape.reference]));
}

}  // namespace shapespline
