#pragma once

#include "CaseNames.h"
#include "CaseTally.h"
#include "Command.h"
#include "FitOptions.h"
#include "FitResult.h"
#include "FitSettings.h"
#include "ImageOptions.h"
#include "Segmentation.h"
#include "StructureChoice.h"

#include <filesystem>
#include <vector>

class vtkSegmentationSurface;

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
  /// One structure to be written.
  struct Case
  {
    std::filesystem::path Input;
    Segment Structure;
    vtkSmartPointer<vtkImageData> Layer;
    std::filesystem::path Output;
    bool IsOnly;       ///< of this run
    double From, To;   ///< its part of the whole run
    std::string Title; ///< for its progress
  };

  /// Reads a file and chooses its structures; throws InputError.
  Segmentation Read(const std::filesystem::path& input, StructureChoice& choice) const;
  void MeshFile(std::size_t file, Console& console);
  void MeshCase(const Case& one, Console& console);
  /// Throws InputError for errors of the structure.
  vtkSmartPointer<vtkSegmentationSurface> SurfaceOf(const Case& one, Console& console) const;
  void RecordWritten(const Case& one, vtkSegmentationSurface* surface, Console& console);
  void RecordLost(const std::filesystem::path& input, const Segment& structure,
                  FitResult::Outcome state, const std::string& message, Console& console);
  bool OutputIsFile() const;

  std::vector<std::string> Inputs;
  ImageOptions Images;
  FitOptions Options;
  FitSettings Settings;
  std::filesystem::path Output;
  bool Json = false;

  CaseNames Names;
  CaseTally Tally;
};
} // namespace palpate::cli
