#include "CheckGroupFile.h"

#include "CheckRule.h"
#include "JsonNumbers.h"
#include "JsonText.h"
#include "WholeFile.h"

#include <algorithm>
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

// Values whose order matters keep all bits.
Json ExactList(const std::vector<double>& values)
{
  return values;
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
          {"place_mm", ShortNumbers(organ.Place.data(), 3)},
          {"offset_mm", ShortNumbers(organ.PlaceOffset.data(), 3)},
          {"place_spread_mm", ShortNumbers(organ.PlaceSpread.data(), 3)},
          {"statistics", statistics},
          {"outline_mean", ShortNumbers(mean.data(), static_cast<std::size_t>(mean.size()))},
          {"outline_covariance", LowerTriangle(organ.Shape.Covariance())}};
}

// Reads a group; what is not as it is written is refused.
class GroupReader
{
public:
  explicit GroupReader(const std::filesystem::path& file) : File(file), Checked(file, GroupRemedy)
  {
  }

  CheckGroup Read() const
  {
    const nlohmann::json json = ReadJson(this->File, MostBytes, GroupRemedy);
    this->Checked.RequireFormat(json, GroupFormat, GroupVersion, "a group of palpate check");
    CheckGroup group;
    group.Scores = this->Checked.Numbers(json, "scores");
    this->Require(std::is_sorted(group.Scores.begin(), group.Scores.end()), "has unsorted scores");
    for (const nlohmann::json& one : this->Checked.List(json, "structures"))
    {
      group.Organs.push_back(this->Organ(one, group.Templates));
    }
    return group;
  }

private:
  void Require(bool isFulfilled, const std::string& fact) const
  {
    this->Checked.Require(isFulfilled, fact);
  }
  Vector3 Point(const nlohmann::json& json, const char* key) const
  {
    const std::vector<double> numbers = this->Checked.Numbers(json, key);
    this->Require(numbers.size() == 3, std::string("has no point \"") + key + "\"");
    return {numbers[0], numbers[1], numbers[2]};
  }

  GroupOrgan Organ(const nlohmann::json& json, const OutlineTemplates& templates) const
  {
    GroupOrgan organ;
    this->Require(json.is_object() && json.contains("name") && json.at("name").is_string(),
                  "has a structure without a name");
    organ.Name = json.at("name").get<std::string>();
    const double cases = this->Checked.Number(json, "cases");
    this->Require(cases >= 1.0 && cases < 1e6, "has a structure without cases");
    organ.Cases = static_cast<std::size_t>(cases);
    organ.MeanLogVolume = this->Checked.Number(json, "mean_ln_ml");
    organ.LogVolumeSpread = this->Checked.Number(json, "spread_ln_ml");
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
        organ.Statistics[key] = TailProbability(this->Checked.NumbersOf(list), *rule);
      }
    }
    organ.Shape = this->Shape(json, templates);
    return organ;
  }

  ShapeGroup Shape(const nlohmann::json& json, const OutlineTemplates& templates) const
  {
    const std::vector<double> mean = this->Checked.Numbers(json, "outline_mean");
    const std::vector<double> triangle = this->Checked.Numbers(json, "outline_covariance");
    this->Require(static_cast<Eigen::Index>(mean.size()) == OutlineCount &&
                      static_cast<Eigen::Index>(triangle.size()) ==
                          OutlineCount * (OutlineCount + 1) / 2,
                  "has an outline of another degree");
    ShapeGroup shape(Eigen::Map<const Eigen::VectorXd>(mean.data(), OutlineCount),
                     SymmetricMatrix(triangle, OutlineCount), templates);
    this->Require(shape.IsValid(), "has a covariance that is not positive definite");
    return shape;
  }

  const std::filesystem::path& File;
  JsonNumbers Checked;
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
