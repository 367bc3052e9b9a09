#include "EvaluationText.h"

#include "DecimalText.h"
#include "JsonSchema.h"
#include "TextTable.h"
#include "Units.h"

#include <nlohmann/json.hpp>

namespace palpate::cli
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr int Decimals = 4;

std::string Short(const Vector3& vector)
{
  return FixedText(vector.x(), Decimals) + ", " + FixedText(vector.y(), Decimals) + ", " +
         FixedText(vector.z(), Decimals);
}

Json AsJson(const Vector3& vector)
{
  return {vector.x(), vector.y(), vector.z()};
}

std::string DirectionTable(const ModelEvaluation& evaluation)
{
  TextTable table;
  table.AddRow({"direction", "radius mm", "gradient mm/rad", "point mm", "normal"});
  for (const ModelEvaluation::DirectionSample& sample : evaluation.Directions)
  {
    table.AddRow({Short(sample.Direction),
                  sample.Radius ? FixedText(*sample.Radius, Decimals) : "-",
                  sample.Gradient ? Short(*sample.Gradient) : "-", Short(sample.PointWorld),
                  Short(sample.Normal)});
  }
  return "\n" + table.Text();
}

std::string PointTable(const ModelEvaluation& evaluation)
{
  TextTable table;
  table.AddRow({"point mm", "where", evaluation.IsRadial ? "radial distance mm" : "distance mm",
                evaluation.IsRadial ? "radius mm" : ""});
  for (const ModelEvaluation::PointSample& sample : evaluation.Points)
  {
    table.AddRow({Short(sample.PointWorld), sample.Inside ? "inside" : "outside",
                  FixedText(sample.Distance, Decimals),
                  sample.Radius ? FixedText(*sample.Radius, Decimals) : ""});
  }
  return "\n" + table.Text();
}
} // namespace

std::string EvaluationAsText(const ModelEvaluation& evaluation)
{
  TextTable table;
  table.AddRow({"model", evaluation.File});
  table.AddRow({"kind", evaluation.IsRadial    ? "radial"
                        : evaluation.InsideOut ? "surface, parametrised inside out"
                                               : "surface"});
  table.AddRow({"degree", std::to_string(evaluation.Degree)});
  table.AddRow({"frame", "patient LPS, mm"});
  if (evaluation.CenterWorld)
  {
    table.AddRow({"centre", Short(*evaluation.CenterWorld) + " mm"});
  }
  table.AddRow(
      {"volume", FixedText(evaluation.Volume / CubicMillimetersPerMilliliter, Decimals) + " ml"});
  table.AddRow({"area", SignificantText(evaluation.Area) + " mm^2"});
  std::string text = table.Text();
  TextTable power;
  power.AddRow({"degree", "power mm^2"});
  power.AlignRight({0, 1});
  for (std::size_t l = 0; l < evaluation.Power.size(); ++l)
  {
    power.AddRow({std::to_string(l), SignificantText(evaluation.Power[l])});
  }
  text += "\n" + power.Text();
  text += evaluation.Directions.empty() ? "" : DirectionTable(evaluation);
  text += evaluation.Points.empty() ? "" : PointTable(evaluation);
  return text;
}

std::string EvaluationAsJson(const ModelEvaluation& evaluation)
{
  Json result;
  result[JsonSchemaKey] = JsonSchemaVersion;
  result["model"] = evaluation.File;
  result["kind"] = evaluation.IsRadial ? "radial" : "surface";
  result["degree"] = evaluation.Degree;
  result["frame"] = "patient LPS";
  if (evaluation.CenterWorld)
  {
    result["center_mm"] = AsJson(*evaluation.CenterWorld);
  }
  else
  {
    result["inside_out"] = evaluation.InsideOut;
  }
  result["volume_ml"] = evaluation.Volume / CubicMillimetersPerMilliliter;
  result["area_mm2"] = evaluation.Area;
  result["power_mm2"] = evaluation.Power;
  for (const ModelEvaluation::DirectionSample& sample : evaluation.Directions)
  {
    Json entry;
    entry["direction"] = AsJson(sample.Direction);
    if (sample.Radius && sample.Gradient)
    {
      entry["radius_mm"] = *sample.Radius;
      entry["gradient_mm_per_rad"] = AsJson(*sample.Gradient);
    }
    entry["point_mm"] = AsJson(sample.PointWorld);
    entry["normal"] = AsJson(sample.Normal);
    result["directions"].push_back(std::move(entry));
  }
  for (const ModelEvaluation::PointSample& sample : evaluation.Points)
  {
    Json entry{{"point_mm", AsJson(sample.PointWorld)}, {"inside", sample.Inside}};
    entry[sample.Radius ? "radial_distance_mm" : "distance_mm"] = sample.Distance;
    if (sample.Radius)
    {
      entry["radius_mm"] = *sample.Radius;
    }
    result["points"].push_back(std::move(entry));
  }
  return result.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}
} // namespace palpate::cli
