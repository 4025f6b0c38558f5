#include "core/rotation/turn_choice.h"

#include <array>

#include "core/rotation/rotation.h"

namespace shapespline {

namespace {

// Weight of rotation relative to bending. With this weight, a swing by 165 degrees and its return cost as much as a
// full turn in two steps.
constexpr double turningWeight = 10;
// Smaller cost differences may be rounding errors, radians squared.
constexpr double sameCost = 1e-2;

bool isPositive(const Vec3& turn) {
  int largest = 0;
  turn.cwiseAbs().maxCoeff(&largest);
  return turn[largest] > 0;
}

}  // namespace

TurnOptions turnOptions(const Vec3& turn) {
  const double angle = turn.norm();
  const bool isOpen = angle > ambiguousTurn;
  const Vec3 other = isOpen ? Vec3(turn - twoPi / angle * turn) : turn;
  return {turn, other, turn.squaredNorm(), other.squaredNorm(), isOpen};
}

// Viterbi's algorithm, from the last step to the first: least[s][w] is the minimum cost from step s on if s takes
// direction w.
std::vector<char> chooseTurns(const std::vector<TurnOptions>& steps) {
  const auto cost = [&](std::size_t s, int way) {
    return turningWeight * (way == 0 ? steps[s].cost : steps[s].otherCost);
  };
  const auto turn = [&](std::size_t s, int way) -> const Vec3& { return way == 0 ? steps[s].turn : steps[s].other; };
  std::vector<std::array<double, 2>> least(steps.size());
  // The best direction of step s after a given rotation, and its cost.
  const auto best = [&](std::size_t s, const Vec3* before) {
    std::array<double, 2> sum;
    for (int way = 0; way < 2; ++way) sum[way] = least[s][way] + (before ? (turn(s, way) - *before).squaredNorm() : 0);
    if (!steps[s].isOpen) return std::pair(0, sum[0]);
    const int first = isPositive(steps[s].turn) ? 0 : 1;
    const int way = sum[1 - first] < sum[first] - sameCost ? 1 - first : first;
    return std::pair(way, sum[way]);
  };
  for (std::size_t s = steps.size(); s-- > 0;)
    for (int way = 0; way < 2; ++way)
      least[s][way] = cost(s, way) + (s + 1 < steps.size() ? best(s + 1, &turn(s, way)).second : 0);
  std::vector<char> other;
  const Vec3* before = nullptr;
  for (std::size_t s = 0; s < steps.size(); ++s) {
    other.push_back(best(s, before).first == 1);
    before = &turn(s, other.back());
  }
  return other;
}

}  // namespace shapespline
