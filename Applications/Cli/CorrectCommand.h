#pragma once

#include "Command.h"
#include "CorrectionFiles.h"
#include "ImageOptions.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::cli
{
/// `palpate correct FILE`: a mask or a model corrected by pulls and edits, in the order given.
class CorrectCommand : public Command
{
public:
  std::string Name() const override { return "correct"; }
  std::string Summary() const override
  {
    return "Correct a mask or a model by pulls at its surface";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  std::vector<CorrectionStep> Steps() const;
  CorrectedOrgan Correct(Console& console);

  const CLI::App* Declared = nullptr; ///< knows the order of the options
  CorrectionInputs Inputs;
  std::string Label;
  std::string Neighbors = "stop";
  std::vector<std::string> Pulls;
  std::vector<std::string> Smooths;
  std::vector<std::string> Cuts;
  std::vector<std::string> Paints;
  std::vector<std::string> Erasures;
  std::vector<std::string> Lists;
  ImageOptions Images;
  std::filesystem::path Output;
  bool Json = false;
};
} // namespace palpate::cli
