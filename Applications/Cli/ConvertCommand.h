#pragma once

#include "CaseTally.h"
#include "Command.h"
#include "ImageOptions.h"
#include "MoveOptions.h"
#include "Segmentation.h"

#include <filesystem>
#include <string>
#include <vector>

class vtkPolyData;

namespace palpate::cli
{
/// `palpate convert IN OUT`: models, surfaces and images from one format to another, by their
/// endings, and a model drawn as a surface.
class ConvertCommand : public Command
{
public:
  std::string Name() const override { return "convert"; }
  std::string Summary() const override
  {
    return "Convert models, surfaces and images; draw a model as a surface";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  void ConvertModel(Console& console) const;
  void ConvertTouch(Console& console) const;
  void ConvertImage(Console& console);
  void ConvertSegmentation(Console& console);
  /// Throws InputError for --source and --contours where they mean nothing, or are missing.
  void CheckDicomOptions() const;
  void WriteSurfaceTo(vtkPolyData* surface) const;
  /// Reads the input's segmentation, or the masks of its folder as one.
  Segmentation ReadLabels(Console& console);

  std::filesystem::path Input;
  std::filesystem::path Output;
  CaseTally Tally; ///< of the masks of a folder
  std::string Label;
  std::filesystem::path Source; ///< series of DICOM output
  bool AsContours = false;
  ImageOptions Images;
  MoveOptions Move;
  int Frequency = 20;
};
} // namespace palpate::cli
