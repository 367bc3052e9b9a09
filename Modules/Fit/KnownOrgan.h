#pragma once

#include "OrganRelation.h"
#include "PalpateFitModule.h"
#include "Segmentation.h"
#include "Volume.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// The other organ that a completion is given: a structure, fitted as palpate fit does by default.
/// Throws InputError; `file` is for messages.
PALPATEFIT_EXPORT LogSurface FitKnownOrgan(const Segmentation& segmentation,
                                           const Segment& structure,
                                           const std::filesystem::path& file);
/// The same of a model.
PALPATEFIT_EXPORT LogSurface KnownOrganOf(const OrganModel& model,
                                          const std::filesystem::path& file);
/// The other organ that a completion is given: a model, or a structure of a segmentation (by number
/// or name; empty if it has only one). Throws InputError.
PALPATEFIT_EXPORT LogSurface ReadKnownOrgan(const std::filesystem::path& file,
                                            const std::string& structure,
                                            const VolumeChoice& choice);
} // namespace palpate
