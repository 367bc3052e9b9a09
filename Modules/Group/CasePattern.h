#pragma once

#include "CohortManifest.h"
#include "PalpateGroupModule.h"

#include <string>
#include <vector>

namespace palpate
{
/// Whether a text has a place for an id, as `sub-{id}/anat/sub-{id}_*_dseg.nii.gz`.
PALPATEGROUP_EXPORT bool IsCasePattern(const std::string& text);

/// The images or surfaces whose paths match a pattern, as cases named by their ids, sorted by name.
/// `{id}` stands for one character or more, as few as match, without a separator of folders; the
/// same wherever it is repeated. `*` stands for any characters of one folder's or file's name;
/// a leading dot must be written. Other characters, also `..`, stand for themselves. Throws
/// InputError if nothing matches, two files have one id, two ids have one folder name, the pattern
/// is longer than 4,096 characters or has `{id}` next to `*` or another `{id}`, or a folder cannot
/// be listed.
PALPATEGROUP_EXPORT std::vector<CohortCase> FindPatternCases(const std::string& pattern);
} // namespace palpate
