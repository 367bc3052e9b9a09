#pragma once

#include "PalpateStudyModule.h"
#include "Progress.h"
#include "TaskSettings.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace palpate
{
/// Writes a task that can be run at once, with its scenes of prostate-like phantoms, into an
/// existing folder: task.json, and a folder for each target. `seed`: of the phantoms and of the
/// order of targets. Throws InputError and Cancelled.
PALPATESTUDY_EXPORT void WriteReadyTask(TaskKind kind, std::uint64_t seed,
                                        const std::filesystem::path& folder,
                                        const ProgressFunction& progress);

/// "Find and size a nodule", and so on.
PALPATESTUDY_EXPORT std::string ReadyTaskTitle(TaskKind kind);
} // namespace palpate
