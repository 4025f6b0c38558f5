#include "core/sequence/timing_regions.h"

#include <algorithm>
#include <utility>

#include "core/base/format.h"

namespace shapespline {

namespace {

using Shares = std::vector<std::vector<double>>;  // [patch][region], the whole last; rows sum to 1

constexpr int softRings = 2;

Error invalid(std::string message) { return {ErrorCode::InvalidOption, std::move(message)}; }

// Region of each input face; the number of regions for faces in none.
Result<std::vector<int>> regionOfFaces(const std::vector<TimingRegion>& regions, std::size_t faces) {
  const auto count = static_cast<int>(regions.size());
  std::vector<int> regionOf(faces, count);
  for (int r = count - 1; r >= 0; --r) {
    const std::vector<int>& runs = regions[r].faces;
    if (runs.size() % 2 != 0) return invalid("The faces of a region are not complete runs: first face and number.");
    for (std::size_t i = 0; i < runs.size(); i += 2) {
      const std::int64_t first = runs[i], end = first + runs[i + 1];
      if (first < 0 || runs[i + 1] < 0 || end > static_cast<std::int64_t>(faces))
        return invalid("A region has faces up to number " + grouped(end) + ", but the shape has " + grouped(faces) +
                       ".");
      std::fill(regionOf.begin() + first, regionOf.begin() + end, r);
    }
  }
  return regionOf;
}

Shares sharesOf(const EncodedShape& encoded, const std::vector<int>& regionOf, std::size_t regions) {
  const LriSpace& lri = encoded.lri();
  const WeldedShape& shape = encoded.shape();
  const std::vector<int>& inputFaceOf = encoded.input().inputFaceOf;
  Shares shares(lri.patches().coordinates().graph.area().size(), std::vector<double>(regions + 1, 0));
  for (int f = 0; f < shape.faceCount(); ++f)
    if (const int patch = lri.patchOfFace()[f]; patch >= 0)
      shares[patch][regionOf[inputFaceOf[f]]] += referenceFrame(shape, f).area;
  for (std::vector<double>& row : shares) {
    double area = 0;
    for (const double part : row) area += part;
    if (area == 0) row.back() = area = 1;  // a patch of a ghost that no face follows
    for (double& part : row) part /= area;
  }
  return shares;
}

// The mean of each patch and its neighbours.
Shares softened(const Shares& shares, const PatchGraph& graph) {
  Shares mean = shares;
  std::vector<double> count(shares.size(), 1);
  const auto add = [&](int to, int from) {
    for (std::size_t r = 0; r < mean[to].size(); ++r) mean[to][r] += shares[from][r];
    count[to] += 1;
  };
  for (const PatchLink& link : graph.links()) {
    add(link.from, link.to);
    add(link.to, link.from);
  }
  for (std::size_t k = 0; k < mean.size(); ++k)
    for (double& share : mean[k]) share /= count[k];
  return mean;
}

// Soft regions are softened. All shares are scaled to the sum 1.
void soften(const std::vector<TimingRegion>& regions, const PatchGraph& graph, Shares& shares) {
  Shares soft = shares;
  for (int i = 0; i < softRings; ++i) soft = softened(soft, graph);
  for (std::size_t k = 0; k < shares.size(); ++k) {
    double taken = 0;
    for (std::size_t r = 0; r < regions.size(); ++r) {
      if (regions[r].soft) shares[k][r] = soft[k][r];
      taken += shares[k][r];
    }
    for (double& share : shares[k]) share /= std::max(1.0, taken);
    shares[k].back() = std::max(0.0, 1 - taken);
  }
}

void addShare(double share, const std::vector<double>& values, std::vector<double>& sum) {
  for (std::size_t j = 0; j < values.size(); ++j) sum[j] += share * values[j];
}

KeyTiming meanTiming(const std::vector<double>& shares, const std::vector<const KeyTiming*>& timings, int keys) {
  const auto count = static_cast<std::size_t>(keys);
  KeyTiming mean{std::vector<double>(count, 0), std::vector<double>(count, 0)};
  for (std::size_t r = 0; r < timings.size(); ++r) {
    addShare(shares[r], timings[r]->earlier, mean.earlier);
    addShare(shares[r], timings[r]->swing, mean.swing);
  }
  return mean;
}

Status checkCounts(const KeyTiming& timing, int keys) {
  for (const std::vector<double>* values : {&timing.earlier, &timing.swing})
    if (!values->empty() && static_cast<int>(values->size()) != keys)
      return invalid("The timing of a region has " + grouped(values->size()) + " values for " + grouped(keys) +
                     " keys. Give one per key, or none.");
  return {};
}

}  // namespace

Result<RegionTimings> regionTimings(const EncodedShape& encoded, const KeyTiming& whole,
                                    const std::vector<TimingRegion>& regions) {
  const int keys = encoded.shape().keys;
  std::vector<const KeyTiming*> timings;
  const KeyTiming* position = nullptr;
  for (const TimingRegion& region : regions) {
    if (Status status = checkCounts(region.timing, keys); !status) return status.error();
    timings.push_back(&region.timing);
    if (!region.faces.empty()) continue;
    if (position) return invalid("Two regions have no faces. Only one can have the timing of the position.");
    position = &region.timing;
  }
  if (Status status = checkCounts(whole, keys); !status) return status.error();
  timings.push_back(&whole);
  auto regionOf = regionOfFaces(regions, encoded.componentOfInputFace().size());
  if (!regionOf) return regionOf.error();

  const PatchGraph& graph = encoded.lri().patches().coordinates().graph;
  Shares shares = sharesOf(encoded, *regionOf, regions.size());
  soften(regions, graph, shares);
  RegionTimings result{{}, {position ? *position : whole}, std::make_shared<PatchParts>()};
  Shares rows;  // of the parts, each once
  std::vector<double> mean(regions.size() + 1, 0);
  double total = 0;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    const auto part = std::find(rows.begin(), rows.end(), shares[k]) - rows.begin();
    result.patches->ofPatch.push_back(static_cast<int>(part));
    if (part == std::ssize(rows)) {
      rows.push_back(shares[k]);
      result.parts.push_back(meanTiming(shares[k], timings, keys));
    }
    const double area = graph.area()[k];
    for (std::size_t r = 0; r < mean.size(); ++r) mean[r] += area * shares[k][r];
    total += area;
  }
  for (double& share : mean) share /= total;
  result.mean = meanTiming(mean, timings, keys);
  return result;
}

}  // namespace shapespline
