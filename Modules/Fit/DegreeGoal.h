#pragma once

#include "FitResult.h"

#include <optional>

namespace palpate
{
/// What a search for a degree has to reach.
struct DegreeGoal
{
  double Tolerance = 0.0; ///< mm, of the RMS residual along the normals (FitResult::Rms)
  int Least = 0;          ///< degree
  /// The tolerance follows from the voxels (FitSettings::Tolerance 0): a fifth of the geometric
  /// mean of their largest and smallest sides, of a surface file of ResolutionOf, and never a lower
  /// degree than that of a fixed fit. If no degree meets it, the highest is taken.
  bool IsOfVoxels = false;
};

/// Empty if the degree is given. Needs what a fit has measured of its structure.
std::optional<DegreeGoal> DegreeGoalOf(const FitResult& result);

/// Whether the model of a result leaves more than its search was to reach.
bool MissesGoal(const FitResult& result);

/// Adds a note on a search for a degree: what was to be reached and what was, and how far the
/// mask's own steps are from the model.
void RemarkOnGoal(FitResult& result);
} // namespace palpate
