#pragma once

#include "SphericalHarmonicModel.h"
#include "SurfaceBump.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace palpate::test
{
/// Where the surface of a gland bulges, and what the files of such models are named after.
struct BumpPlace
{
  std::string Name;
  Vector3 Direction; ///< patient LPS, one of the directions of the tests
  /// Along axial slices, half way between which WithBump takes the surface to lie: masks carry only
  /// what exceeds half a slice.
  bool IsAlongSlices = false;
};

constexpr int TestedFrequency = 8;  ///< of the icosahedron whose points are tested: 642
constexpr double BumpExtent = 20.0; ///< mm

const std::vector<BumpPlace>& BumpPlaces();

/// The structure of a label image with a bump around a centre (world, mm), on the same grid: 1
/// inside. Throws std::runtime_error.
vtkSmartPointer<vtkImageData> BumpedImage(vtkImageData* image, int label,
                                          const Vector3& centerWorld, const SurfaceBump& bump);

/// The radial model of a degree that `palpate fit` makes of an image's label 1. Throws
/// std::runtime_error.
SphericalHarmonicModel RadialFitOf(vtkImageData* image, int degree);
} // namespace palpate::test
