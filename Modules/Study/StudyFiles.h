#pragma once

#include "PalpateStudyModule.h"
#include "SceneSettings.h"
#include "StudyPipeline.h"
#include "StudyState.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// Writes the products of a study into `folder`: a folder for every structure with a surface or a
/// model (see WriteFitFiles; a surface alone is surface.vtp), scene.json if there are structures,
/// markups.mrk.json and markups.csv if there are landmarks or measurements. `program` is the
/// generator named in coefficient files. Call while no job is running. Throws InputError.
PALPATESTUDY_EXPORT void WriteStudyFiles(const StudyState& state, const StudyPipeline& pipeline,
                                         const std::filesystem::path& folder,
                                         const std::string& program);
} // namespace palpate
