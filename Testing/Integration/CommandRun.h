#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::test
{
/// Result of a finished process.
struct CommandRun
{
  int Code = -1; ///< exit code; -1 if it did not end by itself
  std::string Output;
  std::string Errors;
};

/// Runs a program with these arguments in a folder, without a terminal and without a display.
CommandRun RunCommand(const std::string& program, const std::vector<std::string>& arguments,
                      const std::filesystem::path& folder);

/// The `palpate` of this build.
CommandRun RunPalpate(const std::vector<std::string>& arguments,
                      const std::filesystem::path& folder);
} // namespace palpate::test
