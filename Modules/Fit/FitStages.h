#pragma once

#include "FitResult.h"
#include "FitSettings.h"
#include "PalpateFitModule.h"
#include "Progress.h"

namespace palpate
{
/// The stages of FitStructure, each with a result that can be kept: whoever changes what only a
/// later stage depends on begins there. Nothing of a result is changed by what is made from it.
/// None throws for what is wrong with the structure: then Found says so, and later stages pass it
/// on. All throw Cancelled. Each tells its own progress from 0 to 1.

/// What a structure's mask and surface are.
struct FitSurface
{
  FitResult Found;
  vtkSmartPointer<vtkPolyData> Boundary; ///< the mask's own half level, to measure against
  bool IsOver = false;                   ///< the structure stands in the way
};

/// How far the surface lies from a centre.
struct FitSamples
{
  FitResult Found;
  vtkSmartPointer<vtkPolyData> Boundary;
  vtkSmartPointer<vtkPolyData> Samples; ///< see vtkRadialSampler
  bool IsOver = false;
};

/// Depends on Method, Smoothing and Component.
PALPATEFIT_EXPORT FitSurface MakeFitSurface(const Segmentation& segmentation,
                                            const Segment& structure, const FitSettings& settings,
                                            const ProgressFunction& progress);

/// Depends on Frequency, the centre and MaximumHiddenPercent too.
PALPATEFIT_EXPORT FitSamples MakeFitSamples(const FitSurface& surface, const FitSettings& settings,
                                            const ProgressFunction& progress);

/// Depends on all settings.
PALPATEFIT_EXPORT FitResult MakeFitModel(const FitSamples& samples, const FitSettings& settings,
                                         const ProgressFunction& progress);
} // namespace palpate
