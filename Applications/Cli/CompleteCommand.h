#pragma once

#include "Command.h"
#include "CompletionFiles.h"
#include "ImageOptions.h"

#include <filesystem>
#include <string>

namespace palpate::cli
{
/// `palpate complete POINTS`: an organ's surface from a few touched points.
class CompleteCommand : public Command
{
public:
  std::string Name() const override { return "complete"; }
  std::string Summary() const override
  {
    return "Complete an organ's surface from a few touched points";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  OrganCompletion Complete(std::size_t& count) const;

  CompletionInputs Inputs;
  std::string Center;
  double ToolRadius = 0.0; // mm
  std::string KnownLabel;
  std::filesystem::path Grid;
  ImageOptions Images;
  std::filesystem::path Output;
  bool Json = false;
};
} // namespace palpate::cli
