#pragma once

#include <string>

namespace CLI
{
class App;
}

namespace palpate::cli
{
/// The manual page (roff, section 1) of a program and all of its commands.
std::string ManualPage(const CLI::App& root, const std::string& version);
} // namespace palpate::cli
