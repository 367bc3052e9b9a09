#include "SoftwareRenderer.h"

#include "ModelMesh.h"

#include "vtkAppendPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace palpate::software_renderer_test
{
namespace
{
// Opaque area in pixels; partly covered ones count partly.
double CoveredPixels(const RasterImage& raster)
{
  double covered = 0.0;
  for (std::size_t p = 3; p < raster.Rgba.size(); p += 4)
  {
    covered += raster.Rgba[p] / 255.0;
  }
  return covered;
}

// Two small spheres, the first red and the second blue.
struct TwoSpheres
{
  TwoSpheres(const Vector3& red, const Vector3& blue)
  {
    vtkNew<vtkAppendPolyData> both;
    both->AddInputData(palpate::test::MakeModelMesh(palpate::test::SphereModel(3.0, red), 6));
    both->AddInputData(palpate::test::MakeModelMesh(palpate::test::SphereModel(3.0, blue), 6));
    both->Update();
    this->Mesh = both->GetOutput();
    const auto half = static_cast<std::size_t>(this->Mesh->GetNumberOfPoints()) / 2;
    this->Colors.assign(half, {{255, 0, 0}});
    this->Colors.insert(this->Colors.end(), half, {{0, 0, 255}});
  }

  RasterImage Draw(ViewSide side) const
  {
    SoftwareRenderer renderer(this->Mesh);
    renderer.SetPointColors(this->Colors);
    return renderer.Render(side, 101);
  }

  vtkSmartPointer<vtkPolyData> Mesh;
  std::vector<SoftwareRenderer::Color> Colors;
};

// Mean position of pixels that are more red than blue, in pixels from the image centre (right, up).
std::array<double, 2> RedPlace(const RasterImage& raster)
{
  double right = 0.0;
  double up = 0.0;
  double count = 0.0;
  for (int row = 0; row < raster.Height; ++row)
  {
    for (int column = 0; column < raster.Width; ++column)
    {
      const std::uint8_t* pixel = raster.Pixel(column, row);
      if (pixel[3] > 0 && pixel[0] > pixel[2])
      {
        right += column - 0.5 * (raster.Width - 1);
        up += 0.5 * (raster.Height - 1) - row;
        count += 1.0;
      }
    }
  }
  return {right / count, up / count};
}

int CountColor(const RasterImage& raster, int channel)
{
  int count = 0;
  for (std::size_t p = 0; p < raster.Rgba.size(); p += 4)
  {
    const std::uint8_t* pixel = raster.Rgba.data() + p;
    count += pixel[3] > 0 && pixel[channel] > pixel[2 - channel] ? 1 : 0;
  }
  return count;
}

TEST(SoftwareRenderer, SphereSilhouetteHasAreaOfDisc)
{
  constexpr int Size = 200;
  const auto mesh =
      palpate::test::MakeModelMesh(palpate::test::SphereModel(17.0, Vector3(5, -70, 200)), 24);
  const SoftwareRenderer renderer(mesh);
  const double millimetersPerPixel = 2.0 * renderer.HalfWidthMillimeters() / Size;
  for (const ViewSide side : palpate::AllViewSides)
  {
    const double area =
        CoveredPixels(renderer.Render(side, Size)) * millimetersPerPixel * millimetersPerPixel;
    // The polyhedron's chords are within 0.1 % inside; counting half pixels along a rim of 590
    // pixels is accurate to about 0.1 %, and the rasteriser widens triangles slightly.
    EXPECT_NEAR(area / (M_PI * 17.0 * 17.0), 1.0, 3e-3) << palpate::NameOf(side);
  }
}

TEST(SoftwareRenderer, CoversEveryPixelOfSphere)
{
  constexpr int Size = 320;
  const auto mesh =
      palpate::test::MakeModelMesh(palpate::test::SphereModel(10.0, Vector3::Zero()), 63);
  const SoftwareRenderer renderer(mesh);
  const RasterImage raster = renderer.Render(ViewSide::Anterior, Size);
  const double millimetersPerPixel = 2.0 * renderer.HalfWidthMillimeters() / Size;
  for (int row = 0; row < Size; ++row)
  {
    for (int column = 0; column < Size; ++column)
    {
      const double fromMiddle =
          millimetersPerPixel * std::hypot(column + 0.5 - Size / 2.0, row + 0.5 - Size / 2.0);
      if (fromMiddle < 9.8) // more than a pixel inside the rim
      {
        ASSERT_EQ(raster.Pixel(column, row)[3], 255) << column << ", " << row;
      }
    }
  }
}

TEST(SoftwareRenderer, NearerSphereHidesOther)
{
  // Seen along each axis from both ends; the spheres are on that axis.
  const std::array<std::pair<ViewSide, ViewSide>, 3> ends{
      {{ViewSide::Left, ViewSide::Right},
       {ViewSide::Posterior, ViewSide::Anterior},
       {ViewSide::Superior, ViewSide::Inferior}}};
  for (int axis = 0; axis < 3; ++axis)
  {
    const TwoSpheres spheres(10.0 * Vector3::Unit(axis), -10.0 * Vector3::Unit(axis));
    const RasterImage fromPositive = spheres.Draw(ends[axis].first);
    const RasterImage fromNegative = spheres.Draw(ends[axis].second);
    EXPECT_GT(CountColor(fromPositive, 0), 100);
    EXPECT_EQ(CountColor(fromPositive, 2), 0);
    EXPECT_GT(CountColor(fromNegative, 2), 100);
    EXPECT_EQ(CountColor(fromNegative, 0), 0);
  }
}

TEST(SoftwareRenderer, OffsetsAppearAlongViewAxes)
{
  std::mt19937_64 random(20240607);
  std::uniform_real_distribution<double> spread(-20.0, 20.0);
  for (int trial = 0; trial < 20; ++trial)
  {
    const Vector3 red(spread(random), spread(random), spread(random));
    for (const ViewSide side : palpate::AllViewSides)
    {
      const palpate::ViewFrame frame = FrameOf(side);
      const double right = red.dot(frame.RightWorld);
      const double up = red.dot(frame.UpWorld);
      if (std::min(std::abs(right), std::abs(up)) < 7.0)
      {
        continue; // the spheres would overlap in the image
      }
      const std::array<double, 2> place = RedPlace(TwoSpheres(red, Vector3(-red)).Draw(side));
      EXPECT_GT(place[0] * right, 0.0) << palpate::NameOf(side) << " " << red.transpose();
      EXPECT_GT(place[1] * up, 0.0) << palpate::NameOf(side) << " " << red.transpose();
    }
  }
}

TEST(SoftwareRenderer, DrawsInwardAndOutwardFacingTriangles)
{
  const auto mesh =
      palpate::test::MakeModelMesh(palpate::test::SphereModel(10.0, Vector3::Zero()), 8);
  const RasterImage outward = SoftwareRenderer(mesh).Render(ViewSide::Left, 60);
  vtkNew<vtkCellArray> turned;
  const palpate::IcosahedronDirections directions(8);
  for (const auto& triangle : directions.Triangles())
  {
    turned->InsertNextCell({triangle[0], triangle[2], triangle[1]});
  }
  mesh->SetPolys(turned);
  EXPECT_EQ(SoftwareRenderer(mesh).Render(ViewSide::Left, 60).Rgba, outward.Rgba);
}

TEST(SoftwareRenderer, EmptyMeshIsTransparent)
{
  vtkNew<vtkPolyData> nothing;
  EXPECT_EQ(CoveredPixels(SoftwareRenderer(nothing).Render(ViewSide::Left, 16)), 0.0);
}
} // namespace
} // namespace palpate::software_renderer_test
