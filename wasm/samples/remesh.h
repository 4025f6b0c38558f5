// Isotropic remeshing of an implicit surface (after Botsch and Kobbelt 2004).
#pragma once

#include <functional>

#include "samples/implicit.h"
#include "samples/surface.h"

namespace shapespline {

/// Wanted edge length at a point; should vary slowly.
using EdgeLength = std::function<double(const Vec3&)>;

/// Nearly equilateral triangles with edges near the wanted length and vertices on the field's zero set.
/// Splits, collapses, flips, relaxes and projects, `rounds` times.
Surface remesh(Surface surface, const Field& field, const EdgeLength& edge, int rounds);

/// The body's surface: polygonised and remeshed to its limbs' wanted edge lengths.
Surface makeSurface(const Body& body);

}  // namespace shapespline
