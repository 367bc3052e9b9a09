#include "CheckGroupFile.h"

#include "CheckRule.h"
#include "JsonText.h"
#include "Refusal.h"
#include "WholeFile.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace palpate
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr const char* GroupFormat = "palpate check group";
constexpr int GroupVersion = 1;
constexpr std::uintmax_t MostBytes = 256U << 20U;
constexpr const char* GroupRemedy = "write one with palpate check --make-group";
constexpr Eigen::Index OutlineCount = (RadialProbe::Degree + 1) * (RadialProbe::Degree + 1);

// The shortest text of a float: seven digits, which shapes are not known to.
Json ShortList(const double* first, std::size_t count)
{
  Json list = Json::array();
  for (std::size_t n = 0; n < count; ++n)
  {
    list.push_back(static_cast<float>(first[n]));
  }
  return list;
}

// Values whose order matters keep all bits.
Json ExactList(const std::vector<double>& values)
{
  return values;
}

Json LowerTriangle(const Eigen::MatrixXd& matrix)
{
  std::vector<double> values;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
  {
    for (Eigen::Index column = 0; column <= row; ++column)
    {
      values.push_back(matrix(row, column));
    }
  }
  return ShortList(values.data(), values.size());
}

Json GroupOrganJson(const GroupOrgan& organ)
{
  Json statistics = Json::object();
  for (const auto& [key, values] : organ.Statistics)
  {
    statistics[key] = ExactList(values.Sorted());
  }
  const Eigen::VectorXd& mean = organ.Shape.Mean();
  return {{"name", organ.Name},
          {"cases", organ.Cases},
          {"mean_ln_ml", organ.MeanLogVolume},
          {"spread_ln_ml", organ.LogVolumeSpread},
          {"place_mm", ShortList(organ.Place.data(), 3)},
          {"offset_mm", ShortList(organ.PlaceOffset.data(), 3)},
          {"place_spread_mm", ShortList(organ.PlaceSpread.data(), 3)},
          {"statistics", statistics},
          {"outline_mean", ShortList(mean.data(), static_cast<std::size_t>(mean.size()))},
          {"outline_covariance", LowerTriangle(organ.Shape.Covariance())}};
}

// Reads a group; what is not as it is written is refused.
class GroupReader
{
public:
  explicit GroupReader(const std::filesystem::path& file) : File(file) {}

  CheckGroup Read() const
  {
    const nlohmann::json json = ReadJson(this->File, MostBytes, GroupRemedy);
    const auto has = [&](const char* key, const nlohmann::json& value)
    { return json.is_object() && json.contains(key) && json.at(key) == value; };
    this->Require(has("format", GroupFormat), "is not a group of palpate check");
    this->Require(has("version", GroupVersion), "is a group of another version");
    CheckGroup group;
    group.Scores = this->Numbers(json, "scores");
    this->Require(std::is_sorted(group.Scores.begin(), group.Scores.end()), "has unsorted scores");
    for (const nlohmann::json& one : this->ListOf(json, "structures"))
    {
      group.Organs.push_back(this->Organ(one, group.Templates));
    }
    return group;
  }

private:
  void Require(bool isFulfilled, const std::string& fact) const
  {
    if (!isFulfilled)
    {
      Refuse(this->File, fact, GroupRemedy);
    }
  }
  const nlohmann::json& ListOf(const nlohmann::json& json, const char* key) const
  {
    this->Require(json.is_object() && json.contains(key) && json.at(key).is_array(),
                  std::string("has no list \"") + key + "\"");
    return json.at(key);
  }
  std::vector<double> NumbersOf(const nlohmann::json& list) const
  {
    std::vector<double> numbers;
    for (const nlohmann::json& one : list)
    {
      this->Require(one.is_number() && std::abs(one.get<double>()) < 1e12,
                    "has an entry that is not a number of its list");
      numbers.push_back(one.get<double>());
    }
    return numbers;
  }
  std::vector<double> Numbers(const nlohmann::json& json, const char* key) const
  {
    return this->NumbersOf(this->ListOf(json, key));
  }
  Vector3 Point(const nlohmann::json& json, const char* key) const
  {
    const std::vector<double> numbers = this->Numbers(json, key);
    this->Require(numbers.size() == 3, std::string("has no point \"") + key + "\"");
    return {numbers[0], numbers[1], numbers[2]};
  }
  double Number(const nlohmann::json& json, const char* key) const
  {
    this->Require(json.is_object() && json.contains(key) && json.at(key).is_number() &&
                      std::abs(json.at(key).get<double>()) < 1e12,
                  std::string("has no number \"") + key + "\"");
    return json.at(key).get<double>();
  }

  GroupOrgan Organ(const nlohmann::json& json, const OutlineTemplates& templates) const
  {
    GroupOrgan organ;
    this->Require(json.is_object() && json.contains("name") && json.at("name").is_string(),
                  "has a structure without a name");
    organ.Name = json.at("name").get<std::string>();
    const double cases = this->Number(json, "cases");
    this->Require(cases >= 1.0 && cases < 1e6, "has a structure without cases");
    organ.Cases = static_cast<std::size_t>(cases);
    organ.MeanLogVolume = this->Number(json, "mean_ln_ml");
    organ.LogVolumeSpread = this->Number(json, "spread_ln_ml");
    organ.Place = this->Point(json, "place_mm");
    organ.PlaceOffset = this->Point(json, "offset_mm");
    organ.PlaceSpread = this->Point(json, "place_spread_mm");
    this->Require(json.contains("statistics") && json.at("statistics").is_object(),
                  "has a structure without statistics");
    for (const auto& [key, list] : json.at("statistics").items())
    {
      this->Require(list.is_array(), "has a statistic that is not a list");
      if (const CheckRule* const rule = FindCheckRule(key))
      {
        organ.Statistics[key] = TailProbability(this->NumbersOf(list), *rule);
      }
    }
    organ.Shape = this->Shape(json, templates);
    return organ;
  }

  ShapeGroup Shape(const nlohmann::json& json, const OutlineTemplates& templates) const
  {
    const std::vector<double> mean = this->Numbers(json, "outline_mean");
    const std::vector<double> triangle = this->Numbers(json, "outline_covariance");
    this->Require(static_cast<Eigen::Index>(mean.size()) == OutlineCount &&
                      static_cast<Eigen::Index>(triangle.size()) ==
                          OutlineCount * (OutlineCount + 1) / 2,
                  "has an outline of another degree");
    Eigen::MatrixXd covariance(OutlineCount, OutlineCount);
    std::size_t at = 0;
    for (Eigen::Index row = 0; row < OutlineCount; ++row)
    {
      for (Eigen::Index column = 0; column <= row; ++column)
      {
        covariance(row, column) = covariance(column, row) = triangle[at++];
      }
    }
    ShapeGroup shape(Eigen::Map<const Eigen::VectorXd>(mean.data(), OutlineCount), covariance,
                     templates);
    this->Require(shape.IsValid(), "has a covariance that is not positive definite");
    return shape;
  }

  const std::filesystem::path& File;
};
} // namespace

void WriteCheckGroup(const CheckGroup& group, const std::filesystem::path& file)
{
  Json dropped = Json::array();
  for (const CheckGroup::Odd& odd : group.Dropped)
  {
    dropped.push_back({{"case", odd.Case + 1}, {"structure", odd.Organ}, {"rule", odd.Why.Key}});
  }
  Json organs = Json::array();
  for (const GroupOrgan& organ : group.Organs)
  {
    organs.push_back(GroupOrganJson(organ));
  }
  const Json json{{"format", GroupFormat},
                  {"version", GroupVersion},
                  {"scores", ExactList(group.Scores)},
                  {"dropped", dropped},
                  {"structures", organs}};
  WriteWholeFile(file, json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

CheckGroup ReadCheckGroup(const std::filesystem::path& file)
{
  return GroupReader(file).Read();
}
} // namespace palpate
