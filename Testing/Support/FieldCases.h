#pragma once

#include "FieldBuilder.h"
#include "FieldSampler.h"
#include "RandomOrientation.h"

#include <gtest/gtest.h>
#include <random>

namespace palpate::test
{
/// An oblique grid with three different spacings, off the origin.
inline FieldGrid ObliqueGrid(const std::array<int, 3>& size, std::mt19937_64& random)
{
  return {size, {-12.5, 40.25, 7.0}, {0.7, 0.5, 3.1}, RandomOrientation(random)};
}

/// The index of a node by its number, i fastest.
inline Vector3 NodeIndex(const std::array<int, 3>& size, std::size_t number)
{
  const auto n = static_cast<int>(number);
  const int row = n / size[0];
  const int slice = row / size[1];
  return {1.0 * (n % size[0]), 1.0 * (row % size[1]), 1.0 * slice};
}

/// The same size in a frame in which index and world agree.
inline FieldGrid PlainGrid(const std::array<int, 3>& size)
{
  return {size, Vector3::Zero(), Vector3::Ones(), Matrix3::Identity()};
}

/// A field of one channel and one material, value >= iso; the test fails if Build does.
template <typename T>
std::shared_ptr<const ScalarField>
MakeField(const FieldGrid& grid, const std::vector<T>& samples, double iso,
          FieldInterpolation interpolation = FieldInterpolation::Trilinear)
{
  FieldBuilder builder(grid);
  builder.AddMaterial({builder.AddChannel(SamplesOfGrid(samples.data(), grid)), iso});
  builder.SetInterpolation(interpolation);
  std::shared_ptr<const ScalarField> field;
  const Status status = builder.Build(field);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return field;
}

/// Build's error message; empty on success.
inline std::string RefusalOf(const FieldBuilder& builder)
{
  std::shared_ptr<const ScalarField> field;
  const Status status = builder.Build(field);
  EXPECT_EQ(status.IsOk(), field != nullptr);
  return status.Message();
}

/// Number of bricks through which a surface may pass.
inline std::size_t SurfaceBricks(const ScalarField& field)
{
  std::size_t count = 0;
  for (std::size_t brick = 0; brick < field.Layout().BrickCount(); ++brick)
  {
    count += field.Directory()[brick].HasSurface() ? 1 : 0;
  }
  return count;
}

/// Every material that contains the point.
inline MaterialSet MaterialsAt(const FieldSampler& sampler, const Vector3& pointIndex)
{
  MaterialSet set = 0;
  for (int material = 0; material < sampler.Field().MaterialCount(); ++material)
  {
    set |= sampler.IsInsideIndex(material, pointIndex) ? OnlyMaterial(material) : 0;
  }
  return set;
}

/// Small whole numbers with many repetitions: values equal to the iso-value, saturated regions and
/// saddles at nodes are frequent.
template <typename T = double>
std::vector<T> RandomSteps(const FieldGrid& grid, std::mt19937_64& random, int levels)
{
  std::vector<T> samples(grid.NodeCount());
  for (T& sample : samples)
  {
    sample = static_cast<T>(static_cast<int>(random() % static_cast<unsigned>(levels)));
  }
  return samples;
}
} // namespace palpate::test
