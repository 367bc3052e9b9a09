#pragma once

#include "OrganRelation.h"
#include "PalpateFitModule.h"
#include "Volume.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// The other organ that a completion is given: a model, or a structure of a segmentation (by number
/// or name; empty if it has only one), which is fitted as palpate fit does. Throws InputError.
PALPATEFIT_EXPORT LogSurface ReadKnownOrgan(const std::filesystem::path& file,
                                            const std::string& structure,
                                            const VolumeChoice& choice);
} // namespace palpate
