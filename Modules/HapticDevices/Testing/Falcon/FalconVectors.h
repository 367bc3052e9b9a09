#pragma once

#include "TestData.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace palpate::test
{
/// Tables of positions and forces computed to 40 digits independently of this project. They are
/// stored with the real data and may be absent.
inline std::filesystem::path FalconVectorsPath(const std::string& name)
{
  return DataPath("../notes/" + name);
}

/// The numbers of a table with one line of headings.
inline std::vector<std::vector<double>> ReadRows(const std::filesystem::path& path)
{
  std::ifstream stream(path);
  std::string line;
  std::getline(stream, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(stream, line))
  {
    std::istringstream cells(line);
    std::vector<double>& row = rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');)
    {
      row.push_back(std::stod(cell));
    }
  }
  return rows;
}
} // namespace palpate::test
