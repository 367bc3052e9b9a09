#pragma once

#include "Segmentation.h"
#include "SphericalHarmonicModel.h"
#include "Volume.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <filesystem>
#include <memory>
#include <string>
#include <variant>

namespace palpate
{
/// A structure before it is represented in any way: what it is known by. In memory, from whatever
/// file.
struct TradeSource
{
  struct Mask
  {
    std::shared_ptr<const Segmentation> Voxels;
    Segment Structure;
  };
  struct Image
  {
    std::shared_ptr<const Volume> Voxels;
    double Iso = 0.0; ///< what has at least this value
  };
  using Model = std::shared_ptr<const SphericalHarmonicModel>;
  using Surface = vtkSmartPointer<vtkPolyData>; ///< closed, mm, patient LPS

  std::string Name;
  std::filesystem::path File; ///< for messages
  std::variant<Mask, Image, Model, Surface> Is;
  double Smoothing = 1.0; ///< of a mask's field, in voxels
};
} // namespace palpate
