#pragma once

namespace CLI
{
class App;
}

namespace palpate::cli
{
/// Checks the declared outputs of a parsed command (FileType) before any work. Throws InputError if
/// one of them is the file of a declared input, also through links, or if a file in an output
/// folder is not an earlier result (RequireEarlierFiles). Other files that the user names are
/// replaced.
void CheckOutputs(const CLI::App& command);
} // namespace palpate::cli
