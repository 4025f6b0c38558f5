// Groups components that belong to one rigid body, and separates the others.
#pragma once

#include <vector>

#include "core/hold/hold_system.h"

namespace shapespline {

/// Whether a component stays joined to its parent: the joint barely moves in the keys, or both parts touch in all keys.
bool staysJoined(const HoldMesh& mesh, const ComponentJoint& joint);

/// Rigid group of each vertex, numbered by first vertex. Components of a group are joined to each other.
std::vector<int> rigidGroupsOf(const HoldMesh& mesh);

}  // namespace shapespline
