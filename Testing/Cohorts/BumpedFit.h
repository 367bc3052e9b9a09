#pragma once

#include "RadialModel.h"
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
};

constexpr int TestedFrequency = 8;  ///< of the icosahedron whose points are tested: 642
constexpr double BumpExtent = 20.0; ///< mm

const std::vector<BumpPlace>& BumpPlaces();

/// The structure of a label image with a bump around a centre (world, mm), on a grid of `shift` of
/// a slice further (BumpedMask.h): 1 inside. Throws std::runtime_error.
vtkSmartPointer<vtkImageData> BumpedImage(vtkImageData* image, int label,
                                          const Vector3& centerWorld, const SurfaceBump& bump,
                                          double shift);

/// The radial model of a degree that `palpate fit` makes of an image's label 1. Throws
/// std::runtime_error.
RadialModel RadialFitOf(vtkImageData* image, int degree);
} // namespace palpate::test
