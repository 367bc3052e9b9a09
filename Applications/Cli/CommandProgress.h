#pragma once

#include "Progress.h"

#include <cstddef>
#include <string>

namespace palpate::cli
{
class Console;

/// Shows how far a command is on the console, which must outlive it, and cancels where the user
/// interrupts.
ProgressFunction ProgressOn(Console& console);

/// "case 3 of 28: title", or the title alone where there is one case. `number` counts from 1.
std::string CountedCase(std::size_t number, std::size_t count, const std::string& title);
} // namespace palpate::cli
