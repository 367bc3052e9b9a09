#include "StudyJson.h"

#include "CorrectionFile.h"
#include "JsonText.h"
#include "Refusal.h"
#include "SceneJson.h"
#include "SessionUpgrade.h"

#include <algorithm>
#include <limits>
#include <set>

namespace palpate
{
namespace
{
constexpr int Version = 2;
constexpr double LargestPlace = 1e6; // mm, of coordinates
constexpr double LargestIntensity = 1e300;
constexpr double LeastErrorScale = 1e-6; // mm

const std::initializer_list<const char*> SliceAxesWords{"patient", "volume"};
const std::initializer_list<const char*> MixingWords{"blend", "checkerboard", "curtain"};
const std::initializer_list<const char*> MeasurementWords{
    "line", "angle", "curve", "surface-curve", "plane", "gap", "thickness"};
const std::initializer_list<const char*> NeighborWords{"stop", "overlap", "overwrite"};
const std::initializer_list<const char*> ColorWords{"grey", "hot",   "blue-to-yellow",
                                                    "red",  "green", "blue"};
const std::initializer_list<const char*> PresetWords{"ct-bone", "ct-soft-tissue", "mr",
                                                     "maximum-intensity"};

void ExchangeVersion(JsonFields& fields)
{
  int version = Version;
  fields.Exchange("version", version, 1, 1000);
  fields.Require(version <= Version,
                 "is a session of version " + std::to_string(version) +
                     ", newer than this program's " + std::to_string(Version),
                 "open it with a newer Palpate");
}

void ExchangeLandmark(JsonFields& fields, StudyLandmark& landmark)
{
  fields.Exchange("name", landmark.Name);
  fields.Exchange("position_mm", landmark.PositionWorld, -LargestPlace, LargestPlace);
}

void ExchangePlace(JsonFields& fields, Vector3& place)
{
  fields.Exchange("position_mm", place, -LargestPlace, LargestPlace);
}

void ExchangeMeasurement(JsonFields& fields, StudyMeasurement& measurement)
{
  fields.Exchange("name", measurement.Name);
  fields.Exchange("kind", measurement.Kind, MeasurementWords);
  fields.ExchangeList("points", measurement.PointsWorld, ExchangePlace);
  if (fields.IsReading() || !measurement.PathWorld.empty())
  {
    fields.ExchangeList("path", measurement.PathWorld, ExchangePlace);
  }
  fields.ExchangeIfSet("path_length_mm", measurement.PathLength, 0.0, LargestPlace);
  fields.ExchangeIfSet("structure", measurement.StructureId, 0, std::numeric_limits<int>::max());
  fields.ExchangeIfSet("open", measurement.IsOpen);
  fields.Require(HasValidPoints(measurement),
                 "cannot be read: " + fields.Place() + " does not have the points of its kind",
                 "correct it there, or remove it from \"measurements\"");
}

void ExchangeMeasurements(JsonFields& fields, std::vector<StudyMeasurement>& measurements)
{
  fields.ExchangeList("measurements", measurements, ExchangeMeasurement);
  const auto open = std::count_if(measurements.begin(), measurements.end(),
                                  [](const StudyMeasurement& one) { return one.IsOpen; });
  fields.Require(open <= 1, "has two open measurements", "set \"open\" in one of them only");
}

void ExchangeTouch(JsonFields& fields, SurfaceTouch& touch)
{
  fields.Exchange("position_mm", touch.PointWorld, -LargestPlace, LargestPlace);
  fields.Exchange("sd_mm", touch.Deviation, LeastTouchDeviation, LargestTouchDeviation);
  fields.Exchange("normal", touch.Normal, -2.0, 2.0);
  fields.ExchangeIfSet("stroke", touch.Stroke, 0, std::numeric_limits<int>::max());
  fields.ExchangeIfSet("outside", touch.IsOutside);
}

void ExchangeDrawing(JsonFields& fields, StudyDrawing& drawing)
{
  fields.ExchangeIfSet("prior", drawing.PriorFile);
  if (fields.IsReading() || drawing.KnownId != StudyDrawing::KnownByName)
  {
    fields.Exchange("known", drawing.KnownId, 0, std::numeric_limits<int>::max());
  }
  fields.Exchange("sigma_mm", drawing.Sigma, LeastTouchDeviation, LargestTouchDeviation);
  fields.Exchange("center_mm", drawing.CenterWorld, -LargestPlace, LargestPlace);
  fields.ExchangeList("touches", drawing.Touches, ExchangeTouch);
  fields.Require(RowCount(drawing.Touches) <= MostDrawnRows, "has more touches than it may",
                 "remove some from \"touches\"");
  fields.Exchange("touchable", drawing.IsTouchable);
  fields.Exchange("softened", drawing.IsSoftened);
}

void ExchangeCorrection(JsonFields& fields, StudyCorrection& correction)
{
  fields.Exchange("structure", correction.StructureId, 0, std::numeric_limits<int>::max());
  fields.ExchangeJson(
      "steps", [&correction] { return CorrectionJson(correction.Steps); },
      [&correction](const nlohmann::json& list, const std::filesystem::path& file)
      { correction.Steps = CorrectionsOf(list, file); });
  fields.Exchange("neighbours", correction.Neighbors, NeighborWords);
}

void ExchangeRendering(JsonFields& fields, StudyRendering& rendering)
{
  fields.Exchange("seen", rendering.IsShown);
  fields.Exchange("preset", rendering.Preset, PresetWords);
}

// Written only if set, so that earlier versions read all other sessions.
void ExchangeRenderingIn(JsonFields& fields, StudyRendering& rendering)
{
  if (fields.IsReading() || !(rendering == StudyRendering()))
  {
    fields.ExchangeObject("in_3d", rendering, ExchangeRendering);
  }
}

void ExchangeVolume(JsonFields& fields, StudyVolume& volume)
{
  fields.Exchange("id", volume.Id, 1, std::numeric_limits<int>::max());
  fields.Exchange("file", volume.File);
  fields.Require(!volume.File.empty(), "has a volume without a file", "name its file");
  fields.ExchangeIfSet("dicom_series", volume.Series);
  fields.ExchangeIfSet("transform", volume.Transform);
  fields.Exchange("seen", volume.IsVisible);
  fields.Exchange("window", volume.Window, 0.0, LargestIntensity);
  fields.Exchange("level", volume.Level, -LargestIntensity, LargestIntensity);
  fields.Exchange("colors", volume.Colors, ColorWords);
  fields.Exchange("opacity", volume.Opacity, 0.0, 1.0);
  fields.Exchange("hides_below_window", volume.HidesBelow);
  ExchangeRenderingIn(fields, volume.Rendering);
}

void ExchangeView(JsonFields& fields, StudyView& view)
{
  fields.Exchange("crosshair_mm", view.CrosshairWorld, -LargestPlace, LargestPlace);
  fields.Exchange("window", view.Window, 0.0, LargestIntensity);
  fields.Exchange("level", view.Level, -LargestIntensity, LargestIntensity);
  fields.Exchange("layout", view.Layout);
  fields.Exchange("overlay_opacity", view.OverlayOpacity, 0.0, 1.0);
  fields.Exchange("slice_axes", view.UsesVolumeAxes, SliceAxesWords);
  fields.Exchange("slices_follow_probe", view.SlicesFollowProbe);
  fields.Exchange("mixing", view.Mixing, MixingWords);
  fields.Exchange("curtain", view.Curtain, 0.0, 1.0);
  fields.Exchange("error_scale_mm", view.ErrorScale, LeastErrorScale, LargestPlace);
}

void ExchangeStudy(JsonFields& fields, StudyState& state, std::filesystem::path& drilled)
{
  fields.ExchangeFormat("palpate-study", "a Palpate session");
  ExchangeVersion(fields);
  fields.ExchangeIfSet("volume", state.VolumeFile);
  fields.ExchangeIfSet("dicom_series", state.DicomSeries);
  ExchangeRenderingIn(fields, state.Rendering);
  fields.ExchangeList("volumes", state.Volumes, ExchangeVolume);
  std::set<int> ids;
  const bool areUnique =
      std::all_of(state.Volumes.begin(), state.Volumes.end(),
                  [&](const StudyVolume& one) { return ids.insert(one.Id).second; });
  fields.Require(areUnique, "has two volumes of one id", "give each an id of its own");
  fields.ExchangeIfSet("segmentation", state.SegmentationFile);
  fields.ExchangeIfSet("drilled", drilled);
  fields.ExchangeObject("scene", state, ExchangeScene);
  fields.ExchangeList("landmarks", state.Landmarks, ExchangeLandmark);
  ExchangeMeasurements(fields, state.Measurements);
  if (fields.IsReading() || !(state.Drawing == StudyDrawing()))
  {
    fields.ExchangeObject("drawing", state.Drawing, ExchangeDrawing);
  }
  if (fields.IsReading() || !(state.Correction == StudyCorrection()))
  {
    fields.ExchangeObject("correction", state.Correction, ExchangeCorrection);
  }
  fields.ExchangeObject("view", state.View, ExchangeView);
  fields.RefuseOthers();
}
} // namespace

std::string StudyText(StudyState state, const std::filesystem::path& folder,
                      const std::filesystem::path& file, std::filesystem::path drilled)
{
  try
  {
    nlohmann::ordered_json root;
    JsonFields fields(root, folder);
    ExchangeStudy(fields, state, drilled);
    return root.dump(2) + "\n";
  }
  catch (const nlohmann::ordered_json::type_error&)
  {
    Refuse(file, "cannot be written: it contains a name that is not UTF-8",
           "rename the file or the structure");
  }
}

StudyState StudyFromText(const std::string& text, const std::filesystem::path& folder,
                         const std::filesystem::path& file, std::filesystem::path* drilled)
{
  nlohmann::json root = ParseJson(text, file, "fix it there, or open another session");
  UpgradeSession(root);
  JsonFields fields(root, file, "study", folder);
  StudyState state;
  std::filesystem::path drilledFile;
  ExchangeStudy(fields, state, drilledFile);
  if (drilled != nullptr)
  {
    *drilled = drilledFile;
  }
  return state;
}
} // namespace palpate
