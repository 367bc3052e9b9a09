#include "FitVerdict.h"

#include "DecimalText.h"
#include "DegreeGoal.h"

namespace palpate
{
void Refuse(const std::string& reason, Hint& hint, FitResult& result)
{
  result.State = FitResult::Outcome::Refused;
  result.Message = reason;
  FitSettings settings = result.Settings;
  if (result.Details.Mapped != nullptr)
  {
    settings.Model = FitSettings::ModelKind::Surface;
  }
  result.OptionHint = hint(settings, OptionWords);
  result.WindowHint = hint(settings, WindowWords);
}

void JudgeOverlap(FitResult& result)
{
  const double limit = result.Settings.MinimumDice;
  if (!(result.Dice >= limit))
  {
    Refuse("is not matched by a model of degree " + std::to_string(DegreeOf(result.Model)) +
               ": Dice " + TextAgainstLimit(result.Dice, limit, 2) + " (limit " +
               TextAgainstLimit(limit, limit, 2) + "), " + FixedText(result.ModelMilliliters, 2) +
               " ml for a " + (result.IsOfSurface ? "surface" : "mask") + " of " +
               FixedText(result.InputMilliliters(), 2) + " ml",
           HintForMisfit, result);
    return;
  }
  result.State = FitResult::Outcome::Fitted;
}

void RemarkOnDegree(int supported, FitResult& result)
{
  const std::optional<DegreeGoal> goal = DegreeGoalOf(result);
  const double tolerance = goal && !goal->IsOfVoxels ? goal->Tolerance : result.Rms;
  if (result.Rms > tolerance)
  {
    result.Notes.push_back(
        "degree " + std::to_string(supported) +
        " is the highest that the mask's voxels support (wavelengths of two voxels); it leaves " +
        TextAgainstLimit(result.Rms, tolerance, 3) + " mm instead of the " +
        TextAgainstLimit(tolerance, tolerance, 3) + " mm requested");
  }
}

void RemarkOnCoverage(FitResult& result)
{
  if (result.Coverage.Outcome != DirectionCoverage::Verdict::Good)
  {
    result.Notes.push_back(result.Coverage.Message);
  }
}
} // namespace palpate
