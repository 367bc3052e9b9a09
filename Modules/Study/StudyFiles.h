#pragma once

#include "PalpateStudyModule.h"
#include "SceneSettings.h"
#include "StudyPipeline.h"
#include "StudyState.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// Writes what was made of a study into `folder`: a folder for every structure that has a surface
/// or a model (see WriteFitFiles; a surface alone is surface.vtp), scene.json where there are
/// structures, markups.mrk.json and markups.csv where there are landmarks or distances. `program`
/// is the maker that coefficient files name. For when nothing is being made. Throws InputError.
PALPATESTUDY_EXPORT void WriteStudyFiles(const StudyState& state, const StudyPipeline& pipeline,
                                         const std::filesystem::path& folder,
                                         const std::string& program);
} // namespace palpate
