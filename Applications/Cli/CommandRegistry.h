#pragma once

#include "Command.h"

#include <memory>
#include <vector>

namespace palpate::cli
{
/// Every sub-command of `palpate`, in the order of --help.
std::vector<std::unique_ptr<Command>> MakeCommands();
} // namespace palpate::cli
