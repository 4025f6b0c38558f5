#include "io/base/objects.h"

#include <algorithm>
#include <utility>

#include "io/base/byte_text.h"

namespace shapespline {

bool hasObject(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void addObject(const std::string& name, std::vector<std::string>& names) {
  if (names.size() < maxObjects && !hasObject(names, name)) names.push_back(name);
}

bool takesObject(const std::vector<std::string>& wanted, const std::string& name) {
  return wanted.empty() || hasObject(wanted, name);
}

std::string objectList(const std::vector<std::string>& names) {
  if (names.empty()) return "none";
  std::string list;
  for (std::size_t i = 0; i < names.size() && i < 20; ++i) list.append(i ? ", " : "").append(inQuotes(names[i]));
  return names.size() > 20 ? list + ", and more" : list;
}

Status checkObjects(const std::vector<std::string>& wanted, const std::vector<std::string>& names,
                    const std::string& where) {
  for (const std::string& name : wanted) {
    if (hasObject(names, name)) continue;
    std::string message = where;
    message.append(" has no object ").append(inQuotes(name)).append(names.empty() ? "; named objects: " : "; it has ");
    message.append(objectList(names)).append(".");
    return Error{ErrorCode::UnknownObject, std::move(message)};
  }
  return {};
}

}  // namespace shapespline
