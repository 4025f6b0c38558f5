#include "shells/shell_bending.h"

#include <cmath>
#include <utility>

namespace shapespline {

Result<ShellBending> ShellBending::create(const std::vector<Triangle>& faces, const std::vector<Positions>& keys) {
  std::vector<const Positions*> poses;
  for (const Positions& key : keys) poses.push_back(&key);
  Welding welding = weld(poses, weldTolerances(poses));
  std::vector<Positions> welded;
  for (const Positions& key : keys) welded.push_back(weldPositions(key, welding));
  ShellMetric metric(weldFaces(faces, welding), welded);
  if (metric.edgeCount() == 0)
    return Error{ErrorCode::NoArea, "No triangle has area in the first key, so lengths and angles cannot be compared."};
  ShellBending bending(std::move(welding), std::move(metric));
  const std::vector<ShellMeasures> measures = bending.metric_.measuresOfKeys(welded);
  for (std::size_t k = 1; k < measures.size(); ++k)
    bending.average_ += bending.metric_.squaredNorm(bending.metric_.difference(measures[k], measures[k - 1])) /
                        static_cast<double>(measures.size() - 1);
  return bending;
}

ShellMeasures ShellBending::measuresOf(const Positions& shape) const {
  return metric_.measuresOf(weldPositions(shape, welding_));
}

double ShellBending::energy(const ShellMeasures& before, const ShellMeasures& here, const ShellMeasures& after,
                            double step) const {
  if (!(average_ > 0)) return 0;
  ShellMeasures second = metric_.difference(after, here);
  const ShellMeasures first = metric_.difference(here, before);
  for (std::size_t m = 0; m < second.size(); ++m) second[m] -= first[m];
  return metric_.squaredNorm(second) / (std::pow(step, 4) * average_);
}

}  // namespace shapespline
