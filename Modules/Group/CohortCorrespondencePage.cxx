#include "CohortCorrespondencePage.h"

#include "DecimalText.h"
#include "IcosahedronDirections.h"
#include "ModelSurface.h"
#include "ParameterColors.h"
#include "ReportPage.h"
#include "ShapeFigures.h"

#include <algorithm>
#include <vector>

namespace palpate
{
namespace
{
constexpr int ThumbnailFrequency = 14; // 1,962 points
constexpr int ThumbnailSize = 96;      // pixels
constexpr double ThumbnailMargin = 1.05;
constexpr std::size_t MostThumbnails = 500; // some 6 MB; of more cases the marked ones, too

std::vector<SoftwareRenderer::Color> SphereColors()
{
  std::vector<SoftwareRenderer::Color> colors;
  const IcosahedronDirections sphere(ThumbnailFrequency);
  for (const Vector3& direction : sphere.Directions())
  {
    colors.push_back(ParameterColor(direction));
  }
  return colors;
}

double LargestExtent(const std::vector<OrganModel>& models)
{
  double extent = 0.0;
  for (const OrganModel& model : models)
  {
    extent = std::max(extent, ColoredShape{DrawModel(model, ThumbnailFrequency), {}}.Extent());
  }
  return extent;
}

std::string CaptionOf(const CohortGroup& group, const CorrespondingCase& one, bool showsNames)
{
  std::string caption =
      group.ShownName(one.Row, showsNames) + ": " + FixedText(one.Found.Distance, 2) + " mm";
  if (one.Found.IsFlipped())
  {
    caption += ", flipped (" + FixedText(one.Found.TurnRatio(), 1) + ")";
  }
  return caption + (one.IsOutlier ? ", outlier" : "");
}

std::string RuleText(const CohortCorrespondence& correspondence)
{
  const auto flips =
      std::count_if(correspondence.Cases.begin(), correspondence.Cases.end(),
                    [](const CorrespondingCase& one) { return one.Found.IsFlipped(); });
  const auto outliers = std::count_if(correspondence.Cases.begin(), correspondence.Cases.end(),
                                      [](const CorrespondingCase& one) { return one.IsOutlier; });
  return "Each case from the front, at one scale, with the same colours on the parameter "
         "sphere: a hue for each octant, light and dark cells of 30\xC2\xB0. Equal colours are "
         "what the model takes for equal places. The cases are sorted by their RMS distance at "
         "equal "
         "parameters from the mean of all others, weighted as in their geometric median. "
         "Flipped: in another orientation, 45\xC2\xB0 or more away, the case is clearly "
         "closer to that mean; in brackets the ratio of the distances in its own orientation and "
         "in the other one, each at its optimum and best size, over " +
         FixedText(FlippedRatio, 0) +
         ". Outlier: the distance is beyond the third quartile by 1.5 times the "
         "quartiles\xE2\x80\x99 distance, of logarithms. Found: " +
         std::to_string(flips) + " flipped, " + std::to_string(outliers) + " outliers.";
}
} // namespace

void AddCohortCorrespondence(ReportPage& page, const CohortGroup& group,
                             const CohortCorrespondence& correspondence, bool showsNames)
{
  if (correspondence.Cases.empty())
  {
    return;
  }
  const std::vector<SoftwareRenderer::Color> colors = SphereColors();
  const ShapeFigures drawing(ThumbnailMargin * LargestExtent(group.Models), 1.0, ThumbnailSize);
  const auto add = [&](const OrganModel& model, const std::string& caption, bool isMarked)
  {
    ReportFigure figure =
        drawing.Figure(DrawModel(model, ThumbnailFrequency), colors, ViewSide::Anterior, caption);
    figure.IsMarked = isMarked;
    page.Figure("thumbnails", figure);
  };
  page.Section("Correspondence").Text(RuleText(correspondence));
  add(ShapeOf(group, -1, 0.0), "mean", false);
  for (std::size_t rank = 0; rank < correspondence.Cases.size(); ++rank)
  {
    const CorrespondingCase& one = correspondence.Cases[rank];
    const bool isMarked = one.Found.IsFlipped() || one.IsOutlier;
    if (rank < MostThumbnails || isMarked)
    {
      add(group.Models[one.Row], CaptionOf(group, one, showsNames), isMarked);
    }
  }
}
} // namespace palpate
