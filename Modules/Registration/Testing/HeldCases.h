#pragma once

#include "HeldFit.h"
#include "MeshShapes.h"
#include "RandomMaps.h"

#include <gtest/gtest.h>

namespace palpate::test
{
/// An ellipsoid around the origin (mm).
inline IndexedMesh Ellipsoid(int frequency, const Vector3& semiAxes)
{
  IndexedMesh mesh = Sphere(frequency);
  for (Vector3& point : mesh.Points)
  {
    point = point.cwiseProduct(semiAxes);
  }
  return mesh;
}

inline HeldFit MakeHeldFit(const IndexedMesh& moving, const IndexedMesh& fixed,
                           const HeldFitSettings& settings = {})
{
  HeldFit fit;
  const Status status = HeldFit::Make(moving, fixed, settings, fit);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return fit;
}

/// A gland's size and shape on itself.
inline HeldFit EllipsoidFit(int frequency, const HeldFitSettings& settings = {})
{
  const IndexedMesh mesh = Ellipsoid(frequency, {25.0, 20.0, 17.0});
  return MakeHeldFit(mesh, mesh, settings);
}

} // namespace palpate::test
