#pragma once

#include "CasePairs.h"
#include "Command.h"
#include "FileComparison.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::cli
{
/// `palpate compare FIRST REFERENCE`: how well two masks, surfaces or models of one organ agree; of
/// two folders, or a list, a table.
class CompareCommand : public Command
{
public:
  std::string Name() const override { return "compare"; }
  std::string Summary() const override
  {
    return "Compare masks, surfaces and models: Dice, distances, surface Dice";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  /// Those with the label that was asked for; throws InputError if there are none.
  CasePairs Chosen(CasePairs cases) const;
  int RunFiles(Console& console) const;
  int RunTimes(Console& console) const;
  int RunCases(const CasePairs& all, Console& console) const;

  std::filesystem::path First;
  std::filesystem::path Reference;
  std::filesystem::path List;
  std::vector<double> Times;
  std::vector<std::string> LandmarkWords;
  CompareSettings Settings;
  unsigned Jobs = 0; ///< 0: one a processor
};
} // namespace palpate::cli
