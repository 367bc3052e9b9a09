#include "ReportViews.h"

#include "ArrayColors.h"
#include "DecimalText.h"
#include "IcosahedronDirections.h"
#include "ModelSurface.h"
#include "ReportPage.h"
#include "SixViews.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
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

void AddErrorMap(ReportPage& page, const FitResult& result, vtkDataArray* distances)
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
  page.SoftText("Signed distance from the model to the surface" +
                std::string(result.IsOfSurface ? "" : " of the mask") + ", from " +
                FixedText(range[0], 2) + " to " + (range[1] > 0.0 ? "+" : "") +
                FixedText(range[1], 2) +
                " mm. Distances beyond the ends of the bar have the ends\xE2\x80\x99 colours." +
                (uncovered.IsAny()
                     ? " Grey: no direction meets the surface there, so the model is undetermined."
                     : ""));
  AddSixViews(page, renderer);
  AddColorBar(page, colors, "model inside", "mm", "model outside");
}
} // namespace

void ReportViews(ReportPage& page, const FitResult& result)
{
  vtkPolyData* shown = result.ModelSurface ? result.ModelSurface : result.Surface;
  if (!shown || shown->GetNumberOfPolys() == 0)
  {
    return;
  }
  vtkDataArray* distances = DistancesOf(result.ModelSurface);
  if (distances && distances->GetNumberOfTuples() == shown->GetNumberOfPoints())
  {
    AddErrorMap(page, result, distances);
    return;
  }
  AddSixViews(page, SoftwareRenderer(shown));
}
} // namespace palpate
