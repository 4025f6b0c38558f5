// The objects of a file by their names: which there are, and which are taken.
#pragma once

#include <string>
#include <vector>

#include "core/base/status.h"

namespace shapespline {

/// More names than anybody would choose from.
constexpr std::size_t kMostObjects = 1000;

/// Adds a name to those that are there, once.
void addObject(const std::string& name, std::vector<std::string>& names);

/// Whether the name is one of these.
bool holdsObject(const std::vector<std::string>& names, const std::string& name);

/// Whether an object of this name is among the wanted ones; none wanted are all.
bool takesObject(const std::vector<std::string>& wanted, const std::string& name);

/// The names in quotes, with commas; "none", and no more than twenty of them.
std::string objectList(const std::vector<std::string>& names);

/// Error: UnknownObject, with the names that there are, where one of the wanted is not among them.
Status checkObjects(const std::vector<std::string>& wanted, const std::vector<std::string>& names,
                    const std::string& where);

}  // namespace shapespline
