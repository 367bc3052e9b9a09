#include "SofteningReport.h"

#include "ArrayColors.h"
#include "DecimalText.h"
#include "IcosahedronDirections.h"
#include "ModelSurface.h"
#include "ReportPage.h"
#include "SixViews.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace palpate
{
namespace
{
constexpr int Frequency = 30;

// Percent of the places at which a hand notices at least one step of this sign.
double NoticedPercent(const FeltStiffness& felt, double sign)
{
  const auto count = std::count_if(felt.Noticed.begin(), felt.Noticed.end(),
                                   [sign](double noticed) { return sign * noticed >= 1.0; });
  return 100.0 * static_cast<double>(count) / static_cast<double>(felt.Noticed.size());
}
} // namespace

SofteningReport::SofteningReport(const ModelDocument& model, const ModelSoftness& softness,
                                 std::string name, double ballRadius)
    : Model(model), Softness(softness), Name(std::move(name)), Radius(ballRadius),
      Drawn(DrawModel(model.Surface, Frequency)),
      Felt(FeltStiffness::Of(std::get<RadialModel>(model.Surface), *softness.Elasticity, ballRadius,
                             IcosahedronDirections(Frequency).Directions()))
{
}

std::string SofteningReport::Sentence() const
{
  const std::string ball = "A ball of " + SignificantText(this->Radius, 3) + " mm";
  if (std::isnan(this->Felt.Median))
  {
    return ball + " is too large for this organ: nowhere does one patch of linear elasticity "
                  "describe its contact.";
  }
  return ball + ", " + FixedText(this->Felt.Depth, 1) + " mm deep, feels " +
         FixedText(this->Felt.Least, 2) + " to " + FixedText(this->Felt.Most, 2) +
         " N, in the median " + FixedText(this->Felt.Median, 2) +
         " N; noticeably harder than that " + "is " +
         FixedText(NoticedPercent(this->Felt, 1.0), 0) + " % of the surface, noticeably " +
         "softer " + FixedText(NoticedPercent(this->Felt, -1.0), 0) +
         " %. Tissue: " + this->Softness.Tissue + ".";
}

void SofteningReport::AddViews(ReportPage& page) const
{
  double limit = 1.0; // noticeable step, so that noise has no colours
  for (const double noticed : this->Felt.Noticed)
  {
    limit = std::isnan(noticed) ? limit : std::max(limit, std::abs(noticed));
  }
  const vtkSmartPointer<vtkLookupTable> colors = MakeArrayColors(-limit, limit);
  SoftwareRenderer renderer(this->Drawn);
  renderer.SetPointColors(SoftwareRenderer::ColorsOf(colors, this->Felt.Noticed));
  AddSixViews(page, renderer);
  AddColorBar(page, colors, "softer", "noticeable steps from the median", "harder");
}

std::string SofteningReport::Page() const
{
  const ComplianceMaps& maps = *this->Softness.Elasticity;
  ReportRows rows = this->Model.Provenance.Settings;
  rows.emplace_back("unknowns", std::to_string(this->Softness.Account.Unknowns));
  rows.emplace_back("elements at the surface",
                    FixedText(this->Softness.Account.ElementEdge, 1) + " mm");
  rows.emplace_back("left out by the maps", FixedText(100.0 * maps.FitError.Rms, 1) +
                                                " % of the compliance, at most " +
                                                FixedText(100.0 * maps.FitError.Largest, 1) + " %");
  rows.emplace_back("largest patch", FixedText(maps.LargestPatch, 1) + " mm");
  ReportPage page;
  page.Header("an organ that yields", this->Name)
      .Section("How hard its places feel")
      .Text(this->Sentence())
      .SoftText(
          "A noticeable step is 7 % of the median force, at least 0.035 N. Grey: the ball does "
          "not fit, or linear elasticity does not hold. The moduli are those that were given, "
          "not measured in this patient; a hand at a one-point device feels less than "
          "fingers.");
  this->AddViews(page);
  page.Section("What was built")
      .Facts("Settings and result", rows)
      .Notes(this->Softness.Warnings());
  return page.Whole(this->Name);
}
} // namespace palpate
