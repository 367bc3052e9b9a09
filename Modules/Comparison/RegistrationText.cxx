#include "RegistrationText.h"

#include "DecimalText.h"
#include "JsonSchema.h"
#include "TextTable.h"
#include "Units.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace palpate
{
namespace
{
using Json = nlohmann::ordered_json;

Json FiniteOrNull(double number)
{
  return std::isfinite(number) ? Json(number) : Json();
}

Json LandmarksJson(const FileRegistration& found)
{
  Json list = Json::array();
  for (std::size_t i = 0; i < found.LandmarkNames.size(); ++i)
  {
    list.push_back({{"name", found.LandmarkNames[i]},
                    {"residual_mm", found.Landmarks->Residuals[i]},
                    {"weight", found.Landmarks->Weights[i]}});
  }
  return list;
}

Json SurfaceJson(const FileRegistration& found)
{
  if (!found.Surface)
  {
    return nullptr;
  }
  return {{"points", found.PointCount},
          {"rms_mm", found.Surface->Rms},
          {"median_mm", found.Surface->Median},
          {"steps", found.Surface->Steps},
          {"has_converged", found.Surface->HasConverged}};
}
Json ImagesJson(const FileRegistration& found)
{
  if (!found.Images)
  {
    return nullptr;
  }
  return {{"mutual_information_before", found.Images->InformationBefore},
          {"mutual_information", found.Images->InformationAfter},
          {"steps", found.Images->Steps}};
}
} // namespace

std::string RegistrationText(const FileRegistration& found)
{
  TextTable table;
  table.AddRow({"shift", FixedText(found.Shift.norm(), 2) + " mm"});
  table.AddRow({"turn", FixedText(DegreesPerRadian * found.Turn, 2) + " degrees"});
  if (std::abs(found.Size - 1.0) > 1e-9)
  {
    table.AddRow({"size", FixedText(found.Size, 4)});
  }
  if (found.Landmarks)
  {
    table.AddRow({"landmarks", std::to_string(found.LandmarkNames.size()) + " pairs, RMS " +
                                   FixedText(found.Landmarks->Rms, 3) + " mm"});
    for (std::size_t i = 0; i < found.LandmarkNames.size(); ++i)
    {
      table.AddRow({"  " + found.LandmarkNames[i], FixedText(found.Landmarks->Residuals[i], 2) +
                                                       " mm, weight " +
                                                       FixedText(found.Landmarks->Weights[i], 2)});
    }
  }
  if (found.Surface)
  {
    table.AddRow({"surface", std::to_string(found.PointCount) + " points, distance RMS " +
                                 FixedText(found.Surface->Rms, 3) + ", median " +
                                 FixedText(found.Surface->Median, 3) + " mm"});
  }
  if (found.Images)
  {
    table.AddRow({"mutual information", FixedText(found.Images->InformationBefore, 3) + " to " +
                                            FixedText(found.Images->InformationAfter, 3) + " in " +
                                            std::to_string(found.Images->Steps) + " steps"});
  }
  if (found.Error.Shift > 0.0)
  {
    table.AddRow({"predicted error",
                  FixedText(found.Error.Shift, 3) + " mm, " +
                      (std::isfinite(found.Error.Turn)
                           ? FixedText(DegreesPerRadian * found.Error.Turn, 2) + " degrees"
                           : "any turn")});
  }
  return table.Text();
}

std::string RegistrationJson(const FileRegistration& found, const RegisteredSide& moving,
                             const RegisteredSide& fixed, const std::string& transform)
{
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row)
  {
    rows.push_back({found.Map.matrix()(row, 0), found.Map.matrix()(row, 1),
                    found.Map.matrix()(row, 2), found.Map.matrix()(row, 3)});
  }
  const Vector3& shift = found.Shift;
  const Json json{{JsonSchemaKey, JsonSchemaVersion},
                  {"moving", moving.File.string()},
                  {"fixed", fixed.File.string()},
                  {"map", rows},
                  {"shift_mm", {shift.x(), shift.y(), shift.z()}},
                  {"turn_deg", DegreesPerRadian * found.Turn},
                  {"size", found.Size},
                  {"predicted_shift_mm", FiniteOrNull(found.Error.Shift)},
                  {"predicted_turn_deg", FiniteOrNull(DegreesPerRadian * found.Error.Turn)},
                  {"landmarks", LandmarksJson(found)},
                  {"surface", SurfaceJson(found)},
                  {"images", ImagesJson(found)},
                  {"notes", found.Notes},
                  {"transform", transform.empty() ? Json() : Json(transform)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}
} // namespace palpate
