#pragma once

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace palpate::test
{
/// The objects of an output with one JSON object per line.
inline std::vector<nlohmann::json> Lines(const std::string& text)
{
  std::vector<nlohmann::json> objects;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    objects.push_back(nlohmann::json::parse(line));
  }
  return objects;
}
} // namespace palpate::test
