#include "CohortQualityPage.h"

#include "DecimalText.h"
#include "MappedMean.h"
#include "ReportPage.h"
#include "ReportTable.h"
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

void AddCurve(ReportPage& page, const QualityCurve& curve, const std::string& axis, double factor,
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
  page.Chart(chart, caption);
}

void AddModel(ReportPage& page, const CohortQuality& quality)
{
  const ShapeModelQuality& model = quality.Model;
  const Eigen::Index count = model.Compactness.Values.size();
  if (count < 2)
  {
    return;
  }
  page.Text("With the first modes: compactness is the variance that they hold together, "
            "generalisation the distance of a case from its best description by the modes of all "
            "others, specificity that of " +
            std::to_string(quality.Random.Count) + " random shapes (seed " +
            std::to_string(quality.Random.Seed) +
            ") from the nearest case (Davies, Twining and Taylor 2008). Distances are RMS over the "
            "surface\xE2\x80\x99s parameters, lower is better; dots are one standard error off.");
  AddCurve(page, model.Compactness, "compactness, % of variance",
           100.0 / model.Compactness.Values[count - 1], "Compactness");
  AddCurve(page, model.Generalisation, "generalisation, mm", 1.0, "Generalisation");
  AddCurve(page, model.Specificity, "specificity, mm", 1.0, "Specificity");
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
  return p < 1e-4 ? "< 0.0001" : FixedText(p, 4);
}

void AddUnusualCases(ReportPage& page, const CohortGroup& group, const CohortQuality& quality,
                     bool showsNames)
{
  if (quality.Distances.empty())
  {
    return;
  }
  page.Text(
      "Each case is compared with all others: its Mahalanobis distance in their first " +
      std::to_string(quality.ModeCount) +
      " modes, with the probability p of a normal case as far or farther (corrected for modes "
      "that are estimated) and the false-discovery rate q among the cases; outside, what these "
      "modes do not describe (RMS); z, the largest displacement along the mean\xE2\x80\x99s "
      "normal in standard deviations of the others, and where (LPS letters). Images show z: "
      "red outside, blue inside, full colour at " +
      SignificantText(FullColour, 2) + ".");
  ReportTable table({"Case", "Mahalanobis", "p", "q", "outside, mm", "largest z", "z"});
  ColoredShape mean;
  mean.Mesh = MeanSurface(quality.Surface);
  const ShapeFigures drawing(FrameMargin * mean.Extent(), FullColour);
  for (std::size_t rank = 0; rank < std::min(ListedCases, quality.Distances.size()); ++rank)
  {
    const UnusualCase& one = quality.Distances[rank];
    const Eigen::VectorXd map = quality.Maps.col(static_cast<Eigen::Index>(rank));
    mean.Values.assign(map.data(), map.data() + map.size());
    const ViewSide side = SideTowards(quality.Surface.Normals[one.Point]);
    table.Text(group.ShownName(one.Row, showsNames))
        .Number(one.Mahalanobis, 2)
        .Value(RareProbability(one.P))
        .Value(RareProbability(one.Discovery))
        .Number(one.OutsideMillimeters, 2)
        .Value(FixedText(one.LargestZ, 1) + " " +
               OrientationLetters(quality.Surface.Points[one.Point].normalized()))
        .Image(drawing.Figure(mean, side, NameOf(side)));
  }
  page.Table(table);
}
} // namespace

void AddCohortQuality(ReportPage& page, const CohortGroup& group, const CohortQuality& quality,
                      bool showsNames)
{
  AddModel(page.Section("Model of the group"), quality);
  AddUnusualCases(page.Section("Unusual cases"), group, quality, showsNames);
}
} // namespace palpate
