// Object names of a file: available and selected.
#pragma once

#include <string>
#include <vector>

#include "core/base/status.h"

namespace shapespline {

/// Most names in a list of objects. A longer list is useless for choosing.
constexpr std::size_t maxObjects = 1000;

/// Appends a name unless the list has it already.
void addObject(const std::string& name, std::vector<std::string>& names);

/// Whether the list contains the name.
bool hasObject(const std::vector<std::string>& names, const std::string& name);

/// Whether an object with this name is selected. An empty list selects all.
bool takesObject(const std::vector<std::string>& wanted, const std::string& name);

/// At most twenty names in quotes, separated by commas, or "none".
std::string objectList(const std::vector<std::string>& names);

/// Error: UnknownObject, listing the existing names, if a requested name does not exist.
Status checkObjects(const std::vector<std::string>& wanted, const std::vector<std::string>& names,
                    const std::string& where);

}  // namespace shapespline
