#include "CohortReparametrisation.h"

#include "CsvText.h"
#include "DecimalText.h"
#include "InputError.h"
#include "Progress.h"
#include "ReportPage.h"
#include "ReportTable.h"
#include "Units.h"

#include <algorithm>
#include <initializer_list>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{

/// Of the cases that moved.
struct MovedCases
{
  int Count = 0;
  double MeanTurn = 0.0;      // rad
  double MeanChange = 0.0;    // mm
  double WorstChange = 0.0;   // mm
  double LargestChange = 0.0; // mm
};

MovedCases SummaryOf(const std::vector<ReparametrisedCase>& cases)
{
  MovedCases moved;
  for (const ReparametrisedCase& one : cases)
  {
    moved.Count += one.IsMoved ? 1 : 0;
    moved.MeanTurn += one.RmsTurn;
    moved.MeanChange += one.RmsChange;
    moved.WorstChange = std::max(moved.WorstChange, one.RmsChange);
    moved.LargestChange = std::max(moved.LargestChange, one.LargestChange);
  }
  const double count = std::max(moved.Count, 1);
  moved.MeanTurn /= count;
  moved.MeanChange /= count;
  return moved;
}

void AddQuality(ReportTable& table, const ShapeModelQuality& before, const ShapeModelQuality& after)
{
  const Eigen::Index most =
      std::min(before.Compactness.Values.size(), after.Compactness.Values.size()) - 1;
  for (const Eigen::Index modes : {Eigen::Index{5}, Eigen::Index{20}})
  {
    if (modes <= most)
    {
      const std::string with = ", " + std::to_string(modes) + " modes, mm";
      table.Text("generalisation" + with)
          .Number(before.Generalisation.Values[modes], 3)
          .Number(after.Generalisation.Values[modes], 3)
          .Text("specificity" + with)
          .Number(before.Specificity.Values[modes], 3)
          .Number(after.Specificity.Values[modes], 3);
    }
  }
}
} // namespace

CohortReparametrisation ReparametriseCohortGroup(CohortGroup& group,
                                                 const RandomShapeSettings& random,
                                                 const KernelProgress& progress)
{
  std::vector<SurfaceModel> surfaces;
  for (const OrganModel& model : group.Models)
  {
    if (!std::holds_alternative<SurfaceModel>(model))
    {
      throw InputError("--reparametrise needs surface models, but these are radial ones, whose "
                       "directions correspond; fit with --model surface");
    }
    surfaces.push_back(std::get<SurfaceModel>(model));
  }
  bool isCancelled = false;
  const KernelProgress watched = [&](double done)
  {
    isCancelled = progress && !progress(done);
    return !isCancelled;
  };
  CohortReparametrisation made;
  Status status = ReparametriseGroup(surfaces, made.Settings, made.Result, watched);
  if (isCancelled)
  {
    throw Cancelled();
  }
  if (status.IsOk())
  {
    made.Before = MeasureShapeModel(group.Modes, random);
    group.Models.assign(made.Result.Surfaces.begin(), made.Result.Surfaces.end());
    made.Result.Surfaces.clear();
    status = FindShapeModes(CoefficientsOf(group), group.Modes);
    made.After = MeasureShapeModel(group.Modes, random);
  }
  if (!status.IsOk())
  {
    throw InputError("--reparametrise: " + status.Message());
  }
  return made;
}

std::string ReparametrisationTable(const CohortGroup& group,
                                   const CohortReparametrisation& reparametrisation)
{
  std::string text = CsvLine({"case", "label", "moved", "turn_deg", "least_area_ratio",
                              "rms_change_mm", "largest_change_mm"});
  for (std::size_t i = 0; i < group.Rows.size(); ++i)
  {
    const ReparametrisedCase& one = reparametrisation.Result.Cases[i];
    text += CsvLine({group.Rows[i].Case, std::to_string(group.Rows[i].Result.Structure.Label),
                     one.IsMoved ? "yes" : "no", ExactText(DegreesPerRadian * one.RmsTurn),
                     ExactText(one.LeastAreaRatio), ExactText(one.RmsChange),
                     ExactText(one.LargestChange)});
  }
  return text;
}

std::string ReparametrisationText(const CohortReparametrisation& reparametrisation)
{
  const ReparametrisationResult& result = reparametrisation.Result;
  const MovedCases moved = SummaryOf(result.Cases);
  return "The parameters of " + std::to_string(moved.Count) + " of " +
         std::to_string(result.Cases.size()) +
         " surfaces were moved, one to one, to shorten the description of the group (Davies et al. "
         "2002; the sum over the modes of log(1 + variance / noise\xC2\xB2), noise " +
         SignificantText(reparametrisation.Settings.NoiseMillimeters, 2) +
         " mm, weighted by the area of the mean), by steps along smooth fields (harmonics up to "
         "degree " +
         std::to_string(reparametrisation.Settings.FieldDegree) + ", " +
         std::to_string(result.Lengths.size() - 1) + " rounds); they turn by " +
         FixedText(DegreesPerRadian * moved.MeanTurn, 1) +
         "\xC2\xB0 (RMS). The surfaces themselves, fitted again in the same degree, change by " +
         FixedText(moved.MeanChange, 3) + " mm (mean RMS; largest of a case " +
         FixedText(moved.WorstChange, 3) + " mm, at most " +
         SignificantText(reparametrisation.Settings.ToleranceMillimeters, 2) +
         " mm allowed; largest of a point " + FixedText(moved.LargestChange, 2) + " mm).";
}

void AddReparametrisation(ReportPage& page, const CohortReparametrisation& reparametrisation)
{
  const ReparametrisationResult& result = reparametrisation.Result;
  ReportTable table({"Model of the group", "own parameters", "moved"});
  table.Text("description length")
      .Number(result.LengthBefore, 2)
      .Number(result.LengthAfter, 2)
      .Text("variance, mm\xC2\xB2")
      .Number(result.VarianceBefore, 2)
      .Number(result.VarianceAfter, 2);
  AddQuality(table, reparametrisation.Before, reparametrisation.After);
  page.Section("Parameters moved")
      .Text(ReparametrisationText(reparametrisation) +
            " Distances at equal parameters are what was made small; that they are smaller does "
            "not show that equal parameters are equal places of the organ.")
      .Table(table);
}
} // namespace palpate
