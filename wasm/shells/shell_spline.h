// The time-discrete spline in the space of shells (Heeren, Rumpf, Schroeder, Wardetzky and Wirth 2016), and its energy.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/status.h"
#include "shells/shell_system.h"

namespace shapespline {

/// What second differences over uneven times are made of, with the whole time as the unit.
struct SpacedTimes {
  explicit SpacedTimes(const std::vector<double>& times);

  /// What the neighbours of an inner time count in its mean; they sum to 1.
  std::vector<double> before, after;
  /// What the squared distance at an inner time counts.
  std::vector<double> weight;
};

/// The energy of a path of shapes s_k: at each inner time, the shape m_k is found whose measures come nearest to the
/// mean of its neighbours', and the squared distance of s_k's measures from those of m_k is added, over the fourth
/// power of the spacing, times the spacing. With even spacing 1 / K: 4 K^3 sum W[s_k, m_k].
class ShellSpline {
 public:
  /// system: must outlive it. times: of the shapes, at least 3, increasing. size: of the shape, a length.
  ShellSpline(ShellSystem& system, const std::vector<double>& times, double size)
      : system_(&system), spaced_(times), size_(size) {}

  /// The energy of shapes, and where `gradient` is given its derivative by each. Infinite where a mean is not found.
  double energy(const std::vector<Positions>& shapes, std::vector<Positions>* gradient = nullptr);

  /// Improves the shapes that are not fixed until the energy hardly falls. onProgress: fraction of the most steps.
  void minimise(std::vector<Positions>& shapes, const std::vector<char>& fixed, const FractionReport& onProgress = {});

  int stepCount() const { return steps_; }

 private:
  bool findMean(int k, const std::vector<ShellMeasures>& measures, Positions& mean, ShellMeasures& middle);
  Positions adjointOf(const Positions& mean, const ShellMeasures& middle, const ShellMeasures& away);

  ShellSystem* system_;
  SpacedTimes spaced_;
  double size_;
  std::vector<Positions> means_;  // where the search for each starts
  int steps_ = 0;
};

}  // namespace shapespline
