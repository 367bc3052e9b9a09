#include "ReportSlices.h"

#include "AnatomicalView.h"
#include "DecimalText.h"
#include "HtmlText.h"
#include "MeshConversion.h"
#include "MeshVoxels.h"
#include "RasterImage.h"
#include "ReportPage.h"
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

std::string Letter(double x, double y, const std::string& anchor, const std::string& text)
{
  return "<text x=\"" + FixedText(x, 1) + "\" y=\"" + FixedText(y, 1) + "\" text-anchor=\"" +
         anchor + "\">" + text + "</text>";
}

std::string Letters(const SlicePlane& plane)
{
  const double middleX = 0.5 * plane.Width;
  const double middleY = 0.5 * plane.Height + 5.0;
  return Letter(5.0, middleY, "start", OrientationLetters(-plane.RightWorld)) +
         Letter(plane.Width - 5.0, middleY, "end", OrientationLetters(plane.RightWorld)) +
         Letter(middleX, 17.0, "middle", OrientationLetters(-plane.DownWorld)) +
         Letter(middleX, plane.Height - 6.0, "middle", OrientationLetters(plane.DownWorld));
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
         "\" y2=\"" + FixedText(y, 1) + "\"/>" +
         Letter(8.0, y - 6.0, "start", SignificantText(length, 3) + " mm");
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
std::string SliceFigure(const SlicePlane& plane, double share, const RasterImage& raster,
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
  svg += Letters(plane) + ScaleBar(plane);
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
  return ReportFigure(svg + "</svg>", caption);
}

std::string Legend(const FitResult& result, const Volume* volume)
{
  std::string html = "<ul class=\"legend\">";
  if (result.Mask)
  {
    html += "<li><i class=\"mask\"></i>mask, edges of its voxels</li>";
  }
  if (result.Surface)
  {
    html += std::string("<li><i class=\"surface\"></i>") +
            (result.IsOfSurface ? "surface" : "surface of the mask") + "</li>";
  }
  if (result.ModelSurface)
  {
    html += "<li><i class=\"model\"></i>model</li>";
  }
  const std::string raster = volume               ? volume->Source.filename().string()
                             : result.IsOfSurface ? "inside and outside, no volume given"
                                                  : "the mask itself, no volume given";
  return html + "<li class=\"soft\">image: " + EscapeHtml(raster) + "</li></ul>\n";
}

// `places`: none, or one for each plane.
std::string SliceFigures(const std::vector<SlicePlane>& planes, const std::vector<Place>& places,
                         const FitResult& result, const Voxels& voxels, const Volume* volume)
{
  if (planes.empty())
  {
    return {};
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
  std::vector<std::string> figures(planes.size());
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
  std::string html = Legend(result, volume) + "<div class=\"slices\">\n";
  for (const std::string& figure : figures)
  {
    html += figure;
  }
  return html + "</div>\n";
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

std::string ReportSlices(const FitResult& result, const Volume* volume)
{
  const Voxels voxels = VoxelsOf(result);
  return voxels.Image
             ? SliceFigures(ChooseSlicePlanes(voxels.Image, voxels.Value, AxialCount, LongestSide),
                            {}, result, voxels, volume)
             : std::string();
}

std::string ReportRepair(const FitResult& result, const Volume* volume)
{
  const Voxels voxels = result.Details.Mapped ? VoxelsOf(result) : Voxels();
  if (!voxels.Image)
  {
    return {};
  }
  const std::vector<Place> places = PlacesOf(*result.Details.Mapped);
  std::vector<Vector3> points;
  for (const Place& place : places)
  {
    points.push_back(place.World);
  }
  return SliceFigures(SlicePlanesAt(points, voxels.Image, voxels.Value, LongestSide), places,
                      result, voxels, volume);
}
} // namespace palpate
