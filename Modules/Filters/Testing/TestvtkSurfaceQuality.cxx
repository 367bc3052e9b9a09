#include "vtkSurfaceQuality.h"

#include "Bodies.h"
#include "ErrorLog.h"
#include "LabelImages.h"

#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::vtk_surface_quality_test
{
namespace
{
using palpate::test::MakeSphere;

vtkSmartPointer<vtkSurfaceQuality> Compare(vtkPolyData* tested, vtkPolyData* reference)
{
  auto quality = vtkSmartPointer<vtkSurfaceQuality>::New();
  quality->SetInputData(0, tested);
  quality->SetReferenceData(reference);
  return quality;
}

// Depth of facets of frequency 40 inside a sphere of 20 mm: h^2 / (6 r), h = 0.6 mm.
constexpr double FacetError = 0.004;

TEST(SurfaceQuality, EqualSurfacesHaveZeroDistance)
{
  const auto sphere = MakeSphere(20.0, {1, 2, 3});
  auto quality = Compare(sphere, sphere);
  quality->Update();
  EXPECT_NEAR(quality->GetMaximumDistance(), 0.0, 1e-9);
  EXPECT_NEAR(quality->GetVolumeDifference(), 0.0, 1e-9);
  EXPECT_NEAR(quality->GetAreaDifference(), 0.0, 1e-9);
}

TEST(SurfaceQuality, ConcentricSpheresDifferByTheirRadii)
{
  auto quality = Compare(MakeSphere(21.0, {0, 0, 0}, 40), MakeSphere(20.0, {0, 0, 0}, 40));
  quality->Update();
  EXPECT_NEAR(quality->GetMeanDistance(), 1.0, FacetError);
  EXPECT_NEAR(quality->GetRmsDistance(), 1.0, FacetError);
  EXPECT_NEAR(quality->GetPercentile95Distance(), 1.0, FacetError);
  EXPECT_NEAR(quality->GetMaximumDistance(), 1.0, FacetError);
  EXPECT_NEAR(quality->GetVolumeDifference(), 4.0 / 3.0 * M_PI * (9261.0 - 8000.0), 5.0);
  EXPECT_NEAR(quality->GetAreaDifference(), 4.0 * M_PI * (441.0 - 400.0), 0.5);
}

TEST(SurfaceQuality, ShiftedSpheresFollowCosine)
{
  // A shift d moves a sphere's surface by about d cos along the normal: mean d / 2, mean square
  // d^2 / 3, maximum d; 95 % of a sphere's area lies within |cos| <= 0.95. Corrections are of
  // second order, d^2 / r = 0.0125 mm.
  auto quality = Compare(MakeSphere(20.0, {0.5, 0, 0}, 40), MakeSphere(20.0, {0, 0, 0}, 40));
  quality->Update();
  EXPECT_NEAR(quality->GetMeanDistance(), 0.25, 0.01);
  EXPECT_NEAR(quality->GetRmsDistance(), 0.5 / std::sqrt(3.0), 0.01);
  EXPECT_NEAR(quality->GetPercentile95Distance(), 0.475, 0.015);
  EXPECT_NEAR(quality->GetMaximumDistance(), 0.5, 0.015);
}

TEST(SurfaceQuality, IsSymmetric)
{
  const auto sphere = MakeSphere(20.0, {0, 0, 0}, 10);
  const auto egg = palpate::test::MakeBody(25, [](const Vector3& u)
                                           { return Vector3(22 * u.x(), 19 * u.y(), 25 * u.z()); });
  auto there = Compare(sphere, egg);
  auto back = Compare(egg, sphere);
  there->Update();
  back->Update();
  EXPECT_DOUBLE_EQ(there->GetMeanDistance(), back->GetMeanDistance());
  EXPECT_DOUBLE_EQ(there->GetPercentile95Distance(), back->GetPercentile95Distance());
  EXPECT_DOUBLE_EQ(there->GetMaximumDistance(), back->GetMaximumDistance());
  EXPECT_NEAR(there->GetVolumeDifference(), -back->GetVolumeDifference(), 1e-9);
}

TEST(SurfaceQuality, FindsThornOnReference)
{
  // One direction alone would miss it: the tested sphere is close to the other body everywhere.
  const auto thorned = palpate::test::MakeBody(
      20, [](const Vector3& u) -> Vector3 { return (u.z() > 0.9995 ? 30.0 : 20.0) * u; });
  auto quality = Compare(MakeSphere(20.0, {0, 0, 0}, 20), thorned);
  quality->Update();
  EXPECT_NEAR(quality->GetMaximumDistance(), 10.0, 0.1);
}

TEST(SurfaceQuality, DiceOfShiftedSpheresIsThatOfLens)
{
  std::mt19937_64 random(21);
  palpate::test::LabelGrid grid;
  grid.Size = {110, 110, 110};
  grid.Spacing = {0.5, 0.5, 0.5};
  grid.Direction = palpate::test::RandomRotation(random);
  grid.CenterOnOrigin();
  const auto mask = palpate::test::MakeLabelImage<int>(
      grid, [](double x, double y, double z) { return x * x + y * y + z * z < 400.0; }, 4);
  const double shift = 3.0;
  const auto sphere = MakeSphere(20.0, {shift, 0, 0}, 40);
  auto quality = Compare(sphere, sphere);
  quality->SetMaskData(mask);
  quality->SetLabel(4);
  quality->Update();
  // Two spheres of radius r, d apart, share pi (4 r + d) (2 r - d)^2 / 12.
  const double lens = M_PI * (80.0 + shift) * std::pow(40.0 - shift, 2) / 12.0;
  // 270,000 voxels, of which some thousands on the boundary fall either way: about 1e-4.
  EXPECT_NEAR(quality->GetDice(), lens / (4.0 / 3.0 * M_PI * 8000.0), 1e-3);
}

TEST(SurfaceQuality, DiceCountsVoxelsWithCentreInside)
{
  palpate::test::LabelGrid grid;
  grid.Size = {30, 30, 30};
  grid.Spacing = {1.0, 1.1, 1.3};
  grid.CenterOnOrigin();
  // An irrational radius keeps every voxel centre off the surface.
  const double radius = std::sqrt(101.3);
  const auto mask = palpate::test::MakeLabelImage(
      grid, [=](double x, double y, double z) { return x * x + y * y + z * z < radius * radius; });
  const auto sphere = MakeSphere(radius, {0, 0, 0}, 150); // facets within 0.2 micrometres
  auto quality = Compare(sphere, sphere);
  quality->SetMaskData(mask);
  quality->Update();
  EXPECT_DOUBLE_EQ(quality->GetDice(), 1.0);
}

TEST(SurfaceQuality, DiceCountsBeyondTheGrid)
{
  palpate::test::LabelGrid grid;
  grid.Size = {50, 50, 25};
  grid.CenterOnOrigin();
  grid.Origin[2] = 0.5; // the upper half only
  const auto half = palpate::test::MakeLabelImage(grid, [](double x, double y, double z)
                                                  { return x * x + y * y + z * z < 400.0; });
  const auto sphere = MakeSphere(20.0, {0, 0, 0}, 40);
  auto quality = Compare(sphere, sphere);
  quality->SetMaskData(half);
  quality->Update();
  // The mask is half of the sphere: 2 * 1 / (1 + 2). Boundary voxels fall either way.
  EXPECT_NEAR(quality->GetDice(), 2.0 / 3.0, 2e-3);
}

TEST(SurfaceQuality, DiceNeedsMask)
{
  const auto sphere = MakeSphere(20.0, {0, 0, 0}, 5);
  auto quality = Compare(sphere, sphere);
  quality->Update();
  EXPECT_DOUBLE_EQ(quality->GetDice(), -1.0);
  EXPECT_NE(quality->GetOutput()->GetPointData()->GetArray("Distance"), nullptr);
}

TEST(SurfaceQuality, RaisesErrorWithoutTriangles)
{
  vtkNew<vtkPolyData> nothing;
  auto quality = Compare(nothing, MakeSphere(1.0, {0, 0, 0}));
  const palpate::test::ErrorLog errors(quality);
  quality->Update();
  EXPECT_TRUE(errors.Contains("need triangles"));
}
} // namespace
} // namespace palpate::vtk_surface_quality_test
