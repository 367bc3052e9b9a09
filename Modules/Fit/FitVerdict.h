#pragma once

#include "FitHints.h"
#include "FitResult.h"

namespace palpate
{
/// Refuses the structure for a reason, with what may help.
void Refuse(const std::string& reason, Hint& hint, FitResult& result);

/// Accepts a model that overlaps the structure enough, or refuses it.
void JudgeOverlap(FitResult& result);

/// Adds a note if the search for a degree ended at the highest that the mask's voxels support,
/// before it met the tolerance.
void RemarkOnDegree(int supported, FitResult& result);

/// Adds a note if too few directions determine part of the model.
void RemarkOnCoverage(FitResult& result);
} // namespace palpate
