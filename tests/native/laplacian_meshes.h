// Generated triangle meshes and their cotangent Laplacians, for the solver tests.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "core/base/types.h"
#include "core/sparse/sparse_matrix.h"
#include "shapes/random.h"

namespace shapespline::test {

struct PlainMesh {
  std::vector<Vec3> positions;
  std::vector<Triangle> faces;
};

/// Numbers the vertices in random order.
inline void shuffleVertices(PlainMesh& mesh, Random& random) {
  const int n = static_cast<int>(mesh.positions.size());
  std::vector<int> to(n);
  std::iota(to.begin(), to.end(), 0);
  for (int i = n - 1; i > 0; --i) std::swap(to[i], to[random.below(i + 1)]);
  std::vector<Vec3> moved(n);
  for (int v = 0; v < n; ++v) moved[to[v]] = mesh.positions[v];
  mesh.positions = std::move(moved);
  for (Triangle& face : mesh.faces)
    for (int& v : face) v = to[v];
}

/// A wavy sheet of columns x rows vertices with irregular diagonals and points.
inline PlainMesh irregularSheet(int columns, int rows, Random& random) {
  PlainMesh mesh;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      mesh.positions.push_back(
          {x + 0.3 * random.signedUnit(), y + 0.3 * random.signedUnit(), 3.0 * std::sin(0.2 * x) * std::cos(0.15 * y)});
  for (int y = 0; y + 1 < rows; ++y) {
    for (int x = 0; x + 1 < columns; ++x) {
      const int a = y * columns + x, b = a + 1, c = a + columns, d = c + 1;
      if (random.below(2)) mesh.faces.insert(mesh.faces.end(), {{a, b, d}, {a, d, c}});
      else mesh.faces.insert(mesh.faces.end(), {{a, b, c}, {b, d, c}});
    }
  }
  return mesh;
}

/// A bumpy sphere of 10 f^2 + 2 irregular points: every face of an icosahedron is cut into f^2 triangles.
inline PlainMesh bumpySphere(int f, Random& random) {
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  const std::array<Vec3, 12> corner = {{{-1, g, 0},
                                        {1, g, 0},
                                        {-1, -g, 0},
                                        {1, -g, 0},
                                        {0, -1, g},
                                        {0, 1, g},
                                        {0, -1, -g},
                                        {0, 1, -g},
                                        {g, 0, -1},
                                        {g, 0, 1},
                                        {-g, 0, -1},
                                        {-g, 0, 1}}};
  constexpr int icosahedronFaces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                           {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                           {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                           {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  PlainMesh mesh;
  mesh.positions.assign(corner.begin(), corner.end());
  std::map<std::pair<int, int>, int> edgeStart;  // first of the f - 1 points on an edge, from its lower corner
  for (const auto& face : icosahedronFaces)
    for (int k = 0; k < 3; ++k) {
      const int a = std::min(face[k], face[(k + 1) % 3]), b = std::max(face[k], face[(k + 1) % 3]);
      if (!edgeStart.try_emplace({a, b}, static_cast<int>(mesh.positions.size())).second) continue;
      for (int i = 1; i < f; ++i) mesh.positions.push_back(corner[a] + (corner[b] - corner[a]) * i / f);
    }
  const auto onEdge = [&](int a, int b, int i) {  // i of f steps from a to b
    if (i == 0) return a;
    if (i == f) return b;
    return a < b ? edgeStart.at({a, b}) + i - 1 : edgeStart.at({b, a}) + f - i - 1;
  };
  for (const auto& face : icosahedronFaces) {
    const int a = face[0], b = face[1], c = face[2];
    std::vector<std::vector<int>> lattice(f + 1);
    for (int i = 0; i <= f; ++i) {  // rows from a towards the edge b c
      for (int j = 0; j <= i; ++j) {
        if (j == 0) lattice[i].push_back(onEdge(a, b, i));
        else if (j == i) lattice[i].push_back(onEdge(a, c, i));
        else if (i == f) lattice[i].push_back(onEdge(b, c, j));
        else {
          lattice[i].push_back(static_cast<int>(mesh.positions.size()));
          mesh.positions.push_back(corner[a] + (corner[b] - corner[a]) * (i - j) / f + (corner[c] - corner[a]) * j / f);
        }
      }
    }
    for (int i = 0; i < f; ++i) {
      for (int j = 0; j <= i; ++j) {
        mesh.faces.push_back({lattice[i][j], lattice[i + 1][j], lattice[i + 1][j + 1]});
        if (j < i) mesh.faces.push_back({lattice[i][j], lattice[i + 1][j + 1], lattice[i][j + 1]});
      }
    }
  }
  for (Vec3& p : mesh.positions) {
    p.normalize();
    p += Vec3(random.signedUnit(), random.signedUnit(), random.signedUnit()) * (0.25 / f);
    p *= 1.0 + 0.15 * std::sin(5.0 * p.x()) * std::cos(4.0 * p.y() + 1.0) + 0.1 * std::sin(7.0 * p.z());
  }
  return mesh;
}

/// Triplets of the cotangent Laplacian (positive semi-definite). Cotangents are clamped to [-limit, limit].
inline std::vector<Triplet> cotangentTriplets(const PlainMesh& mesh, double limit = 1e12) {
  std::vector<Triplet> triplets;
  for (const Triangle& face : mesh.faces) {
    for (int k = 0; k < 3; ++k) {
      const int o = face[k], a = face[(k + 1) % 3], b = face[(k + 2) % 3];
      const Vec3 u = mesh.positions[a] - mesh.positions[o], v = mesh.positions[b] - mesh.positions[o];
      const double weight = 0.5 * std::clamp(u.dot(v) / u.cross(v).norm(), -limit, limit);
      triplets.push_back({std::max(a, b), std::min(a, b), -weight});
      triplets.push_back({a, a, weight});
      triplets.push_back({b, b, weight});
    }
  }
  return triplets;
}

/// The Laplacian with vertex 0 pinned by a weight of one.
inline SymmetricMatrix pinnedLaplacian(const PlainMesh& mesh) {
  std::vector<Triplet> triplets = cotangentTriplets(mesh);
  triplets.push_back({0, 0, 1.0});
  return assembleSymmetric(static_cast<int>(mesh.positions.size()), triplets);
}

}  // namespace shapespline::test
