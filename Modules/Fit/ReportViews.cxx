#include "ReportViews.h"

#include "AnatomicalView.h"
#include "ArrayColors.h"
#include "DecimalText.h"
#include "IcosahedronDirections.h"
#include "ModelSurface.h"
#include "RasterImage.h"
#include "ReportPage.h"
#include "SoftwareRenderer.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace palpate
{
namespace
{
constexpr int ViewSize = 300; // pixels

vtkDataArray* DistancesOf(vtkPolyData* model)
{
  return model ? model->GetPointData()->GetArray("DistanceToSurface") : nullptr;
}

// The 99th percentile of the absolute distances: a few extremes must not reduce the contrast of the
// rest.
double ColoredDistance(vtkDataArray* distances)
{
  std::vector<double> sizes;
  for (vtkIdType p = 0; p < distances->GetNumberOfTuples(); ++p)
  {
    const double size = std::abs(distances->GetComponent(p, 0));
    if (std::isfinite(size))
    {
      sizes.push_back(size);
    }
  }
  if (sizes.empty())
  {
    return 1.0;
  }
  const auto rank = static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), sizes.begin() + rank, sizes.end());
  // Below a micrometre only rounding would be coloured.
  return std::max(1e-3, sizes[static_cast<std::size_t>(rank)]);
}

std::string CssColor(const std::array<std::uint8_t, 3>& color)
{
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", color[0], color[1], color[2]);
  return text.data();
}

std::string ColorBar(vtkLookupTable* colors)
{
  const double limit = colors->GetRange()[1];
  constexpr int Stops = 16;
  constexpr double Left = 20.0;
  constexpr double Width = 360.0;
  std::string svg = "<svg class=\"colorbar\" viewBox=\"0 0 400 62\" role=\"img\" "
                    "aria-label=\"colour bar\"><defs><linearGradient id=\"distance\">";
  for (int stop = 0; stop <= Stops; ++stop)
  {
    const double share = static_cast<double>(stop) / Stops;
    svg += "<stop offset=\"" + SignificantText(share, 4) + "\" stop-color=\"" +
           CssColor(ColorOf(colors, (2.0 * share - 1.0) * limit)) + "\"/>";
  }
  svg += "</linearGradient></defs><rect x=\"20\" y=\"18\" width=\"360\" height=\"14\" rx=\"2\" "
         "fill=\"url(#distance)\"/>";
  for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0})
  {
    const double x = Left + 0.5 * (share + 1.0) * Width;
    const std::string sign = share > 0.0 ? "+" : "";
    svg += "<text text-anchor=\"middle\" x=\"" + FixedText(x, 1) + "\" y=\"48\">" + sign +
           SignificantText(share * limit, 3) + "</text>";
  }
  return svg + "<text x=\"20\" y=\"12\">model inside</text><text x=\"380\" y=\"12\" "
               "text-anchor=\"end\">model outside</text><text x=\"200\" y=\"12\" "
               "text-anchor=\"middle\">mm</text></svg>\n";
}

std::string ViewFigure(const SoftwareRenderer& renderer, ViewSide side)
{
  const ViewFrame frame = FrameOf(side);
  const std::string size = std::to_string(ViewSize);
  const auto letter = [](double x, double y, const char* anchor, const Vector3& direction)
  {
    return "<text x=\"" + FixedText(x, 0) + "\" y=\"" + FixedText(y, 0) + "\" text-anchor=\"" +
           anchor + "\">" + OrientationLetters(direction) + "</text>";
  };
  const std::string svg =
      "<svg class=\"view\" role=\"img\" viewBox=\"0 0 " + size + " " + size + "\" aria-label=\"" +
      NameOf(side) + " view\"><image width=\"" + size + "\" height=\"" + size + "\" href=\"" +
      PngDataUri(renderer.Render(side, ViewSize)) + "\"/>" +
      letter(6.0, 0.5 * ViewSize + 5.0, "start", -frame.RightWorld) +
      letter(ViewSize - 6.0, 0.5 * ViewSize + 5.0, "end", frame.RightWorld) +
      letter(0.5 * ViewSize, 16.0, "middle", frame.UpWorld) +
      letter(0.5 * ViewSize, ViewSize - 6.0, "middle", -frame.UpWorld) + "</svg>";
  return ReportFigure(svg, NameOf(side));
}

std::string AllViews(const SoftwareRenderer& renderer)
{
  std::array<std::string, AllViewSides.size()> figures;
  vtkSMPTools::Transform(AllViewSides.begin(), AllViewSides.end(), figures.begin(),
                         [&](ViewSide side) { return ViewFigure(renderer, side); });
  std::string html = "<div class=\"views\">\n";
  for (const std::string& figure : figures)
  {
    html += figure;
  }
  return html + "</div>\n";
}

// Points of the drawn model in a cap that no direction, or no parameter of a surface model, covers;
// none if all gaps are narrow enough.
class UncoveredCap
{
public:
  explicit UncoveredCap(const FitResult& result)
      : Sphere(DrawnFrequency(result.Model, result.Settings.Frequency)),
        Gap(result.Coverage.LargestGap),
        IsWide(Gap.Radius > DirectionCoverage::WidestGap(DegreeOf(result.Model)))
  {
  }

  bool IsAny() const { return this->IsWide; }
  bool Holds(vtkIdType point) const
  {
    const Vector3& direction = this->Sphere.Directions()[static_cast<std::size_t>(point)];
    return this->IsWide && direction.dot(this->Gap.Center) > std::cos(this->Gap.Radius);
  }

private:
  IcosahedronDirections Sphere; // that the model is drawn at
  SphericalCap Gap;
  bool IsWide;
};

std::string ErrorMap(const FitResult& result, vtkDataArray* distances)
{
  constexpr SoftwareRenderer::Color Uncovered{{110, 110, 110}};
  const UncoveredCap uncovered(result);
  const double coloured = ColoredDistance(distances);
  const vtkSmartPointer<vtkLookupTable> colors = MakeArrayColors(-coloured, coloured);
  std::vector<SoftwareRenderer::Color> pointColors;
  double range[2];
  distances->GetRange(range);
  for (vtkIdType p = 0; p < distances->GetNumberOfTuples(); ++p)
  {
    pointColors.push_back(uncovered.Holds(p) ? Uncovered
                                             : ColorOf(colors, distances->GetComponent(p, 0)));
  }
  SoftwareRenderer renderer(result.ModelSurface);
  renderer.SetPointColors(std::move(pointColors));
  return "<p class=\"soft\">Signed distance from the model to the surface" +
         std::string(result.IsOfSurface ? "" : " of the mask") + ", from " +
         FixedText(range[0], 2) + " to " + (range[1] > 0.0 ? "+" : "") + FixedText(range[1], 2) +
         " mm. Distances beyond the ends of the bar have the ends\xE2\x80\x99 colours." +
         (uncovered.IsAny()
              ? " Grey: no direction meets the surface there, so the model is undetermined."
              : "") +
         "</p>\n" + AllViews(renderer) + ColorBar(colors);
}
} // namespace

std::string ReportViews(const FitResult& result)
{
  vtkPolyData* shown = result.ModelSurface ? result.ModelSurface : result.Surface;
  if (!shown || shown->GetNumberOfPolys() == 0)
  {
    return {};
  }
  vtkDataArray* distances = DistancesOf(result.ModelSurface);
  if (distances && distances->GetNumberOfTuples() == shown->GetNumberOfPoints())
  {
    return ErrorMap(result, distances);
  }
  return AllViews(SoftwareRenderer(shown));
}
} // namespace palpate
