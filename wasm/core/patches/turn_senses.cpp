#include "core/patches/turn_senses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <queue>
#include <unordered_map>
#include <utility>

namespace shapespline {

namespace {

constexpr double certainTurn = std::numbers::pi / 3;
// Number of groups of trusted joints, processed from small to large rotations.
constexpr int certainGroups = 32;
constexpr double openTurn = 0.8 * std::numbers::pi;
// Share of the area. Smaller sets are not reported.
constexpr double smallShare = 0.005;

// Sets of parts with known relative signs.
class SignedSets {
 public:
  struct Member {
    int set;
    bool flipped;  // relative to the set's representative
  };

  explicit SignedSets(std::size_t n) : parent_(n), flipped_(n, 0) { std::iota(parent_.begin(), parent_.end(), 0); }

  Member find(int x) {
    bool flipped = false;
    for (; parent_[x] != x; x = parent_[x]) {
      const int next = parent_[x];  // path halving
      if (parent_[next] != next) {
        flipped_[x] ^= flipped_[next];
        parent_[x] = parent_[next];
      }
      flipped ^= flipped_[x] != 0;
    }
    return {x, flipped};
  }

  // Both must be representatives.
  void join(int set, int other, bool flipped) {
    parent_[other] = set;
    flipped_[other] = flipped;
  }

 private:
  std::vector<int> parent_;
  std::vector<char> flipped_;
};

class SenseSearch {
 public:
  SenseSearch(const std::vector<TurnJoint>& joints, const std::vector<double>& area, std::vector<Quaternion>& turn)
      : joints_(joints), turn_(turn), sets_(turn.size()), area_(area) {}

  std::vector<OpenTurn> run() {
    believeCertainJoints();
    sumEvidence();
    while (!queue_.empty()) joinNext();
    for (std::size_t i = 0; i < turn_.size(); ++i)
      if (sets_.find(static_cast<int>(i)).flipped) turn_[i].coeffs() *= -1;
    return std::move(open_);
  }

 private:
  // Evidence of the joints between two sets: positive if the signs agree.
  struct SignEvidence {
    double sum = 0, length = 0;
  };
  struct Next {
    double strength;
    int a, b;
    bool operator<(const Next& o) const {  // the priority queue serves the greatest entry
      if (strength != o.strength) return strength < o.strength;
      return a != o.a ? a > o.a : b > o.b;
    }
  };
  using Neighbours = std::unordered_map<int, SignEvidence>;

  double dot(const TurnJoint& j) const { return turn_[j.first].dot(turn_[j.second]); }
  static double shorterTurn(double dot) { return 2 * std::acos(std::min(1.0, std::abs(dot))); }

  void believeCertainJoints() {
    std::array<std::vector<int>, certainGroups> groups;
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      const double angle = shorterTurn(dot(joints_[j]));
      if (angle < certainTurn)
        groups[static_cast<int>(angle / certainTurn * certainGroups)].push_back(static_cast<int>(j));
      else uncertain_.push_back(static_cast<int>(j));
    }
    for (const std::vector<int>& group : groups)
      for (const int j : group) {
        const auto a = sets_.find(joints_[j].first), b = sets_.find(joints_[j].second);
        if (a.set == b.set) continue;
        sets_.join(std::min(a.set, b.set), std::max(a.set, b.set), a.flipped ^ b.flipped ^ (dot(joints_[j]) < 0));
      }
    std::vector<double> sum(area_.size(), 0);
    for (std::size_t i = 0; i < area_.size(); ++i) {
      total_ += area_[i];
      sum[sets_.find(static_cast<int>(i)).set] += area_[i];
    }
    area_ = std::move(sum);
  }

  void sumEvidence() {
    for (const int j : uncertain_) {
      const auto a = sets_.find(joints_[j].first), b = sets_.find(joints_[j].second);
      if (a.set == b.set) continue;
      const double cosine = dot(joints_[j]), says = joints_[j].length * (std::numbers::pi - shorterTurn(cosine));
      SignEvidence& evidence = neighbours_[std::min(a.set, b.set)][std::max(a.set, b.set)];
      evidence.sum += a.flipped ^ b.flipped ^ (cosine < 0) ? -says : says;
      evidence.length += joints_[j].length;
    }
    std::vector<Next> pairs;
    for (const auto& [a, others] : neighbours_)
      for (const auto& [b, evidence] : others) pairs.push_back({std::abs(evidence.sum), a, b});
    for (const auto& [strength, a, b] : pairs) neighbours_[b][a] = neighbours_[a][b];
    queue_ = std::priority_queue<Next>({}, std::move(pairs));
  }

  void joinNext() {
    const Next next = queue_.top();
    queue_.pop();
    const auto found = neighbours_[next.a].find(next.b);
    if (found == neighbours_[next.a].end() || std::abs(found->second.sum) != next.strength) return;
    const SignEvidence evidence = found->second;
    const auto [small, large] = area_[next.a] < area_[next.b] ? std::pair(next.a, next.b) : std::pair(next.b, next.a);
    noteIfOpen(small, evidence);
    int set = next.a, other = next.b;
    if (neighbours_[set].size() < neighbours_[other].size()) std::swap(set, other);
    sets_.join(set, other, evidence.sum < 0);
    area_[set] += area_[other];
    neighbours_[set].erase(other);
    neighbours_[other].erase(set);
    for (const auto& [c, toOther] : neighbours_[other]) {
      SignEvidence& sum = neighbours_[set][c];
      sum.sum += evidence.sum < 0 ? -toOther.sum : toOther.sum;
      sum.length += toOther.length;
      neighbours_[c].erase(other);
      neighbours_[c][set] = sum;
      queue_.push({std::abs(sum.sum), std::min(set, c), std::max(set, c)});
    }
    neighbours_.erase(other);
  }

  void noteIfOpen(int set, const SignEvidence& evidence) {
    const double angle = std::numbers::pi - std::abs(evidence.sum) / evidence.length, share = area_[set] / total_;
    if (angle >= openTurn && share >= smallShare) open_.push_back({set, angle, share});
  }

  const std::vector<TurnJoint>& joints_;
  std::vector<Quaternion>& turn_;
  SignedSets sets_;
  std::vector<double> area_;  // area of each set, at its representative
  double total_ = 0;
  std::vector<int> uncertain_;
  std::unordered_map<int, Neighbours> neighbours_;  // keyed by set
  std::priority_queue<Next> queue_;
  std::vector<OpenTurn> open_;
};

}  // namespace

std::vector<OpenTurn> chooseTurnSenses(const std::vector<TurnJoint>& joints, const std::vector<double>& area,
                                       std::vector<Quaternion>& turn) {
  return SenseSearch(joints, area, turn).run();
}

}  // namespace shapespline
