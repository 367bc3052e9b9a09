#pragma once

#include "ComparedBody.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

namespace palpate::test
{
inline ComparedBody BodyOfModel(const OrganModel& model)
{
  ComparedBody body;
  const Status status = ComparedBody::OfModel(model, body);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return body;
}

inline ComparedBody BodyOfMesh(IndexedMesh mesh)
{
  ComparedBody body;
  const Status status = ComparedBody::OfMesh(std::move(mesh), body);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return body;
}

inline OrganModel SphereModel(double radius, const Vector3& center = Vector3::Zero())
{
  return RadialModel(0, {radius * std::sqrt(4.0 * M_PI)}, center);
}

/// Exactly the ellipsoid with these semi-axes: degree 1, at l (l + 1) + m = 3, 1, 2 for x, y, z.
inline OrganModel EllipsoidModel(const Vector3& semiAxes)
{
  const Vector3 scaled = std::sqrt(4.0 * M_PI / 3.0) * semiAxes;
  return SurfaceModel(1, {std::vector<double>{0.0, 0.0, 0.0, scaled.x()},
                          {0.0, scaled.y(), 0.0, 0.0},
                          {0.0, 0.0, scaled.z(), 0.0}});
}

/// The voxels of a grid whose centres (mm) satisfy a condition, in a box that begins at `start`.
inline ComparedBody BodyOfVoxels(const std::array<int, 3>& size, const IndexToWorld& toWorld,
                                 const std::function<bool(const Vector3&)>& isInside,
                                 const std::array<int, 3>& start = {0, 0, 0})
{
  VoxelMask mask;
  mask.StartIndex = start;
  mask.Size = size;
  const Vector3 spacing = toWorld.Axes.colwise().norm();
  mask.Spacing = {spacing[0], spacing[1], spacing[2]};
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const Vector3 index(i + start[0], j + start[1], k + start[2]);
        mask.Inside.push_back(isInside(toWorld(index)) ? 1 : 0);
      }
    }
  }
  ComparedBody body;
  const Status status = ComparedBody::OfMask(std::move(mask), toWorld, body);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return body;
}
} // namespace palpate::test
