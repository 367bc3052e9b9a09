#pragma once

#include "FitResult.h"
#include "FitSettings.h"
#include "PalpateFitModule.h"
#include "Progress.h"
#include "RadialSampling.h"

#include <memory>

namespace palpate
{
/// The stages of FitStructure. Their results can be kept, so that after a change of settings only
/// the stages that depend on it run again; a stage does not modify the results of earlier ones.
/// Problems of the structure are reported in Found, which later stages pass on; the stages throw
/// only Cancelled. Each reports its own progress from 0 to 1.

/// Mask and surface of a structure.
struct FitSurface
{
  FitResult Found;
  vtkSmartPointer<vtkPolyData> Boundary; ///< the mask's half-level surface, for measurements
  bool IsOver = false;                   ///< the structure cannot be processed further
};

/// Distances of the surface from a centre, or its place on the parameter sphere (Found.Details).
struct FitSamples
{
  FitResult Found;
  vtkSmartPointer<vtkPolyData> Boundary;
  std::shared_ptr<const RadialSampling> Samples; ///< of a radial model
  bool IsOver = false;
  bool IsTriedWithParts = false; ///< to map it together with the parts near it
};

/// Depends on Method, Smoothing and Component.
PALPATEFIT_EXPORT FitSurface MakeFitSurface(const Segmentation& segmentation,
                                            const Segment& structure, const FitSettings& settings,
                                            const ProgressFunction& progress);

/// Depends on Model, Repairs, IsAlone, Frequency, the centre, MaximumHiddenPercent and MinimumDice
/// too.
PALPATEFIT_EXPORT FitSamples MakeFitSamples(const FitSurface& surface, const FitSettings& settings,
                                            const ProgressFunction& progress);

/// Depends on all settings.
PALPATEFIT_EXPORT FitResult MakeFitModel(const FitSamples& samples, const FitSettings& settings,
                                         const ProgressFunction& progress);
} // namespace palpate
