#pragma once

#include "Progress.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::cli
{
class Console;

/// Shows a command's progress on the console, which must outlive it, and cancels if the user
/// interrupts.
ProgressFunction ProgressOn(Console& console);

/// "case 3 of 28: title", or the title alone for one case. `number` counts from 1.
std::string CountedCase(std::size_t number, std::size_t count, const std::string& title);

/// "file 2 of 20: a.nii.gz, title", or the title alone for one file.
std::string OfFile(std::size_t number, const std::vector<std::string>& files,
                   const std::string& title);
} // namespace palpate::cli
