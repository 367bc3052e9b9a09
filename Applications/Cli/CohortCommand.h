#pragma once

#include "Command.h"

#include <string>
#include <vector>

namespace palpate::cli
{
/// `palpate cohort OUT...`: what the cases that `fit` wrote have in common and how they differ. A
/// command of its own and no end of `fit`: other axes or another structure need no fit again, and
/// cases that were fitted on several machines are one cohort here.
class CohortCommand : public Command
{
public:
  std::string Name() const override { return "cohort"; }
  std::string Summary() const override
  {
    return "Mean shape, principal modes and tables of the cases that fit wrote";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  std::vector<std::string> Folders;
  std::string OutputFolder;
  std::string Label;
  std::string Align = "patient";
};
} // namespace palpate::cli
