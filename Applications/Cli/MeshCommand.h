#pragma once

#include "Command.h"
#include "FitOptions.h"
#include "FitSettings.h"
#include "Segmentation.h"

#include <filesystem>
#include <vector>

namespace palpate::cli
{
/// `palpate mesh MASK... --output FILE`: the closed surface of structures of segmentations.
class MeshCommand : public Command
{
public:
  std::string Name() const override { return "mesh"; }
  std::string Summary() const override { return "Turn structures of segmentations into surfaces"; }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  struct Tally
  {
    int Cases = 0;
    int BadInputs = 0;
    int Failures = 0;
  };

  /// Reads a file and chooses its structures; throws InputError.
  Segmentation Read(const std::filesystem::path& input, std::vector<Segment>& structures) const;
  void MeshFile(std::size_t file, Console& console, Tally& tally) const;
  void MeshCase(const std::filesystem::path& input, const Segmentation& segmentation,
                const Segment& structure, double from, double to, Console& console,
                Tally& tally) const;
  void MeshStructure(const std::filesystem::path& input, const Segmentation& segmentation,
                     const Segment& structure, double from, double to, Console& console) const;
  void Report(const std::filesystem::path& input, const Segment* structure,
              const std::string& sentence, Console& console) const;
  bool OutputIsFile() const;

  std::vector<std::string> Inputs;
  FitOptions Options;
  FitSettings Settings;
  std::filesystem::path Output;
  bool Json = false;
};
} // namespace palpate::cli
