#pragma once

#include "CasePairs.h"
#include "CaseTally.h"
#include "Command.h"
#include "ImageOptions.h"
#include "PairComparison.h"

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
  /// This pair of files' part of the whole run.
  struct Part
  {
    double From = 0.0;
    double To = 1.0;
    std::string Title;
  };

  int RunFiles(Console& console);
  /// Those with the label that was asked for; throws InputError if there are none.
  CasePairs Chosen(CasePairs cases) const;
  int RunCases(const CasePairs& all, Console& console);
  /// Errors of a case become its result.
  void CompareCase(const CasePairs::Pair& one, const Part& part, Console& console);
  /// Compares the structures of two files and takes their results; throws InputError.
  void CompareFiles(const CasePairs::Pair& files, const Part& part, Console& console);
  void Take(PairComparison&& pair, bool isOnly, Console& console);
  std::filesystem::path FolderOf(const PairComparison& pair, bool isOnly) const;
  int Conclude(Console& console);

  std::filesystem::path First;
  std::filesystem::path Reference;
  std::filesystem::path List;
  std::string Label;
  std::string ReferenceLabel;
  std::vector<double> Tolerances{1.0, 2.0, 3.0};
  ImageOptions Images;
  std::filesystem::path OutputFolder;
  bool Json = false;

  bool IsTable = false; ///< of folders or a list
  std::vector<PairComparison> Results;
  std::vector<std::string> Unpaired;
};
} // namespace palpate::cli
