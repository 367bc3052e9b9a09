#pragma once

#include "PalpateStudyModule.h"
#include "Progress.h"
#include "StudyState.h"

#include <filesystem>
#include <vector>

namespace palpate
{
/// Scenes to begin with, of which the first three are made here.
enum class SampleScene
{
  Prostate, ///< a prostate-like body with its MR volume
  Lesion,   ///< the same, elastic, with a stiff nodule (Documentation/Tutorial/FeelALesion.md)
  Mastoid,  ///< bone to be drilled, with a forbidden nerve and sinus
  Head      ///< some of the 116 structures of Colin 27, of Debian's mricron-data
};

/// The files of the head: its volume and its structures.
PALPATESTUDY_EXPORT std::vector<std::filesystem::path> HeadFiles();

/// The scene as a new study, ready to be touched. Its images are made in a folder below `folder`
/// unless they are there. Throws InputError if that fails, and Cancelled.
PALPATESTUDY_EXPORT StudyState MakeSampleScene(SampleScene scene,
                                               const std::filesystem::path& folder,
                                               const ProgressFunction& progress = {});

/// A new study that shows the surfaces of two segmentations over each other, the second one
/// translucent. Throws InputError if one cannot be read, and Cancelled.
PALPATESTUDY_EXPORT StudyState CompareMasks(const std::filesystem::path& first,
                                            const std::filesystem::path& second,
                                            const ProgressFunction& progress = {});
} // namespace palpate
