#pragma once

#include "ImageWriter.h"
#include "ModelFile.h"
#include "SphericalHarmonicBasis.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace palpate::test
{
/// A sphere of label 1 (radius 9 mm around the origin) and a small one of label 2, on an
/// anisotropic grid.
inline void WriteTwoSpheres(const std::filesystem::path& path)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(41, 41, 15);
  image->SetSpacing(1.0, 1.0, 2.5);
  image->SetOrigin(-20.0, -20.0, -17.5);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double point[3];
    image->GetPoint(i, point);
    const double big = std::hypot(point[0], point[1], point[2]);
    const double small = std::hypot(point[0] - 15.0, point[1] - 15.0, point[2]);
    voxel[i] = big < 9.0 ? 1 : small < 4.0 ? 2 : 0;
  }
  WriteImage(path, image);
}

/// A sphere of radius 8 mm on the patient's right and one of 7 mm on the left, both of label 1.
inline void WriteBothSides(const std::filesystem::path& path)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(61, 25, 25);
  image->SetSpacing(1.0, 1.0, 1.0);
  image->SetOrigin(-30.0, -12.0, -12.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double point[3];
    image->GetPoint(i, point);
    const double right = std::hypot(point[0] + 18.0, point[1], point[2]);
    const double left = std::hypot(point[0] - 18.0, point[1], point[2]);
    voxel[i] = right < 8.0 || left < 7.0 ? 1 : 0;
  }
  WriteImage(path, image);
}

/// An ellipsoid of label 1 around the origin, semi-axes in mm.
inline void WriteEllipsoid(const std::filesystem::path& path, double x, double y, double z)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(41, 41, 27);
  image->SetSpacing(1.0, 1.0, 1.5);
  image->SetOrigin(-20.0, -20.0, -19.5);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double point[3];
    image->GetPoint(i, point);
    voxel[i] = std::hypot(point[0] / x, point[1] / y, point[2] / z) < 1.0 ? 1 : 0;
  }
  WriteImage(path, image);
}

/// A map of probabilities that falls from 1 at the origin to 0 at 20 mm; 0.5 at 10 mm; NaN in a
/// corner.
inline void WriteGradedSphere(const std::filesystem::path& path)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(41, 41, 41);
  image->SetOrigin(-20.0, -20.0, -20.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* voxel = static_cast<float*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double point[3];
    image->GetPoint(i, point);
    const double distance = std::hypot(point[0], point[1], point[2]);
    voxel[i] = static_cast<float>(std::max(0.0, 1.0 - distance / 20.0));
  }
  voxel[0] = std::numeric_limits<float>::quiet_NaN();
  WriteImage(path, image);
}

/// A ring of 18 mm, 12 mm thick: label 1.
inline void WriteTorus(const std::filesystem::path& path)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(33, 33, 11);
  image->SetSpacing(1.6, 1.6, 1.6);
  image->SetOrigin(-25.6, -25.6, -8.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double point[3];
    image->GetPoint(i, point);
    voxel[i] = std::hypot(std::hypot(point[0], point[1]) - 18.0, point[2]) < 6.0 ? 1 : 0;
  }
  WriteImage(path, image);
}

/// The sphere of 10 mm around (1, 2, 3) mm, as a model of degree 1 with a small tilt.
inline RadialModel NearlyASphere()
{
  const double root = std::sqrt(4.0 * 3.14159265358979323846);
  return {1, {10.0 * root, 0.0, 0.25, 0.0}, Vector3(1.0, 2.0, 3.0)};
}

inline void WriteNearlyASphere(const std::filesystem::path& path)
{
  WriteModel(path, {NearlyASphere(), {}});
}
} // namespace palpate::test
