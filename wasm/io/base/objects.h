// The objects of a file by their names: which there are, and which are taken.
#pragma once

#include <string>
#include <vector>

#include "core/base/status.h"

namespace shapespline {

/// More names than anybody would choose from.
constexpr std::size_t mostObjects = 1000;

/// Adds a name unless it is in the list.
void addObject(const std::string& name, std::vector<std::string>& names);

/// Whether the name is one of these.
bool holdsObject(const std::vector<std::string>& names, const std::string& name);

/// Whether an object of this name is wanted; an empty list means all.
bool takesObject(const std::vector<std::string>& wanted, const std::string& name);

/// At most twenty names in quotes, separated by commas, or "none".
std::string objectList(const std::vector<std::string>& names);

/// Error: UnknownObject with the existing names, if a wanted name does not exist.
Status checkObjects(const std::vector<std::string>& wanted, const std::vector<std::string>& names,
                    const std::string& where);

}  // namespace shapespline
