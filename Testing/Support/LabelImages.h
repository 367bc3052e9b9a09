#pragma once

#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cmath>
#include <random>

namespace palpate::test
{
/// A grid for label images; the direction's columns are the axes in world coordinates.
struct LabelGrid
{
  std::array<int, 3> Size{{32, 32, 32}};
  std::array<double, 3> Spacing{{1.0, 1.0, 1.0}};
  std::array<double, 3> Origin{{0.0, 0.0, 0.0}};
  std::array<double, 9> Direction{{1, 0, 0, 0, 1, 0, 0, 0, 1}};

  /// Places the grid's centre at the world's origin.
  void CenterOnOrigin()
  {
    for (std::size_t row = 0; row < 3; ++row)
    {
      this->Origin[row] = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        this->Origin[row] -=
            this->Direction[3 * row + axis] * this->Spacing[axis] * (this->Size[axis] - 1) / 2.0;
      }
    }
  }
};

/// A random rotation, row by row.
inline std::array<double, 9> RandomRotation(std::mt19937_64& random)
{
  std::normal_distribution<double> normal;
  double quaternion[4];
  for (double& part : quaternion)
  {
    part = normal(random);
  }
  double matrix[3][3];
  vtkMath::QuaternionToMatrix3x3(quaternion, matrix);
  std::array<double, 9> rows{};
  for (std::size_t i = 0; i < 9; ++i)
  {
    rows[i] = matrix[i / 3][i % 3];
  }
  return rows;
}

/// An image of type T in which the voxels whose centre (world) satisfies `inside(x, y, z)` have
/// `label`.
template <typename T = unsigned char, typename Inside>
vtkSmartPointer<vtkImageData> MakeLabelImage(const LabelGrid& grid, const Inside& inside,
                                             int label = 1)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(grid.Size.data());
  image->SetSpacing(grid.Spacing.data());
  image->SetOrigin(grid.Origin.data());
  image->SetDirectionMatrix(grid.Direction.data());
  image->AllocateScalars(vtkTypeTraits<T>::VTKTypeID(), 1);
  for (int k = 0; k < grid.Size[2]; ++k)
  {
    for (int j = 0; j < grid.Size[1]; ++j)
    {
      for (int i = 0; i < grid.Size[0]; ++i)
      {
        double world[3];
        image->TransformIndexToPhysicalPoint(i, j, k, world);
        *static_cast<T*>(image->GetScalarPointer(i, j, k)) =
            inside(world[0], world[1], world[2]) ? static_cast<T>(label) : T{};
      }
    }
  }
  return image;
}
} // namespace palpate::test
