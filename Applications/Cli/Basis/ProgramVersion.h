#pragma once

#include <string>

namespace palpate::cli
{
/// Name and version of the program, for --version and for the files it writes.
std::string ProgramVersion();
/// "1.2.3".
std::string VersionNumber();
} // namespace palpate::cli
