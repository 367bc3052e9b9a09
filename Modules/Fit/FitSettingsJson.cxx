#include "FitSettingsJson.h"

#include "JsonFields.h"

namespace palpate
{
namespace
{
constexpr double LargestPlace = 1e6; // mm
constexpr int HighestDegree = 100;

const std::initializer_list<const char*> MethodWords{"shape", "plain"};
const std::initializer_list<const char*> CenterWords{"centroid", "visible"};
const std::initializer_list<const char*> WeightWords{"area", "solid-angle", "uniform"};
const std::initializer_list<const char*> PenaltyWords{"none", "given", "auto"};
} // namespace

FitSettings ReadFitSettings(const nlohmann::json& object, const std::filesystem::path& file)
{
  FitSettings fit;
  JsonFields fields(object, file, "fit");
  fields.ReadChoice("method", MethodWords, fit.Method);
  fields.Read("smoothing_voxels", fit.Smoothing, 0.0, 10.0);
  fields.Read("component", fit.Component, 0, 1'000'000'000);
  fields.Read("frequency", fit.Frequency, 1, 200);
  fields.ReadChoice("center", CenterWords, fit.Center);
  if (fields.Has("center_mm"))
  {
    Vector3 center = Vector3::Zero();
    fields.Read("center_mm", center, -LargestPlace, LargestPlace);
    fit.GivenCenterWorld = {center[0], center[1], center[2]};
  }
  fields.Read("degree", fit.Degree, 0, HighestDegree);
  if (fields.Has("tolerance_mm"))
  {
    fit.Tolerance = 0.0;
    fields.Read("tolerance_mm", *fit.Tolerance, 0.0, LargestPlace);
  }
  fields.Read("max_degree", fit.MaximumDegree, 0, HighestDegree);
  fields.ReadChoice("weights", WeightWords, fit.Weight);
  fields.ReadChoice("penalty", PenaltyWords, fit.PenaltyKind);
  fields.Read("roughness", fit.Roughness, 0.0, 1e300);
  fields.Read("robust", fit.IsRobust);
  fields.Read("max_hidden_percent", fit.MaximumHiddenPercent, 0.0, 100.0);
  fields.Read("min_dice", fit.MinimumDice, 0.0, 1.0);
  fields.RefuseOthers();
  return fit;
}

nlohmann::ordered_json FitSettingsJson(const FitSettings& fit)
{
  nlohmann::ordered_json object{{"method", WordOf(MethodWords, fit.Method)},
                                {"smoothing_voxels", fit.Smoothing},
                                {"component", fit.Component},
                                {"frequency", fit.Frequency},
                                {"center", WordOf(CenterWords, fit.Center)}};
  if (fit.GivenCenterWorld)
  {
    object["center_mm"] = *fit.GivenCenterWorld;
  }
  object["degree"] = fit.Degree;
  if (fit.Tolerance)
  {
    object["tolerance_mm"] = *fit.Tolerance;
  }
  object["max_degree"] = fit.MaximumDegree;
  object["weights"] = WordOf(WeightWords, fit.Weight);
  object["penalty"] = WordOf(PenaltyWords, fit.PenaltyKind);
  object["roughness"] = fit.Roughness;
  object["robust"] = fit.IsRobust;
  object["max_hidden_percent"] = fit.MaximumHiddenPercent;
  object["min_dice"] = fit.MinimumDice;
  return object;
}
} // namespace palpate
