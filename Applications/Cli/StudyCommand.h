#pragma once

#include "Command.h"
#include "Study.h"

#include <filesystem>
#include <string>

namespace palpate::cli
{
/// `palpate study SESSION`: makes everything that a session file of the application wants, says how
/// each step stands, and writes what was made.
class StudyCommand : public Command
{
public:
  std::string Name() const override { return "study"; }
  std::string Summary() const override
  {
    return "Make everything that a session file (.palpate.json) wants";
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
