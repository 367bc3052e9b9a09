#include "ShapeFigures.h"

#include "ArrayColors.h"
#include "DecimalText.h"
#include "HtmlText.h"
#include "IcosahedronDirections.h"
#include "ModelSurface.h"
#include "RasterImage.h"
#include "Vector3.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr int OffsetFrequency = 24; // 5,762 points
constexpr double PaleShare = 0.25;
constexpr double PaleGrey = 205.0;

SoftwareRenderer::Color Paled(const SoftwareRenderer::Color& color)
{
  SoftwareRenderer::Color pale = color;
  for (auto& channel : pale)
  {
    channel =
        static_cast<std::uint8_t>(std::lround(PaleShare * channel + (1.0 - PaleShare) * PaleGrey));
  }
  return pale;
}
} // namespace

ColoredShape DrawOffsets(const OrganModel& shape, const OrganModel& mean)
{
  ColoredShape drawn{DrawModel(shape, OffsetFrequency), {}};
  const IcosahedronDirections sphere(OffsetFrequency);
  for (vtkIdType p = 0; p < drawn.Mesh->GetNumberOfPoints(); ++p)
  {
    Vector3 point;
    drawn.Mesh->GetPoint(p, point.data());
    if (const auto* radial = std::get_if<RadialModel>(&mean))
    {
      // The centre is the origin, so a point's own direction is the mean's too.
      drawn.Values.push_back(point.norm() - radial->Radius(point.normalized()));
    }
    else
    {
      const auto& surface = std::get<SurfaceModel>(mean);
      const Vector3& parameter = sphere.Directions()[static_cast<std::size_t>(p)];
      drawn.Values.push_back(surface.Normal(parameter).dot(point - surface.Point(parameter)));
    }
  }
  return drawn;
}

double ColoredShape::Extent() const
{
  const double* bounds = this->Mesh->GetBounds();
  return std::abs(*std::max_element(bounds, bounds + 6,
                                    [](double a, double b) { return std::abs(a) < std::abs(b); }));
}

double ColoredShape::LargestValue() const
{
  double largest = 0.0;
  for (const double value : this->Values)
  {
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

ShapeFigures::ShapeFigures(double halfWidth, double limit, int size)
    : HalfWidth(halfWidth), Size(size), Colors(MakeArrayColors(-limit, limit))
{
}

ReportFigure ShapeFigures::Figure(const ColoredShape& shape, ViewSide side,
                                  const std::string& caption, const std::vector<bool>& isPale) const
{
  std::vector<SoftwareRenderer::Color> colors;
  for (std::size_t p = 0; p < shape.Values.size(); ++p)
  {
    const SoftwareRenderer::Color color = ColorOf(this->Colors, shape.Values[p]);
    colors.push_back(p < isPale.size() && isPale[p] ? Paled(color) : color);
  }
  return this->Figure(shape.Mesh, std::move(colors), side, caption);
}

ReportFigure ShapeFigures::Figure(vtkPolyData* mesh, std::vector<SoftwareRenderer::Color> colors,
                                  ViewSide side, const std::string& caption) const
{
  SoftwareRenderer renderer(mesh);
  renderer.SetPointColors(std::move(colors));
  // The renderer puts the centre of the bounding box in the centre of its image.
  double middle[3];
  mesh->GetCenter(middle);
  const ViewFrame frame = FrameOf(side);
  const double half = renderer.HalfWidthMillimeters();
  const double x = frame.RightWorld.dot(Vector3(middle)) - half;
  const double y = -frame.UpWorld.dot(Vector3(middle)) - half;
  const auto text = [](double number) { return SignificantText(number, 6); };
  const std::string box = text(-this->HalfWidth) + " " + text(-this->HalfWidth) + " " +
                          text(2.0 * this->HalfWidth) + " " + text(2.0 * this->HalfWidth);
  return {"<svg class=\"view\" role=\"img\" viewBox=\"" + box + "\" aria-label=\"" +
              EscapeHtml(caption) + "\"><image x=\"" + text(x) + "\" y=\"" + text(y) +
              "\" width=\"" + text(2.0 * half) + "\" height=\"" + text(2.0 * half) + "\" href=\"" +
              PngDataUri(renderer.Render(side, this->Size)) + "\"/></svg>",
          caption};
}
} // namespace palpate
