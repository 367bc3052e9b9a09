#pragma once

#include <string>

namespace palpate::cli
{
/// Name and version of the program, as --version prints it and as files name their maker.
std::string ProgramVersion();
} // namespace palpate::cli
