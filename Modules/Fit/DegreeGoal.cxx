#include "DegreeGoal.h"

#include "DecimalText.h"
#include "VoxelMinimum.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// Between voxels and slices: a fifth of the geometric mean of the smallest and the largest side.
double ToleranceOf(const FitResult& result)
{
  constexpr double Part = 0.2;
  const double largest = ResolutionOf(result);
  if (result.Mask == nullptr)
  {
    return Part * largest;
  }
  const double* spacing = result.Mask->GetSpacing();
  return Part * std::sqrt(largest * *std::min_element(spacing, spacing + 3));
}
} // namespace

std::optional<DegreeGoal> DegreeGoalOf(const FitResult& result)
{
  const FitSettings& settings = result.Settings;
  if (!settings.Tolerance)
  {
    return {};
  }
  if (*settings.Tolerance > 0.0 || settings.Rules < 2)
  {
    return DegreeGoal{*settings.Tolerance, 0, false};
  }
  const int least = std::min(settings.Degree, settings.MaximumDegree);
  return DegreeGoal{ToleranceOf(result), least, least > 0};
}

bool MissesGoal(const FitResult& result)
{
  const std::optional<DegreeGoal> goal = DegreeGoalOf(result);
  return goal && result.Rms > goal->Tolerance;
}

void RemarkOnGoal(FitResult& result)
{
  const std::optional<DegreeGoal> goal = DegreeGoalOf(result);
  if (!goal || result.Settings.Rules < 2 || result.State != FitResult::Outcome::Fitted)
  {
    return;
  }
  const bool isMissed = result.Rms > goal->Tolerance;
  std::string text = "degree " + std::to_string(DegreeOf(result.Model)) + " leaves " +
                     SignificantAgainstLimit(result.Rms, goal->Tolerance, 3) +
                     " mm RMS along the normals of the surface that was fitted, " +
                     (isMissed ? "more than the " : "within the ") +
                     SignificantText(goal->Tolerance, 3) + " mm " +
                     (goal->IsOfVoxels ? "that are a fifth of a voxel" : "requested");
  if (!result.IsOfSurface)
  {
    text += "; from the mask's boundary, with its steps, the model is " +
            SignificantText(result.ModelToMask.Rms, 3) + " mm RMS away";
  }
  result.Notes.push_back(text);
}
} // namespace palpate
