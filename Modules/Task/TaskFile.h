#pragma once

#include "PalpateTaskModule.h"
#include "TaskSettings.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// Reads a task: "format": "palpate-task", "version": 1, and the entries of
/// Documentation/HowTo/Task.md, with paths relative to the file; at most 16 MiB. Throws InputError
/// for entries that are unknown, out of bounds or contradict each other, targets that lack what
/// their kind needs, and questions about a person's identity.
PALPATETASK_EXPORT TaskSettings ReadTask(const std::filesystem::path& path);

/// A task as the text of a task file, paths relative to the folder.
PALPATETASK_EXPORT std::string TaskText(TaskSettings task, const std::filesystem::path& folder);

/// Differs if any entry of the task does: a run goes on with the task that it began with only.
PALPATETASK_EXPORT std::string TaskDigest(const TaskSettings& task);

/// Whether a key or a question asks who somebody is: a name, initials, an address, a birthday, a
/// number of a patient.
PALPATETASK_EXPORT bool AsksForIdentity(const std::string& text);
} // namespace palpate
