#pragma once

#include "Command.h"
#include "FitOptions.h"
#include "FitResult.h"
#include "ReportIndex.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace palpate::cli
{
/// `palpate fit MASK...`: a model, its quality and a report for every structure asked for. A case
/// that fails doesn't stop the others.
class FitCommand : public Command
{
public:
  std::string Name() const override { return "fit"; }
  std::string Summary() const override
  {
    return "Turn structures of segmentations into spherical-harmonic models";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  struct Case
  {
    std::size_t File;
    Segment Structure;
  };
  struct Tally
  {
    int Cases = 0;
    int BadInputs = 0;
    int OtherFailures = 0;
    std::vector<std::string> Sentences; ///< what went wrong, for the end
  };

  std::vector<Segment> Choose(const Segmentation& segmentation) const;
  void FitFile(std::size_t file, const Volume* volume, Console& console, Tally& tally);
  FitResult FitCase(const Segmentation& segmentation, const Segment& structure, double readSeconds,
                    double from, double to, Console& console) const;
  void Finish(FitResult& result, const Volume* volume, bool single, std::size_t fileNotes,
              Console& console, Tally& tally);
  int Conclude(const Tally& tally, Console& console) const;

  std::vector<std::string> Inputs;
  FitOptions Options;
  std::string VolumePath;
  std::string Series;
  std::string OutputFolder;
  bool Json = false;

  FitSettings Settings;
  ReportIndex Index;
};
} // namespace palpate::cli
