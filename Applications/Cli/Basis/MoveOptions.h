#pragma once

#include "OrganModel.h"
#include "OrthogonalResampling.h"
#include "Segmentation.h"

#include "vtkPolyData.h"

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>

namespace CLI
{
class App;
}

namespace palpate::cli
{
/// `--transform` and `--reference`: what is read is moved in the patient before it is written.
class MoveOptions
{
public:
  void Declare(CLI::App& app);
  bool IsGiven() const { return !this->File.empty(); }
  /// Reads the transform, and the grid if one is named; `input` is what is moved. Throws
  /// InputError.
  void Read(const std::filesystem::path& input);

  ///@{ What is given, moved; itself without a transform. Throw InputError.
  vtkSmartPointer<vtkImageData> Moved(vtkImageData* image, ResamplingKind kind) const;
  Segmentation Moved(Segmentation segmentation) const;
  vtkSmartPointer<vtkPolyData> Moved(vtkPolyData* surface) const;
  /// A radial model becomes a surface model.
  OrganModel Moved(const OrganModel& model) const;
  ///@}

private:
  std::filesystem::path Input;
  std::filesystem::path File;
  std::filesystem::path Reference;
  Eigen::Affine3d Map = Eigen::Affine3d::Identity();
  std::optional<ImageGrid> Grid;
};
} // namespace palpate::cli
