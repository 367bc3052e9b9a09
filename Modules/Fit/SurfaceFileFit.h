#pragma once

#include "FitStages.h"
#include "PalpateFitModule.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// The first stage of a fit to a closed surface instead of a mask: the surface as MakeClosedMesh
/// makes it from a file's content, with remarks on what was changed. A surface that cannot be
/// mended is bad input, unless the settings say to repair it. Depends on Repairs, Component and
/// IsAlone. Throws InputError for a surface without triangles, and Cancelled.
PALPATEFIT_EXPORT FitSurface MakeFitSurface(const std::filesystem::path& file, vtkPolyData* surface,
                                            const FitSettings& settings,
                                            const ProgressFunction& progress);

/// Maps the surface of a file's result to the parameter sphere (Details). Returns why it cannot, as
/// a predicate, or an empty text. Throws Cancelled.
PALPATEFIT_EXPORT std::string MapSurfaceFile(FitResult& result, const ProgressFunction& progress);
} // namespace palpate
