#pragma once

#include "Command.h"
#include "ImageOptions.h"
#include "SofteningSettings.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::cli
{
/// `palpate soften MODEL --output FILE`: a model that yields, from the stiffness of its tissue.
class SoftenCommand : public Command
{
public:
  std::string Name() const override { return "soften"; }
  std::string Summary() const override { return "Make a model yield: tissue, lesions, support"; }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  void DeclareSupport(CLI::App& app);
  void DeclareNumbers(CLI::App& app);
  SofteningSettings Read(Console& console) const;
  void CheckOutputs() const;
  void ReadLesions(SofteningSettings& settings, Console& console) const;
  void ReadNeighbours(SofteningSettings& settings, Console& console) const;

  std::filesystem::path Model;
  std::filesystem::path Output;
  std::filesystem::path Report;
  double ToolRadius = 8.0; // mm
  bool Json = false;
  std::string Tissue = "20kPa";
  std::filesystem::path Elastography;
  std::vector<std::filesystem::path> Lesions;
  std::vector<std::string> LesionLabels;
  std::vector<std::string> LesionModuli;
  std::vector<std::string> FreeSides;
  std::vector<std::filesystem::path> Neighbours;
  std::vector<std::string> NeighbourLabels;
  std::vector<double> NeighbourSupports; // kPa/mm
  ImageOptions Images;
  SofteningSettings Settings;
};
} // namespace palpate::cli
