#pragma once

#include "CohortGroup.h"
#include "PalpateGroupModule.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// The mean of a group plus some of its modes, from text such as "1:2,3:-1": two standard
/// deviations of mode 1 and minus one of mode 3; "0" is the mean itself. Throws InputError if the
/// text is something else, a mode is named twice or does not exist, or the surface of a radial
/// model would pass through its centre.
PALPATEGROUP_EXPORT OrganModel SynthesizeShape(const CohortGroup& group, const std::string& text);

/// Writes that shape as shape.json into an existing folder. Throws InputError.
PALPATEGROUP_EXPORT void WriteSynthesis(const CohortGroup& group, const std::string& text,
                                        const std::filesystem::path& folder,
                                        const std::string& program);
} // namespace palpate
