#include "JsonNumbers.h"

#include "DecimalText.h"
#include "Refusal.h"

#include <cmath>

namespace palpate
{
namespace
{
constexpr double LargestNumber = 1e12;

bool IsSound(const nlohmann::json& number)
{
  return number.is_number() && std::abs(number.get<double>()) < LargestNumber;
}
} // namespace

nlohmann::ordered_json ShortNumbers(const double* first, std::size_t count)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t n = 0; n < count; ++n)
  {
    // As a float the library would write all digits of the equal double.
    list.push_back(ParseNumber(ExactText(static_cast<float>(first[n]))).value_or(0.0));
  }
  return list;
}

nlohmann::ordered_json PointJson(const Vector3& point)
{
  return {point.x(), point.y(), point.z()};
}

nlohmann::ordered_json LowerTriangle(const Eigen::MatrixXd& matrix)
{
  std::vector<double> values;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
  {
    for (Eigen::Index column = 0; column <= row; ++column)
    {
      values.push_back(matrix(row, column));
    }
  }
  return ShortNumbers(values.data(), values.size());
}

Eigen::MatrixXd SymmetricMatrix(const std::vector<double>& triangle, Eigen::Index count)
{
  Eigen::MatrixXd matrix(count, count);
  std::size_t at = 0;
  for (Eigen::Index row = 0; row < count; ++row)
  {
    for (Eigen::Index column = 0; column <= row; ++column)
    {
      matrix(row, column) = matrix(column, row) = triangle[at++];
    }
  }
  return matrix;
}

void JsonNumbers::Require(bool isFulfilled, const std::string& fact) const
{
  if (!isFulfilled)
  {
    Refuse(this->File, fact, this->Remedy);
  }
}

void JsonNumbers::RequireFormat(const nlohmann::json& json, const char* format, int version,
                                const std::string& kind) const
{
  const bool isFormat = json.is_object() && json.contains("format") &&
                        json.at("format").is_string() &&
                        json.at("format").get_ref<const std::string&>() == format;
  this->Require(isFormat, "is not " + kind);
  this->Require(json.contains("version") && json.at("version").is_number() &&
                    json.at("version").get<double>() == version,
                "is " + kind + " of another version");
}

const nlohmann::json& JsonNumbers::List(const nlohmann::json& json, const char* key) const
{
  this->Require(json.is_object() && json.contains(key) && json.at(key).is_array(),
                std::string("has no list \"") + key + "\"");
  return json.at(key);
}

std::vector<double> JsonNumbers::NumbersOf(const nlohmann::json& list) const
{
  std::vector<double> numbers;
  for (const nlohmann::json& one : list)
  {
    this->Require(IsSound(one), "has an entry that is not a number of its list");
    numbers.push_back(one.get<double>());
  }
  return numbers;
}

std::vector<double> JsonNumbers::Numbers(const nlohmann::json& json, const char* key) const
{
  return this->NumbersOf(this->List(json, key));
}

double JsonNumbers::Number(const nlohmann::json& json, const char* key) const
{
  this->Require(json.is_object() && json.contains(key) && IsSound(json.at(key)),
                std::string("has no number \"") + key + "\"");
  return json.at(key).get<double>();
}
} // namespace palpate
