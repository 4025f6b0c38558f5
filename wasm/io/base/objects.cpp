#include "io/base/objects.h"

#include <algorithm>
#include <utility>

#include "io/base/byte_text.h"

namespace shapespline {

namespace {

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

void addObject(const std::string& name, std::vector<std::string>& names) {
  if (names.size() < kMostObjects && !holds(names, name)) names.push_back(name);
}

bool takesObject(const std::vector<std::string>& wanted, const std::string& name) {
  return wanted.empty() || holds(wanted, name);
}

Status checkObjects(const std::vector<std::string>& wanted, const std::vector<std::string>& names,
                    const std::string& where) {
  for (const std::string& name : wanted) {
    if (holds(names, name)) continue;
    std::string message = where;
    message.append(" has no object ").append(inQuotes(name)).append(names.empty() ? "; it names none." : "; it has");
    for (std::size_t i = 0; i < names.size() && i < 20; ++i) message.append(i ? ", " : " ").append(inQuotes(names[i]));
    if (!names.empty()) message.append(names.size() > 20 ? ", and more." : ".");
    return Error{ErrorCode::UnknownObject, std::move(message)};
  }
  return {};
}

}  // namespace shapespline
