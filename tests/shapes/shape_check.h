// Quality checks of a sample: closed, oriented, well-shaped triangles, no self-intersection.
#pragma once

#include "core/sequence/keyframes.h"

namespace shapespline {

/// Every edge belongs to two faces that run along it in opposite directions, and every vertex to one fan of faces.
bool isClosedManifold(const std::vector<Triangle>& faces, int vertices);

/// The smallest angle of any face, in degrees.
double smallestAngle(const std::vector<Triangle>& faces, const Positions& positions);

/// The largest angle between the normals of two faces that share an edge, in degrees; 180 is a fold.
double sharpestEdge(const std::vector<Triangle>& faces, const Positions& positions);

/// Pairs of faces without a common vertex that cut each other.
int selfIntersections(const std::vector<Triangle>& faces, const Positions& positions);

}  // namespace shapespline
