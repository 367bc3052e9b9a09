#pragma once

#include "FitResult.h"
#include "FitSettings.h"
#include "PalpateFitModule.h"
#include "Progress.h"

namespace palpate
{
/// Runs the whole pipeline on one structure of a segmentation: surface, samples, fit, model,
/// quality. Does not throw for problems of the structure: the result's State and Message report
/// them, with the results up to then. Throws Cancelled if `progress` returns false.
PALPATEFIT_EXPORT FitResult FitStructure(const Segmentation& segmentation, const Segment& structure,
                                         const FitSettings& settings,
                                         const ProgressFunction& progress = {});

/// The same for a closed surface instead of a mask, the content of `file` (MakeFitSurface).
PALPATEFIT_EXPORT FitResult FitSurfaceFile(const std::filesystem::path& file, vtkPolyData* surface,
                                           const FitSettings& settings,
                                           const ProgressFunction& progress = {});

/// A file's name without folder and without the endings of the formats that Palpate reads
/// ("case.1.seg.nrrd" -> "case.1").
PALPATEFIT_EXPORT std::string CaseNameOf(const std::filesystem::path& file);
} // namespace palpate
