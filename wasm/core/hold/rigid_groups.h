// Which components of a shape are parts of one body, and which are objects of their own.
#pragma once

#include <vector>

#include "core/hold/hold_system.h"

namespace shapespline {

/// Whether a component stays joined to what carries it: the point that is to move least against both does hardly move
/// in the keys, or the two touch in all of them.
bool staysJoined(const HoldMesh& mesh, const ComponentJoint& joint);

/// Body of each vertex, numbered by their first vertices. Parts of one body are joined to each other.
std::vector<int> rigidGroupsOf(const HoldMesh& mesh);

}  // namespace shapespline
