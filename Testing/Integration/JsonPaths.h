#pragma once

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

namespace palpate::test
{
/// Adds the paths of all values of a JSON document: "a.b" for a key in an object, "a[]" for the
/// elements of a list; an empty list counts as one unknown element.
inline void AddJsonPaths(const nlohmann::json& value, const std::string& path,
                         std::set<std::string>& paths)
{
  if (value.is_object())
  {
    for (const auto& [key, entry] : value.items())
    {
      AddJsonPaths(entry, path.empty() ? key : path + "." + key, paths);
    }
    return;
  }
  if (!value.is_array() || value.empty())
  {
    paths.insert(value.is_array() ? path + "[]" : path);
    return;
  }
  for (const nlohmann::json& entry : value)
  {
    AddJsonPaths(entry, path + "[]", paths);
  }
}
} // namespace palpate::test
