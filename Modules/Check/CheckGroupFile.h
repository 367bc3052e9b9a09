#pragma once

#include "CheckGroup.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// Writes a group as JSON (format "palpate check group", version 1) under AtomicFile's rules. Cases
/// that were dropped are listed by their numbers, from 1 in the order in which they were given; no
/// case is named. Throws InputError.
void WriteCheckGroup(const CheckGroup& group, const std::filesystem::path& file);
/// Throws InputError if the file is not such a group.
CheckGroup ReadCheckGroup(const std::filesystem::path& file);
} // namespace palpate
