#pragma once

#include "Command.h"
#include "Study.h"

#include <filesystem>
#include <string>

namespace palpate::cli
{
/// `palpate study SESSION`: runs every step that a session file of the application needs, prints
/// the status of each, and writes the results.
class StudyCommand : public Command
{
public:
  std::string Name() const override { return "study"; }
  std::string Summary() const override
  {
    return "Run every step that a session file (.palpate.json) needs";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  std::filesystem::path Input;
  std::filesystem::path OutputFolder;
  bool Json = false;
};
} // namespace palpate::cli
