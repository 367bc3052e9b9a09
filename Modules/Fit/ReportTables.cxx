#include "ReportTables.h"

#include "DecimalText.h"
#include "RepairRemarks.h"
#include "ReportPage.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr std::size_t MostComponents = 8; // listed one by one

std::string Millimeters(double value)
{
  return FixedText(value, 3) + " mm";
}
std::string Milliliters(double value)
{
  return FixedText(value, 3) + " ml";
}
std::string Percent(double value)
{
  return FixedText(value, 2) + " %";
}
std::string Point(const Vector3& world)
{
  return FixedText(world.x(), 2) + ", " + FixedText(world.y(), 2) + ", " + FixedText(world.z(), 2) +
         " mm";
}

std::string ComponentList(const std::vector<double>& milliliters)
{
  std::string list;
  for (std::size_t c = 0; c < std::min(milliliters.size(), MostComponents); ++c)
  {
    list += (c > 0 ? "; " : "") + FixedText(milliliters[c], 3);
  }
  return list + " ml" + (milliliters.size() > MostComponents ? "; \xE2\x80\xA6" : "");
}

ReportRows MaskRows(const FitResult& result)
{
  ReportRows rows{{"Label", std::to_string(result.Structure.Label)}};
  if (result.Mask)
  {
    int size[3];
    double spacing[3];
    result.Mask->GetDimensions(size);
    result.Mask->GetSpacing(spacing);
    rows.emplace_back("Grid", std::to_string(size[0]) + " \xC3\x97 " + std::to_string(size[1]) +
                                  " \xC3\x97 " + std::to_string(size[2]));
    rows.emplace_back("Voxel", SignificantText(spacing[0], 5) + " \xC3\x97 " +
                                   SignificantText(spacing[1], 5) + " \xC3\x97 " +
                                   SignificantText(spacing[2], 5) + " mm");
  }
  rows.emplace_back("Volume", Milliliters(result.MaskMilliliters));
  rows.emplace_back("Touches the image border", result.TouchesBorder ? "yes" : "no");
  if (!result.ComponentMilliliters.empty())
  {
    rows.emplace_back("Connected components", std::to_string(result.ComponentMilliliters.size()));
    rows.emplace_back("Their volumes", ComponentList(result.ComponentMilliliters));
  }
  rows.emplace_back("Cavities", std::to_string(result.CavityCount));
  if (result.CavityCount > 0)
  {
    rows.emplace_back("Volume of the cavities", Milliliters(result.CavityMilliliters));
  }
  return rows;
}

void AddDistances(ReportRows& rows, const SurfaceDistances& distances)
{
  rows.emplace_back("Mean distance", Millimeters(distances.Mean));
  rows.emplace_back("Root mean square", Millimeters(distances.Rms));
  rows.emplace_back("95th percentile", Millimeters(distances.Percentile95));
  rows.emplace_back("Maximum", Millimeters(distances.Maximum));
}

ReportRows SurfaceRows(const FitResult& result)
{
  ReportRows rows{{"Points", std::to_string(result.Surface->GetNumberOfPoints())},
                  {"Triangles", std::to_string(result.Surface->GetNumberOfPolys())},
                  {"Volume", Milliliters(result.SurfaceMilliliters)}};
  // Measured with the model's quality, so missing for a refused structure.
  if (result.SurfaceAreaSquareMillimeters > 0.0)
  {
    rows.emplace_back("Area", FixedText(result.SurfaceAreaSquareMillimeters, 1) + " mm\xC2\xB2");
    if (!result.IsOfSurface)
    {
      AddDistances(rows, result.SurfaceToMask);
    }
  }
  return rows;
}

ReportRows ViewRows(const FitResult& result)
{
  return {{"Star-shaped", result.StarShaped ? "yes" : "no"},
          {"Hidden surface", Percent(result.HiddenPercent)},
          {"Directions with several crossings", Percent(result.MultiplePercent)},
          {"Directions without a crossing", Percent(result.MissedPercent)}};
}

// How a surface model's structure was made ready for it; none of a radial model.
ReportRows MapRows(const FitResult& result)
{
  const MappedSurface& mapped = *result.Details.Mapped;
  const TopologyReport& repair = mapped.Topology;
  ReportRows rows{
      {"Changed by the repair", SignificantText(repair.ChangedPercent(), 3) + " % of the volume"}};
  if (result.IsOfSurface)
  {
    rows.emplace_back("Added by the repair",
                      SignificantText(result.Details.AddedAreaPercent, 3) + " % of the area");
  }
  const auto add = [&rows](const char* name, const TopologyChange& change)
  {
    if (change.Count > 0)
    {
      rows.emplace_back(name, std::to_string(change.Count) + ", " + VolumeText(change.Volume));
    }
  };
  add("Small parts dropped", repair.DroppedParts);
  add("Parts joined by bridges", repair.Bridges);
  add("Cavities filled", repair.FilledCavities);
  add("Handles cut", repair.CutHandles);
  add("Handles filled", repair.FilledHandles);
  rows.emplace_back("Thin parts left out",
                    mapped.Lost.empty() ? "none"
                                        : std::to_string(mapped.Lost.size()) + ", up to " +
                                              FixedText(mapped.Lost.front().Distance, 1) + " mm");
  rows.emplace_back("Area distortion on the sphere", FixedText(mapped.Map.AreaDistortion, 3));
  rows.emplace_back("Least share of area", SignificantText(mapped.Map.LeastRatio, 2));
  return rows;
}

ReportRows CrossingRows(const FitResult& result)
{
  const SurfaceModelDetails& details = result.Details;
  return {{"Pairs of triangles that cross", std::to_string(details.Crossings)},
          {"Vertices that turn over", std::to_string(details.Folded)},
          {"Voxels outside in it or inside twice",
           SignificantText(details.IrregularPercent, 2) + " % of the mask\xE2\x80\x99s"},
          {"Determination of its placement", FixedText(details.Determination, 2)}};
}

ReportRows ModelRows(const FitResult& result)
{
  const bool isRadial = result.Radial() != nullptr;
  return {{"Kind", isRadial ? "radial: a radius in each direction"
                            : "surface: three coordinates over the parameter sphere"},
          {"Degree", std::to_string(DegreeOf(result.Model))},
          {"Coefficients", std::to_string(CoefficientCountOf(result.Model))},
          {"Centre (LPS, mm)", Point(CenterOf(result.Model))},
          {"Condition number", SignificantText(result.Condition, 4)},
          {isRadial ? "RMS residual of the radii" : "RMS residual along the normals",
           Millimeters(result.Rms)},
          {"Noise of a sample", Millimeters(result.NoiseDeviation)},
          {"Roughness penalty used", SignificantText(result.Roughness, 4)},
          {"Degrees of freedom", FixedText(result.DegreesOfFreedom, 1)},
          {"Samples that count less (robust)", std::to_string(result.DownWeighted)},
          {"Largest gap between directions",
           FixedText(result.Coverage.LargestGap.Radius * 180.0 / M_PI, 1) +
               "\xC2\xB0 in radius (limit " +
               FixedText(DirectionCoverage::WidestGap(DegreeOf(result.Model)) * 180.0 / M_PI, 1) +
               "\xC2\xB0)"},
          {"Noise gain: RMS, largest", SignificantText(result.Coverage.NoiseGainRms, 3) + ", " +
                                           SignificantText(result.Coverage.NoiseGainMaximum, 3) +
                                           " (limit 1)"},
          {"Volume", Milliliters(result.ModelMilliliters)},
          {"Area", FixedText(result.ModelAreaSquareMillimeters, 1) + " mm\xC2\xB2"}};
}

ReportRows ModelToMaskRows(const FitResult& result)
{
  ReportRows rows{{"Dice", FixedText(result.Dice, 4)}};
  AddDistances(rows, result.ModelToMask);
  const double difference = 100.0 * (result.ModelMilliliters / result.MaskMilliliters - 1.0);
  rows.emplace_back("Volume difference", Percent(difference));
  return rows;
}

ReportRows ModelToSurfaceRows(const FitResult& result)
{
  ReportRows rows;
  AddDistances(rows, result.ModelToSurface);
  const double volume = 100.0 * (result.ModelMilliliters / result.SurfaceMilliliters - 1.0);
  const double area =
      100.0 * (result.ModelAreaSquareMillimeters / result.SurfaceAreaSquareMillimeters - 1.0);
  rows.emplace_back("Volume difference", Percent(volume));
  rows.emplace_back("Area difference", Percent(area));
  return rows;
}

ReportRows DegreeRows(const FitResult& result)
{
  ReportRows rows;
  const std::vector<double> power = PowerSpectrumOf(result.Model);
  for (std::size_t l = 0; l < power.size(); ++l)
  {
    std::string text = SignificantText(power[l], 5) + " mm\xC2\xB2";
    if (l < result.RmsByDegree.size())
    {
      text += "; " + SignificantText(result.RmsByDegree[l], 4) + " mm";
    }
    rows.emplace_back(std::to_string(l), text);
  }
  return rows;
}
} // namespace

void ReportNumbers(ReportPage& page, const FitResult& result)
{
  if (!result.IsOfSurface)
  {
    page.Facts("Mask", MaskRows(result));
  }
  if (result.Surface)
  {
    page.Facts(result.IsOfSurface ? "Surface" : "Surface, and its distance to the mask",
               SurfaceRows(result));
    if (result.IsSampled)
    {
      page.Facts("Seen from the centre", ViewRows(result));
    }
    if (result.Details.Mapped)
    {
      page.Facts("Repair, and map to the parameter sphere", MapRows(result));
    }
  }
  if (result.State == FitResult::Outcome::Fitted)
  {
    page.Facts("Model", ModelRows(result));
    result.IsOfSurface ? page.Facts("Overlap of model and surface",
                                    {{"Dice", FixedText(result.Dice, 4)},
                                     {"Cubes", SignificantText(result.DiceSpacing, 3) + " mm"}})
                       : page.Facts("Model and mask", ModelToMaskRows(result));
    page.Facts("Model and surface", ModelToSurfaceRows(result));
    if (result.Details.Mapped)
    {
      page.Facts("Crossings and placement", CrossingRows(result));
    }
    page.Facts("Degree: power; RMS residual up to there", DegreeRows(result));
  }
  ReportRows seconds;
  for (const auto& [stage, time] : result.Seconds)
  {
    seconds.emplace_back(stage, FixedText(time, 3) + " s");
  }
  page.Facts("Time", seconds);
}
} // namespace palpate
