#include "shapes/bench_parts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "shapes/bench_surface.h"

namespace shapespline {
namespace {

constexpr double bodyShare = 0.55, partsShare = 0.42;  // shares of the faces; cut edges add the rest
constexpr int parts = 20, openings = 5;
constexpr double reach = 1.3;  // distance outside the body's bumps

// A part that rotates about its own centre. Its vertices are first to last - 1.
struct Part {
  Vec3 centre;
  int first, last;
};

// Maps (u, v) in the unit square to a position; u runs along the columns.
using Placing = std::function<Vec3(double u, double v)>;

// A sheet of columns x rows cells. Each cell is cut along a random diagonal, and inner corners move by up to a quarter
// of a cell. With `wraps`, the last column is joined to the first.
Surface sheet(int columns, int rows, bool wraps, const Placing& place, Random& random) {
  Surface surface;
  const int across = columns + (wraps ? 0 : 1);
  const auto moved = [&](int i, bool isEdge) { return i + (isEdge ? 0 : random.uniform(-0.25, 0.25)); };
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i < across; ++i) {
      const double u = moved(i, !wraps && (i == 0 || i == columns)) / columns, v = moved(j, j == 0 || j == rows) / rows;
      surface.positions.push_back(place(u, v));
    }
  const auto at = [&](int i, int j) { return j * across + i % across; };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      int q[4] = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
      if (random.below(2)) std::rotate(q, q + 1, q + 4);
      surface.faces.push_back({q[0], q[1], q[2]});
      surface.faces.push_back({q[0], q[2], q[3]});
    }
  return surface;
}

// A sheet on a cylinder about the body's axis, with roughly square cells.
Surface cylinderSheet(int faces, double angle, double width, double height, double length, Random& random) {
  const bool wraps = width >= 2 * M_PI;
  const double ratio = reach * width / length;
  const int columns = std::max(3, static_cast<int>(std::sqrt(faces / 2.0 * ratio))),
            rows = std::max(1, faces / 2 / columns);
  return sheet(
      columns, rows, wraps,
      [&](double u, double v) {
        const double a = angle + u * width;
        return Vec3(reach * std::cos(a), reach * std::sin(a), height + (v - 0.5) * length);
      },
      random);
}

Surface ball(int faces, const Vec3& centre, double radius, Random& random) {
  Surface surface = gridSphere(faces, random);
  for (Vec3& p : surface.positions) p = centre + radius * p;
  return surface;
}

// A ribbon with two columns of cells. More faces make the cells thinner.
Surface ribbon(int faces, const Vec3& centre, double width, double length, Random& random) {
  const Vec3 side = width * Vec3::UnitZ().cross(centre).normalized();
  return sheet(
      2, faces / 4, false,
      [&](double u, double v) -> Vec3 { return centre + (u - 0.5) * side + (v - 0.5) * length * Vec3::UnitZ(); },
      random);
}

// The kind depends on the index, cyclically.
Surface makePart(int index, int faces, Vec3& centre, Random& random) {
  const double angle = random.uniform(0, 2 * M_PI), height = random.uniform(-capsuleTube / 2, capsuleTube / 2);
  centre = Vec3(reach * std::cos(angle), reach * std::sin(angle), height);
  switch (index % 4) {
    case 0:
      centre = height * Vec3::UnitZ();
      return cylinderSheet(faces, angle, 2 * M_PI, height, random.uniform(0.4, 0.8), random);
    case 1: return cylinderSheet(faces, angle - 0.35, 0.7, height, random.uniform(0.5, 0.9), random);
    case 2: return ball(faces, centre, random.uniform(0.1, 0.2), random);
    default: return ribbon(faces, centre, 0.04, random.uniform(0.8, 1.4), random);
  }
}

void append(Surface& whole, const Surface& part) {
  const int first = static_cast<int>(whole.positions.size());
  whole.positions.insert(whole.positions.end(), part.positions.begin(), part.positions.end());
  for (const Triangle& face : part.faces) whole.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
}

// Removes unused vertices.
void dropUnused(Surface& surface) {
  std::vector<int> place(surface.positions.size(), -1);
  Positions used;
  for (Triangle& face : surface.faces)
    for (int& v : face) {
      if (place[v] < 0) {
        place[v] = static_cast<int>(used.size());
        used.push_back(surface.positions[v]);
      }
      v = place[v];
    }
  surface.positions = std::move(used);
}

// Removes faces within a distance of random points on the tube. The resulting edges stay ragged.
void cutOpenings(Surface& surface, Random& random) {
  for (int i = 0; i < openings; ++i) {
    const double angle = random.uniform(0, 2 * M_PI), size = random.uniform(0.15, 0.35);
    const Vec3 centre(std::cos(angle), std::sin(angle), random.uniform(-capsuleTube / 2, capsuleTube / 2));
    std::erase_if(surface.faces, [&](const Triangle& face) {
      const Vec3 middle = (surface.positions[face[0]] + surface.positions[face[1]] + surface.positions[face[2]]) / 3;
      return (middle - capsuleRadius * centre).norm() < size;
    });
  }
  if (surface.faces.size() % 2) surface.faces.pop_back();
  dropUnused(surface);
}

// Splits edges up to this number of faces, one in four near an end.
void cutEdges(Surface& surface, int faces, Random& random) {
  splitEdges(surface, faces, random, [&] { return random.below(4) ? 0.5 : 0.02; });
}

std::vector<Part> addParts(Surface& surface, int faces, Random& random) {
  std::vector<Part> result;
  for (int i = 0; i < parts; ++i) {
    Part part{Vec3::Zero(), static_cast<int>(surface.positions.size()), 0};
    Surface own = makePart(i, faces / parts, part.centre, random);
    cutEdges(own, static_cast<int>(1.02 * own.faces.size()), random);
    append(surface, own);
    part.last = static_cast<int>(surface.positions.size());
    result.push_back(part);
  }
  return result;
}

// Adds the body with the faces left after the parts.
void addBody(Surface& surface, int faces, Random& random) {
  Surface body = bumpyCapsule(2 * static_cast<int>(bodyShare * faces / 2), random);
  cutOpenings(body, random);
  cutEdges(body, faces - static_cast<int>(surface.faces.size()), random);
  append(surface, body);
}

void turnParts(const std::vector<Part>& parts, Positions& positions, Random& random) {
  for (const Part& part : parts) {
    Vec3 axis;
    for (double& x : axis) x = random.uniform(-1, 1);
    const Eigen::AngleAxisd turn(random.uniform(-60, 60) * M_PI / 180, axis.normalized());
    for (int v = part.first; v < part.last; ++v) positions[v] = part.centre + turn * (positions[v] - part.centre);
  }
}

}  // namespace

Keyframes makeBenchParts(int faces, int keys, std::uint32_t seed) {
  Random random(seed);
  faces = std::max(2400, faces + faces % 2);
  keys = std::max(2, keys);
  Surface surface;
  const std::vector<Part> parts = addParts(surface, static_cast<int>(partsShare * faces), random);
  addBody(surface, faces, random);
  const Positions straight = surface.positions;
  const std::vector<int> place = shuffle(surface, random);

  Keyframes result;
  for (int j = 0; j < keys; ++j) {
    Positions turned = straight;
    if (j > 0) turnParts(parts, turned, random);
    const Deformation d = j > 0 ? randomDeformation(random) : Deformation{};
    Key key{"key " + std::to_string(j + 1), double(j) / (keys - 1), Positions(turned.size())};
    for (std::size_t v = 0; v < turned.size(); ++v) key.positions[place[v]] = deformed(d, turned[v]);
    result.keys.push_back(std::move(key));
  }
  result.faces = std::move(surface.faces);
  return result;
}

}  // namespace shapespline
