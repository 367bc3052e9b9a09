#include "BumpedFit.h"

#include "BumpedMask.h"
#include "FitStructure.h"
#include "IcosahedronDirections.h"
#include "ImageIndexToWorld.h"
#include "LabelMask.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace palpate::test
{
namespace
{
constexpr double Rim = 4.0; // mm, more than the highest bump

Vector3 NearestTested(const Vector3& axis)
{
  const IcosahedronDirections sphere(TestedFrequency);
  const std::vector<Vector3>& all = sphere.Directions();
  return *std::max_element(all.begin(), all.end(),
                           [&](const Vector3& a, const Vector3& b)
                           { return a.dot(axis) < b.dot(axis); });
}

// 1 for the voxels of a mask that are in the image, moved by this vector.
vtkSmartPointer<vtkImageData> ImageOfMask(const VoxelMask& mask, vtkImageData* grid,
                                          const Vector3& move)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->CopyStructure(grid);
  const Vector3 origin = Vector3(grid->GetOrigin()) + move;
  image->SetOrigin(origin.data());
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::array<int, 3> size{};
  image->GetDimensions(size.data());
  auto* voxel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i, ++voxel)
      {
        const std::array<int, 3> at{i - mask.StartIndex[0], j - mask.StartIndex[1],
                                    k - mask.StartIndex[2]};
        const bool isInBox = std::min({at[0], at[1], at[2]}) >= 0 && at[0] < mask.Size[0] &&
                             at[1] < mask.Size[1] && at[2] < mask.Size[2];
        *voxel = isInBox ? mask.Inside[mask.Offset(at[0], at[1], at[2])] : 0;
      }
    }
  }
  return image;
}
} // namespace

const std::vector<BumpPlace>& BumpPlaces()
{
  static const std::vector<BumpPlace> places{{"posterior", NearestTested(Vector3::UnitY())},
                                             {"left", NearestTested(Vector3::UnitX())},
                                             {"anterior", NearestTested(-Vector3::UnitY())},
                                             {"superior", NearestTested(Vector3::UnitZ())}};
  return places;
}

vtkSmartPointer<vtkImageData> BumpedImage(vtkImageData* image, int label,
                                          const Vector3& centerWorld, const SurfaceBump& bump,
                                          double shift)
{
  const double smallest = *std::min_element(image->GetSpacing(), image->GetSpacing() + 3);
  const LabelMask copied = CopyLabelMask(image, label, static_cast<int>(std::ceil(Rim / smallest)));
  if (copied.Mask.Inside.empty())
  {
    throw std::runtime_error("no voxel has the label " + std::to_string(label));
  }
  const IndexToWorld toWorld = IndexToWorldOf(image);
  return ImageOfMask(WithBump(copied.Mask, toWorld, centerWorld, bump, shift), image,
                     shift * toWorld.Axes.col(2));
}

RadialModel RadialFitOf(vtkImageData* image, int degree)
{
  Segment segment;
  segment.Label = 1;
  segment.Value = 1;
  Segmentation segmentation;
  segmentation.Layers.emplace_back(image);
  segmentation.Segments.push_back(segment);
  FitSettings settings;
  settings.Degree = degree;
  const FitResult result = FitStructure(segmentation, segment, settings);
  if (result.State != FitResult::Outcome::Fitted || result.Radial() == nullptr)
  {
    throw std::runtime_error("no radial model: " + result.Message);
  }
  return *result.Radial();
}
} // namespace palpate::test
