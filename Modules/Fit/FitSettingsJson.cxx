#include "FitSettingsJson.h"

namespace palpate
{
namespace
{
constexpr double LargestPlace = 1e6; // mm
} // namespace

void ExchangeFitSettings(JsonFields& fields, FitSettings& fit)
{
  // Files of earlier versions do not name their rules, and are written as they were.
  fit.Rules = fields.IsReading() ? 1 : fit.Rules;
  if (fields.IsReading() || fit.Rules != 1)
  {
    fields.Exchange("rules", fit.Rules, 1, FitSettings::NewestRules);
  }
  fields.Exchange("model", fit.Model, FitWords::Model);
  fields.Exchange("method", fit.Method, FitWords::Method);
  fields.Exchange("smoothing_voxels", fit.Smoothing, 0.0, FitLimits::Smoothing);
  fields.Exchange("component", fit.Component, 0, 1'000'000'000);
  fields.Exchange("only_component", fit.IsAlone);
  fields.Exchange("frequency", fit.Frequency, 1, FitLimits::Frequency);
  fields.Exchange("center", fit.Center, FitWords::Center);
  fields.Exchange("center_mm", fit.GivenCenterWorld, -LargestPlace, LargestPlace);
  fields.Exchange("degree", fit.Degree, 0, FitLimits::Degree);
  fields.Exchange("tolerance_mm", fit.Tolerance, 0.0, LargestPlace);
  fields.Exchange("max_degree", fit.MaximumDegree, 0, FitLimits::Degree);
  fields.Exchange("weights", fit.Weight, FitWords::Weight);
  fields.Exchange("penalty", fit.PenaltyKind, FitWords::Penalty);
  fields.Exchange("roughness", fit.Roughness, 0.0, 1e300);
  fields.Exchange("robust", fit.IsRobust);
  fields.Exchange("repair", fit.Repairs);
  fields.Exchange("max_hidden_percent", fit.MaximumHiddenPercent, 0.0, 100.0);
  fields.Exchange("min_dice", fit.MinimumDice, 0.0, 1.0);
}

nlohmann::ordered_json FitSettingsJson(FitSettings fit)
{
  nlohmann::ordered_json object;
  JsonFields fields(object);
  ExchangeFitSettings(fields, fit);
  return object;
}
} // namespace palpate
