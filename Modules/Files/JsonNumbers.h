#pragma once

#include "Vector3.h"

#include <Eigen/Core>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace palpate
{
/// Numbers in the shortest text of a float: seven digits, which shapes are not known to.
nlohmann::ordered_json ShortNumbers(const double* first, std::size_t count);
/// A point or direction as a list of its coordinates.
nlohmann::ordered_json PointJson(const Vector3& point);
/// The lower triangle of a symmetric matrix, row by row, and the matrix of one; of `count` rows.
nlohmann::ordered_json LowerTriangle(const Eigen::MatrixXd& matrix);
Eigen::MatrixXd SymmetricMatrix(const std::vector<double>& triangle, Eigen::Index count);

/// Entries of an object of numbers, every one checked: finite and below 1e12. What is missing or
/// else is refused, naming the file (Refuse).
class JsonNumbers
{
public:
  JsonNumbers(const std::filesystem::path& file, std::string remedy)
      : File(file), Remedy(std::move(remedy))
  {
  }

  void Require(bool isFulfilled, const std::string& fact) const;
  /// That the object is of a format and version; `kind` names it: "a group of palpate check".
  void RequireFormat(const nlohmann::json& json, const char* format, int version,
                     const std::string& kind) const;
  const nlohmann::json& List(const nlohmann::json& json, const char* key) const;
  std::vector<double> NumbersOf(const nlohmann::json& list) const;
  std::vector<double> Numbers(const nlohmann::json& json, const char* key) const;
  double Number(const nlohmann::json& json, const char* key) const;

private:
  std::filesystem::path File;
  std::string Remedy;
};
} // namespace palpate
