#include "core/sequence/turn_warnings.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>

#include "core/base/format.h"

namespace shapespline {

namespace {

constexpr double degrees = 180 / std::numbers::pi;
// Patches with larger disagreements halfway have rotated in a different direction than their neighbours.
constexpr double ambiguousResidual = 20 / degrees;
// Patches smaller than this share of the mean, and sets of fewer faces than this share or number, get no warning,
// because their rotations are invisible.
constexpr double smallPatch = 0.3;
constexpr double fewFaces = 0.001;
constexpr int fewestFaces = 4;

// `reach`: distance beyond the keys that the page shows, in mean intervals. `openBeyond`: above this mean disagreement,
// noise in the keys moves the shape there by percents of its diagonal. Ordinary poses reach 25 degrees.
constexpr double reach = 0.8, openBeyond = 30 / degrees, agreeing = 1 / degrees;

class TurnWarnings {
 public:
  TurnWarnings(const WeldedShape& shape, const PatchMotion& motion, const std::vector<int>& patchOfFace)
      : shape_(shape), patches_(motion.coordinates()), motion_(motion), patchOfFace_(patchOfFace) {
    double total = 0;
    for (double a : patches_.graph.area()) total += a;
    minArea_ = smallPatch * total / patches_.graph.patchCount();
  }

  // turns: the full turns added in this step.
  void addStep(int step, const AmbiguousFaces* faces, const std::vector<AddedTurns>& turns = {}) {
    step_ = step;
    turns_ = turns;
    if (!decided(-1)) addWhole();
    addComponents();
    addPatches();
    if (faces) addFaces(*faces);
  }

  void addBeyond(const Curve& curve) {
    const double distance = reach * (curve.end() - curve.start()) / (shape_.keys - 1);
    addBeyond(curve.at(curve.start() - distance), 1, 0, "Before key");
    addBeyond(curve.at(curve.end() + distance), shape_.keys - 1, shape_.keys - 1, "Beyond key");
  }

  std::vector<Warning> take() { return std::move(warnings_); }

 private:
  // A user who adds turns has decided the ambiguity.
  bool decided(int component) const {
    return std::any_of(turns_.begin(), turns_.end(),
                       [&](const AddedTurns& t) { return t.turns != 0 && t.component == component; });
  }

  void add(const char* code, const std::string& message, int count, int face, std::vector<int> patches) {
    warnings_.push_back({code, message, count, (step_ + 1) % shape_.keys, face, std::move(patches), "Between"});
  }

  int faceOf(int patch) const {
    return static_cast<int>(std::find(patchOfFace_.begin(), patchOfFace_.end(), patch) - patchOfFace_.begin());
  }

  void addWhole() {
    const double angle = motion_.wholeTurn(step_);
    if (angle <= ambiguousTurn && !motion_.isWholeTurnOpen(step_)) return;
    add("ambiguous-turn",
        "the whole shape rotates by " + angleText(angle) +
            ". The keys alone do not determine the direction or the number of full turns. Add full "
            "turns to the key, or add a key in between.",
        0, -1, {});
  }

  void addComponents() {
    const std::size_t first = patches_.patches.pairs.size();
    std::vector<int> found;
    int face = -1, count = 0;
    double furthest = ambiguousTurn;
    for (std::size_t b = 0; b < patches_.bridgedComponent.size(); ++b) {
      const double angle = patches_.connection.increment[step_][first + b].norm();
      if (angle <= ambiguousTurn || decided(patches_.bridgedComponent[b])) continue;
      for (int k = 0; k < patches_.patches.count; ++k)
        if (patches_.patches.componentOf[k] == patches_.bridgedComponent[b]) found.push_back(k);
      ++count;
      if (angle > furthest) {
        furthest = angle;
        face = faceOf(patches_.graph.links()[first + b].to);
      }
    }
    if (count == 0) return;
    const bool one = count == 1;
    add("ambiguous-component-turn",
        (one ? "a component rotates by " : std::to_string(count) + " components rotate by up to ") +
            angleText(furthest) + " relative to " + (one ? "its neighbour" : "their neighbours") +
            ". The keys alone do not determine the direction or the number of full turns. Add full turns to the "
            "component, or add a key in between.",
        count, face, std::move(found));
  }

  void addPatches() {
    std::vector<int> found;
    int face = -1, count = 0;
    double furthest = 0, angleThere = 0;
    for (std::size_t l = 0; l < patches_.patches.pairs.size(); ++l) {
      const auto [i, j, edges] = patches_.graph.links()[l];
      const double angle = patches_.connection.increment[step_][l].norm(), residual = patches_.residual[step_][l];
      const bool ambiguous = angle > ambiguousTurn || residual > ambiguousResidual;
      if (!ambiguous || std::min(patches_.graph.area()[i], patches_.graph.area()[j]) < minArea_) continue;
      ++count;
      found.insert(found.end(), {i, j});
      const double badness = angle / ambiguousTurn + residual / ambiguousResidual;
      if (badness > furthest) {
        furthest = badness;
        angleThere = angle;
        face = faceOf(j);
      }
    }
    for (const OpenTurn& open : patches_.openTurns[step_]) {
      ++count;
      found.push_back(open.part);
      const double badness = open.angle / ambiguousTurn;
      if (badness > furthest) {
        furthest = badness;
        angleThere = open.angle;
        face = faceOf(open.part);
      }
    }
    if (count == 0) return;
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    add("ambiguous-patch-turn",
        "neighbouring regions rotate by " + angleText(angleThere) +
            " relative to each other, and the keys do not determine the "
            "direction. If the direction is wrong, add a key in between.",
        count, face, std::move(found));
  }

  // Adds no warning if the neighbouring interval already has one. interval: its last key, as in Warning::key.
  void addBeyond(const CurvePoint& point, int interval, int key, const char* about) {
    if (std::any_of(warnings_.begin(), warnings_.end(), [&](const Warning& w) { return w.key == interval; })) return;
    const auto [angle, ofLinks] = motion_.disagreement(point);
    // Links that agree determine all rotations, so noise hardly moves the shape.
    if (ofLinks < agreeing) return;
    const std::vector<double>& area = patches_.graph.area();
    std::vector<int> found;
    double sum = 0, total = 0;
    int worst = 0;
    for (int k = 0; k < static_cast<int>(angle.size()); ++k) {
      sum += area[k] * angle[k];
      total += area[k];
      if (angle[k] > openBeyond) found.push_back(k);
      if (area[k] * angle[k] > area[worst] * angle[worst]) worst = k;
    }
    if (sum <= openBeyond * total) return;
    warnings_.push_back({"open-beyond-keys",
                         "rotations of regions are so large that they disagree by " + angleText(sum / total) +
                             ". Small changes to the keys change the shape there. If it looks wrong, add a key.",
                         static_cast<int>(found.size()), key, faceOf(worst), std::move(found), about});
  }

  void addFaces(const AmbiguousFaces& faces) {
    const double least = std::max<double>(fewestFaces, fewFaces * shape_.faceCount());
    if (faces.worst < 0 || faces.count < least || faces.area < fewFaces) return;
    add("ambiguous-face-turn",
        std::to_string(faces.count) +
            " faces rotate by more than 150 degrees relative to the faces around them, and the keys "
            "do not determine the direction. If the direction is wrong, add a key in between.",
        faces.count, faces.worst, {patchOfFace_[faces.worst]});
  }

  const WeldedShape& shape_;
  const PatchCoordinates& patches_;
  const PatchMotion& motion_;
  const std::vector<int>& patchOfFace_;
  double minArea_;
  int step_ = 0;
  std::vector<AddedTurns> turns_;
  std::vector<Warning> warnings_;
};

}  // namespace

std::vector<Warning> turnWarnings(const WeldedShape& shape, const PatchMotion& patches,
                                  const std::vector<AmbiguousFaces>& faces, const std::vector<int>& patchOfFace,
                                  const std::vector<AddedTurns>& turns, const Curve& curve) {
  TurnWarnings warnings(shape, patches, patchOfFace);
  for (int s = 0; s + 1 < shape.keys; ++s) {
    std::vector<AddedTurns> added;
    std::copy_if(turns.begin(), turns.end(), std::back_inserter(added),
                 [&](const AddedTurns& t) { return t.key == s + 1; });
    warnings.addStep(s, s < static_cast<int>(faces.size()) ? &faces[s] : nullptr, added);
  }
  if (!curve.periodic()) warnings.addBeyond(curve);
  else if (!curve.closesOnLastKey()) warnings.addStep(KeySteps{shape.keys}.closing(), nullptr);
  return warnings.take();
}

}  // namespace shapespline
