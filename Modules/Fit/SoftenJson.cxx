#include "SoftenJson.h"

#include "JsonSchema.h"
#include "PatientSides.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace palpate
{
namespace
{
using Json = nlohmann::ordered_json;

Json SidesJson(const std::vector<Vector3>& sides)
{
  Json names = Json::array();
  for (const Vector3& world : sides)
  {
    for (const PatientSide& side : PatientSides())
    {
      if (side.World == world)
      {
        names.push_back(side.Name);
      }
    }
  }
  return names;
}

Json InclusionsJson(const SoftenedModel& made)
{
  Json inclusions = Json::array();
  for (std::size_t i = 0; i < made.Softness.Inclusions.size(); ++i)
  {
    const InclusionShare& share = made.Softness.Inclusions[i];
    inclusions.push_back({{"name", share.Name},
                          {"modulus_kpa", made.Settings.Inclusions[i].Kilopascal},
                          {"volume_ml", share.Milliliters},
                          {"inside_ml", share.InsideMilliliters}});
  }
  return inclusions;
}

Json NeighboursJson(const SofteningSettings& settings)
{
  Json neighbours = Json::array();
  for (const SofteningSettings::Neighbour& one : settings.Neighbours)
  {
    neighbours.push_back(
        {{"name", one.Read->Source.string()}, {"support_kpa_per_mm", one.KilopascalPerMillimeter}});
  }
  return neighbours;
}

Json BuiltJson(const SoftenedModel& made)
{
  const OrganSoftening& numbers = made.Settings.Numbers;
  const ComplianceMaps& maps = *made.Softness.Elasticity;
  return {{"elements_across", numbers.ElementsAcross},
          {"element_mm", made.Softness.Account.ElementEdge},
          {"unknowns", made.Softness.Account.Unknowns},
          {"compliance_degree", made.Softness.ComplianceDegree},
          {"map_degree", maps.Degree},
          {"largest_patch_mm", maps.LargestPatch},
          {"map_error_rms", maps.FitError.Rms},
          {"map_error_max", maps.FitError.Largest},
          {"seconds", made.Seconds},
          {"from_cache", made.Softness.IsFromCache}};
}

// Null instead of a number that does not exist.
Json NumberOrNull(double number)
{
  return std::isfinite(number) ? Json(number) : Json();
}
} // namespace

std::string SoftenedAsJson(const SoftenedModel& made)
{
  const SofteningSettings& settings = made.Settings;
  const Json object{{JsonSchemaKey, JsonSchemaVersion},
                    {"input", made.Input.string()},
                    {"output", made.Output.string()},
                    {"tissue_kpa", settings.TissueKilopascal},
                    {"poisson_ratio", settings.PoissonRatio},
                    {"exaggeration", settings.Exaggeration},
                    {"elastography", settings.Elastography != nullptr
                                         ? Json(settings.Elastography->Source.string())
                                         : Json()},
                    {"support_kpa_per_mm", settings.BedPerMillimeter},
                    {"free_sides", SidesJson(settings.FreeSides)},
                    {"free_angle_degrees", settings.FreeDegrees},
                    {"neighbours", NeighboursJson(settings)},
                    {"inclusions", InclusionsJson(made)},
                    {"built", BuiltJson(made)},
                    {"felt",
                     {{"tool_radius_mm", made.ToolRadius},
                      {"depth_mm", made.Felt.Depth},
                      {"force_min_n", NumberOrNull(made.Felt.Least)},
                      {"force_median_n", NumberOrNull(made.Felt.Median)},
                      {"force_max_n", NumberOrNull(made.Felt.Most)}}},
                    {"warnings", made.Softness.Warnings()}};
  return object.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}
} // namespace palpate
