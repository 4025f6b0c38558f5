// Quality checks of a sample: closed, oriented, well-shaped triangles, no self-intersection.
#pragma once

#include "core/sequence/keyframes.h"

namespace shapespline {

/// Whether every edge belongs to two faces with opposite directions, and every vertex to one fan of faces.
bool isClosedManifold(const std::vector<Triangle>& faces, int vertices);

/// The smallest angle of any face, in degrees.
double smallestAngle(const std::vector<Triangle>& faces, const Positions& positions);

/// The largest angle between the normals of two faces at an edge, in degrees. A fold has 180.
double sharpestEdge(const std::vector<Triangle>& faces, const Positions& positions);

/// Number of intersecting pairs of faces without a common vertex.
int selfIntersections(const std::vector<Triangle>& faces, const Positions& positions);

}  // namespace shapespline
