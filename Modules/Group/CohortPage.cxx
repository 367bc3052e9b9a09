#include "CohortPage.h"

#include "AnatomicalView.h"
#include "ArrayColors.h"
#include "DecimalText.h"
#include "HtmlText.h"
#include "IcosahedronDirections.h"
#include "ModelSurface.h"
#include "RasterImage.h"
#include "ReportPage.h"
#include "SoftwareRenderer.h"
#include "SvgChart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr int Frequency = 24;       // of the drawn surfaces: 5,762 points
constexpr int ViewSize = 260;       // pixels
constexpr double FrameShare = 1.05; // of the largest shape's extent
constexpr std::array<ViewSide, 3> Sides{{ViewSide::Anterior, ViewSide::Right, ViewSide::Superior}};

/// A shape's triangles, and the distance of each point outside the mean (mm).
struct Drawn
{
  vtkSmartPointer<vtkPolyData> Mesh;
  std::vector<double> Offsets;
};

Drawn Draw(const SurfaceModel& shape, const SurfaceModel& mean)
{
  Drawn drawn{DrawModel(shape, Frequency), {}};
  const IcosahedronDirections sphere(Frequency);
  for (vtkIdType p = 0; p < drawn.Mesh->GetNumberOfPoints(); ++p)
  {
    Vector3 point;
    drawn.Mesh->GetPoint(p, point.data());
    if (const auto* radial = std::get_if<SphericalHarmonicModel>(&mean))
    {
      // The centre is the origin, so a point's own direction is the mean's too.
      drawn.Offsets.push_back(point.norm() - radial->Radius(point.normalized()));
    }
    else
    {
      const auto& surface = std::get<ParametricSphericalSurface>(mean);
      const Vector3& parameter = sphere.Directions()[static_cast<std::size_t>(p)];
      drawn.Offsets.push_back(surface.Normal(parameter).dot(point - surface.Point(parameter)));
    }
  }
  return drawn;
}

double LargestExtent(const Drawn& drawn)
{
  const double* bounds = drawn.Mesh->GetBounds();
  return std::abs(*std::max_element(bounds, bounds + 6,
                                    [](double a, double b) { return std::abs(a) < std::abs(b); }));
}

/// Draws shapes at the same scale, with the common centre in the image centre.
class ShapeFigures
{
public:
  ShapeFigures(double halfWidth, double offset)
      : HalfWidth(halfWidth), Colors(MakeArrayColors(-offset, offset))
  {
  }

  /// The offset of full colour.
  double Limit() const { return this->Colors->GetRange()[1]; }

  std::string Figure(const Drawn& drawn, ViewSide side, const std::string& caption) const
  {
    SoftwareRenderer renderer(drawn.Mesh);
    std::vector<SoftwareRenderer::Color> colors;
    for (const double offset : drawn.Offsets)
    {
      colors.push_back(ColorOf(this->Colors, offset));
    }
    renderer.SetPointColors(std::move(colors));
    // The renderer puts the centre of the bounding box in the centre of its image.
    double middle[3];
    drawn.Mesh->GetCenter(middle);
    const ViewFrame frame = FrameOf(side);
    const double half = renderer.HalfWidthMillimeters();
    const double x = frame.RightWorld.dot(Vector3(middle)) - half;
    const double y = -frame.UpWorld.dot(Vector3(middle)) - half;
    const auto text = [](double number) { return SignificantText(number, 6); };
    const std::string box = text(-this->HalfWidth) + " " + text(-this->HalfWidth) + " " +
                            text(2.0 * this->HalfWidth) + " " + text(2.0 * this->HalfWidth);
    return ReportFigure("<svg class=\"view\" role=\"img\" viewBox=\"" + box + "\" aria-label=\"" +
                            EscapeHtml(caption) + "\"><image x=\"" + text(x) + "\" y=\"" + text(y) +
                            "\" width=\"" + text(2.0 * half) + "\" height=\"" + text(2.0 * half) +
                            "\" href=\"" + PngDataUri(renderer.Render(side, ViewSize)) +
                            "\"/></svg>",
                        caption);
  }

private:
  double HalfWidth;
  vtkSmartPointer<vtkLookupTable> Colors;
};

std::string Explained(const ShapeModes& modes)
{
  SvgChart chart("mode", "explained variance, %");
  std::vector<std::pair<double, double>> bars;
  for (Eigen::Index k = 0; k < std::min<Eigen::Index>(modes.Explained.size(), 12); ++k)
  {
    bars.emplace_back(static_cast<double>(k + 1), 100.0 * modes.Explained[k]);
  }
  chart.SetBars(std::move(bars), 0.8);
  return "<div class=\"charts\">" + ReportFigure(chart.Svg(), "Variance explained by each mode") +
         "</div>\n";
}

std::string CaseRows(const CohortGroup& group)
{
  std::string rows;
  const auto cell = [](const std::string& text)
  { return "<td class=\"number\">" + text + "</td>"; };
  const Eigen::Index scores = std::min<Eigen::Index>(group.Modes.Modes.cols(), 2);
  for (std::size_t row = 0; row < group.Rows.size(); ++row)
  {
    rows += "<tr><td class=\"text\">" + EscapeHtml(group.Rows[row].Case) + "</td>" +
            cell(FixedText(group.Bodies[row].Volume / 1000.0, 2)) +
            cell(FixedText(group.Rows[row].Result.Dice, 4));
    for (Eigen::Index k = 0; k < 2; ++k)
    {
      const bool isKnown = k < scores;
      rows += cell(isKnown ? FixedText(group.Modes.Scores(static_cast<Eigen::Index>(row), k) /
                                           group.Modes.Deviations[k],
                                       2)
                           : std::string());
    }
    rows += "</tr>\n";
  }
  return "<div class=\"wide\"><table><thead><tr><th scope=\"col\" class=\"text\">Case</th>"
         "<th scope=\"col\" class=\"number\">Model, ml</th>"
         "<th scope=\"col\" class=\"number\">Dice</th>"
         "<th scope=\"col\" class=\"number\">Mode 1, sd</th>"
         "<th scope=\"col\" class=\"number\">Mode 2, sd</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n";
}

std::string ModeTitle(const CohortGroup& group, int mode)
{
  const ShapeModes& modes = group.Modes;
  const bool isRadial = std::holds_alternative<SphericalHarmonicModel>(group.Models.front());
  return "Mode " + std::to_string(mode + 1) + ": " + FixedText(100.0 * modes.Explained[mode], 1) +
         " % of the variance, standard deviation " +
         FixedText(modes.Deviations[mode] / std::sqrt(4.0 * M_PI), 2) + " mm (RMS of the " +
         (isRadial ? "radius" : "position") + ")";
}

// The mean first, then the two shapes of each shown mode.
std::vector<Drawn> DrawAll(const CohortGroup& group, double deviations)
{
  const SurfaceModel mean = ShapeOf(group, -1, 0.0);
  std::vector<Drawn> drawn{Draw(mean, mean)};
  for (int mode = 0; mode < ShownModes(group); ++mode)
  {
    drawn.push_back(Draw(ShapeOf(group, mode, -deviations), mean));
    drawn.push_back(Draw(ShapeOf(group, mode, deviations), mean));
  }
  return drawn;
}
} // namespace

int ShownModes(const CohortGroup& group)
{
  return static_cast<int>(std::min<Eigen::Index>(group.Modes.Modes.cols(), MostShownModes));
}

std::string CohortPage(const CohortGroup& group, double deviations)
{
  const std::vector<Drawn> drawn = DrawAll(group, deviations);
  double extent = 0.0;
  double offset = 1e-3; // below a micrometre only rounding would be coloured
  for (const Drawn& shape : drawn)
  {
    extent = std::max(extent, LargestExtent(shape));
    for (const double one : shape.Offsets)
    {
      offset = std::max(offset, std::abs(one));
    }
  }
  const ShapeFigures figures(FrameShare * extent, offset);
  const std::string several = SignificantText(deviations, 2) + " sd";
  std::string meanViews;
  for (const ViewSide side : Sides)
  {
    meanViews += figures.Figure(drawn.front(), side, NameOf(side));
  }
  std::string modes = Explained(group.Modes);
  for (int mode = 0; mode < ShownModes(group); ++mode)
  {
    const auto first = static_cast<std::size_t>(2 * mode + 1);
    modes += "<h3>" + ModeTitle(group, mode) + "</h3>\n<div class=\"views\">\n" +
             figures.Figure(drawn[first], ViewSide::Anterior, "mean \xE2\x88\x92 " + several) +
             figures.Figure(drawn.front(), ViewSide::Anterior, "mean") +
             figures.Figure(drawn[first + 1], ViewSide::Anterior, "mean + " + several) + "</div>\n";
  }
  const bool isPatient = group.Axes == AlignmentAxes::Patient;
  return ReportPage(
      "Palpate cohort",
      "<header>\n<div class=\"kicker\">Palpate \xC2\xB7 cohort</div>\n<h1>" +
          std::to_string(group.Rows.size()) + " shapes, degree " +
          std::to_string(DegreeOf(group.Models.front())) +
          "</h1>\n<p class=\"soft\">The centres are aligned; axes are " +
          (isPatient ? "the patients\xE2\x80\x99 own (LPS)"
                     : "each body\xE2\x80\x99s principal ones, the longest as left, the shortest "
                       "as up") +
          ". All images have the same scale; red is outside the mean, blue inside, full colour "
          "at " +
          SignificantText(figures.Limit(), 3) + " mm.</p>\n</header>\n" +
          ReportSection("Mean shape", "<div class=\"views\">\n" + meanViews + "</div>\n") +
          ReportSection("Principal modes", modes) + ReportSection("Cases", CaseRows(group)) +
          ReportSection("Notes", ReportNotes(group.Notes)) + ReportFooter());
}
} // namespace palpate
