#pragma once

#include "Progress.h"

namespace palpate::cli
{
class Console;

/// Shows how far a command is on the console, which must outlive it, and cancels where the user
/// interrupts.
ProgressFunction ProgressOn(Console& console);
} // namespace palpate::cli
