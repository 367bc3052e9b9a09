#pragma once

#include "FitStages.h"

namespace palpate
{
/// Distances of the surface from a centre.
void RunSampling(FitSamples& made, const ProgressFunction& progress);

/// Whether the centre sees less of the sampled surface than the settings want,
bool IsHidden(const FitResult& result);
/// and the refusal of a radial model for it.
void RefuseHidden(FitResult& result);

/// Fits a radial model to the samples, draws it and judges it.
void MakeRadialFit(const FitSamples& samples, FitResult& result, const ProgressFunction& progress);
} // namespace palpate
