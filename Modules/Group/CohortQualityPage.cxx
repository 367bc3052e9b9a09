#include "CohortQualityPage.h"

#include "DecimalText.h"
#include "HtmlText.h"
#include "MappedMean.h"
#include "ReportPage.h"
#include "ShapeFigures.h"
#include "SvgChart.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr std::size_t ListedCases = 10;
constexpr Eigen::Index ChartedModes = 40;
constexpr double FullColour = 4.0; // standard deviations
constexpr double FrameMargin = 1.05;

std::string CurveChart(const QualityCurve& curve, const std::string& axis, double factor,
                       const std::string& caption)
{
  SvgChart chart("modes", axis);
  SvgChart::Points line;
  std::vector<SvgChart::Dot> dots;
  for (Eigen::Index k = 0; k < std::min(curve.Values.size(), ChartedModes + 1); ++k)
  {
    const auto x = static_cast<double>(k);
    const double value = factor * curve.Values[k];
    const double error = factor * curve.StandardErrors[k];
    line.emplace_back(x, value);
    for (const double bound : {value - error, value + error})
    {
      dots.push_back({x, bound, "first faint", FixedText(bound, 3), ""});
    }
  }
  chart.SetLine(std::move(line));
  chart.SetDots(std::move(dots));
  return ReportFigure(chart.Svg(), caption);
}

std::string ModelCharts(const CohortQuality& quality)
{
  const ShapeModelQuality& model = quality.Model;
  const Eigen::Index count = model.Compactness.Values.size();
  if (count < 2)
  {
    return {};
  }
  return "<p>With the first modes: <em>compactness</em> is the variance that they hold together, "
         "<em>generalisation</em> the distance of a case from its best description by the modes of "
         "all others, <em>specificity</em> that of " +
         std::to_string(quality.Random.Count) + " random shapes (seed " +
         std::to_string(quality.Random.Seed) +
         ") from the nearest case (Davies, Twining and Taylor 2008). Distances are RMS over the "
         "surface\xE2\x80\x99s parameters, lower is better; dots are one standard error off.</p>\n"
         "<div class=\"charts\">" +
         CurveChart(model.Compactness, "compactness, % of variance",
                    100.0 / model.Compactness.Values[count - 1], "Compactness") +
         CurveChart(model.Generalisation, "generalisation, mm", 1.0, "Generalisation") +
         CurveChart(model.Specificity, "specificity, mm", 1.0, "Specificity") + "</div>\n";
}

// The side that shows the normal best.
ViewSide SideTowards(const Vector3& normal)
{
  return *std::max_element(AllViewSides.begin(), AllViewSides.end(),
                           [&](ViewSide a, ViewSide b) {
                             return FrameOf(a).TowardsViewerWorld.dot(normal) <
                                    FrameOf(b).TowardsViewerWorld.dot(normal);
                           });
}

std::string RareProbability(double p)
{
  return p < 1e-4 ? "&lt; 0.0001" : FixedText(p, 4);
}

std::string UnusualRow(const CohortGroup& group, const CohortQuality& quality, std::size_t rank,
                       ColoredShape& mean, bool showsNames)
{
  const UnusualCase& one = quality.Distances[rank];
  const Eigen::VectorXd map = quality.Maps.col(static_cast<Eigen::Index>(rank));
  mean.Values.assign(map.data(), map.data() + map.size());
  const ShapeFigures drawing(FrameMargin * mean.Extent(), FullColour);
  const ViewSide side = SideTowards(quality.Surface.Normals[one.Point]);
  const auto cell = [](const std::string& text)
  { return "<td class=\"number\">" + text + "</td>"; };
  return "<tr><td class=\"text\">" +
         (showsNames ? EscapeHtml(group.Rows[one.Row].Case) : std::to_string(one.Row + 1)) +
         "</td>" + cell(FixedText(one.Mahalanobis, 2)) + cell(RareProbability(one.P)) +
         cell(RareProbability(one.Discovery)) + cell(FixedText(one.OutsideMillimeters, 2)) +
         cell(FixedText(one.LargestZ, 1) + " " +
              OrientationLetters(quality.Surface.Points[one.Point].normalized())) +
         "<td><div style=\"width: 130px\">" + drawing.Figure(mean, side, NameOf(side)) +
         "</div></td></tr>\n";
}

std::string UnusualCases(const CohortGroup& group, const CohortQuality& quality, bool showsNames)
{
  if (quality.Distances.empty())
  {
    return {};
  }
  ColoredShape mean;
  mean.Mesh = MeanSurface(quality.Surface);
  std::string rows;
  for (std::size_t rank = 0; rank < std::min(ListedCases, quality.Distances.size()); ++rank)
  {
    rows += UnusualRow(group, quality, rank, mean, showsNames);
  }
  return "<p>Each case is compared with all others: its Mahalanobis distance in their first " +
         std::to_string(quality.ModeCount) +
         " modes, with the probability p of a normal case as far or farther (corrected "
         "for modes that are estimated) and the false-discovery rate q among the cases; outside, "
         "what "
         "these modes do not describe (RMS); z, the largest displacement along the "
         "mean\xE2\x80\x99s normal in standard deviations of the others, and where (LPS letters). "
         "Images show z: red outside, blue inside, full colour at " +
         SignificantText(FullColour, 2) +
         ".</p>\n<div class=\"wide\"><table><thead><tr><th scope=\"col\" class=\"text\">Case</th>"
         "<th scope=\"col\" class=\"number\">Mahalanobis</th>"
         "<th scope=\"col\" class=\"number\">p</th><th scope=\"col\" class=\"number\">q</th>"
         "<th scope=\"col\" class=\"number\">outside, mm</th>"
         "<th scope=\"col\" class=\"number\">largest z</th>"
         "<th scope=\"col\" class=\"number\">z</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n";
}
} // namespace

std::string CohortQualitySections(const CohortGroup& group, const CohortQuality& quality,
                                  bool showsNames)
{
  return ReportSection("Model of the group", ModelCharts(quality)) +
         ReportSection("Unusual cases", UnusualCases(group, quality, showsNames));
}
} // namespace palpate
