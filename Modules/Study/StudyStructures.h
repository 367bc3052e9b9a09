#pragma once

#include "PalpateStudyModule.h"
#include "Segmentation.h"
#include "StudyState.h"

#include <filesystem>

namespace palpate
{
/// Whether a state lacks the structures of its segmentation.
bool LacksStructures(const StudyState& state);

/// An id above those of all structures and labels.
int NextFreeId(const StudyState& state);

/// The state with one structure per label of its segmentation, replacing those of that file.
PALPATESTUDY_EXPORT StudyState WithStructuresOf(const StudyState& state,
                                                const Segmentation& segmentation);

/// The state with the structures of a further segmentation at `file`, after those that it has;
/// labels that it has already are left out. They are not touched, since a lesion would be in the
/// way of the tool. Colours and names that are in use are replaced, so that structures can be told
/// apart. Without a segmentation of its own, the state takes this one.
PALPATESTUDY_EXPORT StudyState WithAddedStructuresOf(const StudyState& state,
                                                     const std::filesystem::path& file,
                                                     const Segmentation& segmentation);
} // namespace palpate
