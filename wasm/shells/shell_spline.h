// The time-discrete spline in the space of shells (Heeren, Rumpf, Schroeder, Wardetzky and Wirth 2016), and its energy.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/status.h"
#include "shells/shell_system.h"

namespace shapespline {

/// Coefficients of second differences at unevenly spaced times. Times are relative to the whole duration.
struct SpacedTimes {
  explicit SpacedTimes(const std::vector<double>& times);

  /// Weights of the two neighbours in the mean at an inner time; their sum is 1.
  std::vector<double> before, after;
  /// Weight of the squared distance at an inner time.
  std::vector<double> weight;
};

/// The energy of a path of shapes s_k with measures z(s_k). m_k is the shape whose measures are closest to the weighted
/// mean of z(s_(k-1)) and z(s_(k+1)). The energy is the sum over inner times of 4 |z(s_k) - z(m_k)|^2 / h^3, for
/// spacing h.
class ShellSpline {
 public:
  /// system: must outlive this object. times: one per shape, at least 3, increasing. size: diagonal of the shape.
  ShellSpline(ShellSystem& system, const std::vector<double>& times, double size)
      : system_(&system), spaced_(times), size_(size) {}

  /// The energy of the shapes. If `gradient` is given, it receives the derivative with respect to each shape. Infinite
  /// if a mean is not found.
  double energy(const std::vector<Positions>& shapes, std::vector<Positions>* gradient = nullptr);

  /// Replaces the chosen shapes by the means of their neighbours, from the first to the last; where a mean is not
  /// found, the shape stays.
  void moveToMeans(std::vector<Positions>& shapes, const std::vector<char>& chosen);

  /// Improves the shapes that are not fixed, until a step hardly lowers the energy. Where no step lowers it, mostly
  /// because a triangle collapses in a mean, that term is omitted and its three shapes stay. Returns one entry per
  /// shape: whether it stayed as it was for this reason, or because the search ended early (`finished`). onProgress:
  /// steps taken, as a fraction of the largest allowed number.
  std::vector<char> minimise(std::vector<Positions>& shapes, const std::vector<char>& fixed,
                             const FractionReport& onProgress = {});

  int stepCount() const { return steps_; }
  /// False if the last search ended at a limit of its steps, or could not begin.
  bool finished() const { return finished_; }

 private:
  bool findMean(int k, const std::vector<ShellMeasures>& measures, Positions& mean, ShellMeasures& middle);
  double speedOf(const std::vector<Positions>& shapes) const;
  int descend(std::vector<Positions>& shapes, const std::vector<char>& fixed, const FractionReport& onProgress);
  Positions adjointOf(const Positions& mean, const ShellMeasures& middle, const ShellMeasures& away);

  ShellSystem* system_;
  SpacedTimes spaced_;
  double size_;
  std::vector<Positions> means_;  // the last means, from which the next searches start
  std::vector<double> terms_;     // of the last energy, by time
  std::vector<char> omitted_;     // times whose terms do not count
  int trials_ = 0;
  int steps_ = 0;
  bool finished_ = true;
};

}  // namespace shapespline
