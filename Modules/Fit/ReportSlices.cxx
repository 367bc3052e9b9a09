#include "ReportSlices.h"

#include "DecimalText.h"
#include "MeshConversion.h"
#include "MeshVoxels.h"
#include "RasterImage.h"
#include "ReportPage.h"
#include "SixViews.h"
#include "SliceContour.h"
#include "SliceImage.h"
#include "SlicePlane.h"

#include "vtkImageData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace palpate
{
namespace
{
constexpr int AxialCount = 4;
constexpr int LongestSide = 340; // pixels

constexpr double CubesToDraw = 1.0e6;

// What the planes are chosen in: the mask, or the cubes inside a surface.
struct Voxels
{
  vtkSmartPointer<vtkImageData> Image;
  int Value = 1;
};

Voxels VoxelsOf(const FitResult& result)
{
  if (result.Mask || !result.IsOfSurface || !result.Surface)
  {
    return {result.Mask, result.Structure.Value};
  }
  const IndexedMesh mesh = ToIndexedMesh(result.Surface);
  const VoxelCenters grid = CubesAround(mesh, CubesToDraw);
  std::vector<std::uint8_t> inside;
  if (!FindInside(mesh, grid, true, inside).IsOk())
  {
    return {};
  }
  Voxels cubes{vtkSmartPointer<vtkImageData>::New()};
  cubes.Image->SetDimensions(grid.Size.data());
  cubes.Image->SetOrigin(grid.Origin.data());
  cubes.Image->SetSpacing(grid.Axes(0, 0), grid.Axes(1, 1), grid.Axes(2, 2));
  cubes.Image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::copy(inside.begin(), inside.end(),
            static_cast<std::uint8_t*>(cubes.Image->GetScalarPointer()));
  return cubes;
}

std::vector<std::vector<float>> SampleAll(const std::vector<SlicePlane>& planes,
                                          const Voxels& voxels, const Volume* volume)
{
  std::vector<std::vector<float>> values(planes.size());
  vtkSMPTools::Transform(planes.begin(), planes.end(), values.begin(),
                         [&](const SlicePlane& plane) {
                           return volume ? SampleLinear(volume->Image, plane)
                                         : SampleNearest(voxels.Image, plane);
                         });
  return values;
}

// Without a volume: the structure is light, other labels are darker, the background is nearly
// black.
void ShadeMask(std::vector<float>& values, int value)
{
  for (float& v : values)
  {
    v = v == static_cast<float>(value) ? 0.62F : v != 0.0F ? 0.3F : 0.12F;
  }
}

std::string PathElement(const std::string& style, const std::string& data)
{
  return data.empty() ? std::string() : "<path class=\"" + style + "\" d=\"" + data + "\"/>";
}

// A bar of 1, 2 or 5 times a power of ten in mm, at most a third of the width.
std::string ScaleBar(const SlicePlane& plane)
{
  const double room = plane.Width * plane.PixelMillimeters / 3.0;
  const double decade = std::pow(10.0, std::floor(std::log10(room)));
  const double length = decade * (room >= 5.0 * decade ? 5.0 : room >= 2.0 * decade ? 2.0 : 1.0);
  const double y = plane.Height - 9.0;
  return "<line class=\"scale\" x1=\"8\" x2=\"" +
         FixedText(8.0 + length / plane.PixelMillimeters, 1) + "\" y1=\"" + FixedText(y, 1) +
         "\" y2=\"" + FixedText(y, 1) + "\"/>" + "<text x=\"8.0\" y=\"" + FixedText(y - 6.0, 1) +
         "\" text-anchor=\"start\">" + SignificantText(length, 3) + " mm</text>";
}

// A place to be seen in a slice.
struct Place
{
  std::string Name;
  Vector3 World;
};

std::string Ring(const SlicePlane& plane, const Place& place)
{
  const Eigen::Vector2d at = plane.ToImage(place.World);
  return "<circle class=\"place\" cx=\"" + FixedText(at.x(), 1) + "\" cy=\"" +
         FixedText(at.y(), 1) + "\" r=\"14\"/>";
}

// `share` is the image's width relative to the widest one, so that all have the same scale.
ReportFigure SliceFigure(const SlicePlane& plane, double share, const RasterImage& raster,
                         const FitResult& result, const Place* place)
{
  const std::string width = std::to_string(plane.Width);
  const std::string height = std::to_string(plane.Height);
  std::string svg = "<svg class=\"slice\" style=\"width: " + FixedText(100.0 * share, 2) +
                    "%\" role=\"img\" viewBox=\"0 0 " + width + " " + height + "\" aria-label=\"" +
                    plane.Name + " slice\"><image width=\"" + width + "\" height=\"" + height +
                    "\" href=\"" + PngDataUri(raster) + "\"/>";
  if (result.Mask)
  {
    svg += PathElement("mask", MaskOutlinePath(result.Mask, result.Structure.Value, plane));
  }
  if (result.Surface)
  {
    svg += PathElement("surface", SurfaceContourPath(result.Surface, plane));
  }
  if (result.ModelSurface)
  {
    svg += PathElement("model", SurfaceContourPath(result.ModelSurface, plane));
  }
  svg +=
      SideLetters(plane.Width, plane.Height, plane.RightWorld, plane.DownWorld) + ScaleBar(plane);
  std::string caption = plane.Name;
  if (result.Mask)
  {
    caption +=
        ", slice " + std::to_string(plane.SliceNumber) + " of " + std::to_string(plane.SliceCount);
  }
  if (place != nullptr)
  {
    svg += Ring(plane, *place);
    caption = place->Name + ". " + caption;
  }
  return {svg + "</svg>", caption};
}

ReportRows Legend(const FitResult& result, const Volume* volume)
{
  ReportRows lines;
  if (result.Mask)
  {
    lines.emplace_back("mask", "mask, edges of its voxels");
  }
  if (result.Surface)
  {
    lines.emplace_back("surface", result.IsOfSurface ? "surface" : "surface of the mask");
  }
  if (result.ModelSurface)
  {
    lines.emplace_back("model", "model");
  }
  lines.emplace_back("", "image: " + (volume               ? volume->Source.filename().string()
                                      : result.IsOfSurface ? "inside and outside, no volume given"
                                                           : "the mask itself, no volume given"));
  return lines;
}

// `places`: none, or one for each plane.
void AddSlices(ReportPage& page, const std::vector<SlicePlane>& planes,
               const std::vector<Place>& places, const FitResult& result, const Voxels& voxels,
               const Volume* volume)
{
  if (planes.empty())
  {
    return;
  }
  std::vector<std::vector<float>> values = SampleAll(planes, voxels, volume);
  GreyWindow window;
  if (volume)
  {
    window = FindWindow(values);
  }
  else
  {
    for (std::vector<float>& slice : values)
    {
      ShadeMask(slice, voxels.Value);
    }
  }
  const int widest =
      std::max_element(planes.begin(), planes.end(),
                       [](const SlicePlane& a, const SlicePlane& b) { return a.Width < b.Width; })
          ->Width;
  std::vector<ReportFigure> figures(planes.size());
  vtkSMPTools::For(
      0, static_cast<vtkIdType>(planes.size()),
      [&](vtkIdType first, vtkIdType last)
      {
        for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
        {
          const double share = static_cast<double>(planes[i].Width) / widest;
          figures[i] = SliceFigure(planes[i], share, DrawGrey(values[i], planes[i], window), result,
                                   places.empty() ? nullptr : &places[i]);
        }
      });
  page.Legend(Legend(result, volume));
  for (const ReportFigure& figure : figures)
  {
    page.Figure("slices", figure);
  }
}

std::vector<Place> PlacesOf(const MappedSurface& mapped)
{
  constexpr std::size_t MostLost = 3;
  std::vector<Place> places;
  const auto add = [&places](const char* name, const TopologyChange& change)
  {
    if (change.Count > 0)
    {
      places.push_back({name, change.LargestCentre});
    }
  };
  add("Largest part dropped", mapped.Topology.DroppedParts);
  add("Largest bridge", mapped.Topology.Bridges);
  add("Largest cavity filled", mapped.Topology.FilledCavities);
  add("Largest handle cut", mapped.Topology.CutHandles);
  add("Largest handle filled", mapped.Topology.FilledHandles);
  for (std::size_t i = 0; i < std::min(mapped.Lost.size(), MostLost); ++i)
  {
    places.push_back(
        {"Left out, " + FixedText(mapped.Lost[i].Distance, 1) + " mm", mapped.Lost[i].Farthest});
  }
  return places;
}
} // namespace

void ReportSlices(ReportPage& page, const FitResult& result, const Volume* volume)
{
  const Voxels voxels = VoxelsOf(result);
  if (voxels.Image)
  {
    AddSlices(page, ChooseSlicePlanes(voxels.Image, voxels.Value, AxialCount, LongestSide), {},
              result, voxels, volume);
  }
}

void ReportRepair(ReportPage& page, const FitResult& result, const Volume* volume)
{
  const Voxels voxels = result.Details.Mapped ? VoxelsOf(result) : Voxels();
  if (!voxels.Image)
  {
    return;
  }
  const std::vector<Place> places = PlacesOf(*result.Details.Mapped);
  std::vector<Vector3> points;
  for (const Place& place : places)
  {
    points.push_back(place.World);
  }
  AddSlices(page, SlicePlanesAt(points, voxels.Image, voxels.Value, LongestSide), places, result,
            voxels, volume);
}
} // namespace palpate
