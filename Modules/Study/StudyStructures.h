#pragma once

#include "PalpateStudyModule.h"
#include "Segmentation.h"
#include "StudyState.h"

#include <filesystem>
#include <string>

namespace palpate
{
struct StudyThreshold;

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

/// The state with a further structure, of which id, colour and name are replaced if they are in
/// use.
PALPATESTUDY_EXPORT StudyState WithStructure(const StudyState& state,
                                             const SceneStructure& structure);

/// The state with the corrected structure, which has been written to a file with the same labels,
/// as one of this name; the structure that was corrected stays, but is neither shown nor touched,
/// and nothing is being corrected any more.
PALPATESTUDY_EXPORT StudyState WithKeptCorrection(const StudyState& state, const std::string& name,
                                                  const std::filesystem::path& file);

/// The structure of values of the state's volume. Throws InputError if there is no volume, for
/// values that are not numbers or not in order, and if the limiting structure is not a label.
PALPATESTUDY_EXPORT SceneStructure ThresholdStructure(const StudyState& state,
                                                      const StudyThreshold& threshold);

/// Reads a scene file, changed by a patch (see ReadScene), and the segmentations that it names (see
/// ResolveLabels). Throws InputError.
PALPATESTUDY_EXPORT SceneSettings ReadWholeScene(const std::filesystem::path& file,
                                                 LeftHandedAxes leftHanded,
                                                 const std::filesystem::path& patch = {});

/// The state with the structures, tool, device, rate and placement of a scene with resolved labels.
/// A state without structures takes everything; otherwise its own structures, their fit and axes
/// stay, and structures that it has already are left out.
PALPATESTUDY_EXPORT StudyState WithScene(const StudyState& state, const SceneSettings& scene);
} // namespace palpate
