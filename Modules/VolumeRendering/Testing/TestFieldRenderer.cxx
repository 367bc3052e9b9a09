#include "FieldRenderer.h"

#include "FieldBuilder.h"
#include "ProceduralFields.h"

#include <gtest/gtest.h>

namespace palpate::field_renderer_test
{
namespace
{
constexpr int Nodes = 33;
constexpr double Spacing = 0.5; // mm: the grid runs from -8 to 8

FieldGrid Grid()
{
  return {{Nodes, Nodes, Nodes},
          Vector3::Constant(-8.0),
          Vector3::Constant(Spacing),
          Matrix3::Identity()};
}

// Distance from the grid's centre, mm.
std::vector<double> Distances()
{
  test::SphereField sphere;
  sphere.Center = Vector3::Constant((Nodes - 1) / 2.0);
  sphere.Radius = 0.0;
  std::vector<double> samples = test::SampleAtIndices({Nodes, Nodes, Nodes}, sphere);
  for (double& sample : samples)
  {
    sample *= -Spacing;
  }
  return samples;
}

// Concentric spheres: material 0 is the outermost.
std::shared_ptr<const ScalarField> Spheres(const std::vector<double>& radii)
{
  const std::vector<double> samples = Distances();
  FieldBuilder builder(Grid());
  const int channel = builder.AddChannel(SamplesOfGrid(samples.data(), Grid()));
  for (const double radius : radii)
  {
    builder.AddMaterial({channel, radius, FieldSense::AtMost});
  }
  std::shared_ptr<const ScalarField> field;
  const Status status = builder.Build(field);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return field;
}

// Parallel view along -z: x and y from -10 to 10 mm, z from 20 (near) to -20 (far).
FieldView ViewAlongZ(int side)
{
  Eigen::Matrix4d toClip = Eigen::Matrix4d::Identity();
  toClip(0, 0) = 0.1;
  toClip(1, 1) = 0.1;
  toClip(2, 2) = -1.0 / 40.0;
  toClip(2, 3) = 0.5;
  FieldView view;
  view.Rays = PixelRays(toClip, side, side);
  view.Finish.IsShaded = false;
  return view;
}

FieldImage Draw(const FieldRenderer& renderer)
{
  const PixelRays& rays = renderer.View().Rays;
  FieldImage image;
  image.Resize(rays.Width(), rays.Height(), true);
  renderer.DrawTile(0, rays.Width(), 0, rays.Height(), image);
  return image;
}

std::array<int, 4> ColorAt(const FieldImage& image, int column, int row)
{
  const std::uint8_t* bytes = &image.Colors[4 * image.Pixel(column, row)];
  return {bytes[0], bytes[1], bytes[2], bytes[3]};
}

TEST(FieldRenderer, PixelsShowHitsOfRayCaster)
{
  const auto field = Spheres({6.0});
  const RayCaster caster(field);
  const FieldRenderer renderer(field, ViewAlongZ(64));
  const FieldImage image = Draw(renderer);
  int hits = 0;
  for (int row = 0; row < 64; ++row)
  {
    for (int column = 0; column < 64; ++column)
    {
      const FieldHit expected =
          caster.CastWorld(renderer.View().Rays.OfPixel(column, row), 0.0, 1.0);
      const FieldHit& seen = image.Hits[image.Pixel(column, row)];
      ASSERT_EQ(seen.Kind, expected.Kind);
      ASSERT_EQ(seen.T, expected.T);
      ASSERT_EQ(seen.Position, expected.Position);
      ASSERT_EQ(seen.Gradient, expected.Gradient);
      hits += seen.Material == 0 ? 1 : 0;
    }
  }
  // The disc of 6 mm in 20 mm squared, by its pixels' centres; its outline is some 60 pixels long.
  EXPECT_NEAR(hits, M_PI * 36.0 / 400.0 * 64 * 64, 30.0);
}

TEST(FieldRenderer, DepthsMatchHits)
{
  const FieldImage image = Draw(FieldRenderer(Spheres({6.0}), ViewAlongZ(65)));
  // The central ray meets the sphere at z = 6: (20 - 6) / 40. That node lies on the sphere.
  EXPECT_NEAR(image.Depths[image.Pixel(32, 32)], 14.0 / 40.0, 1e-6);
  EXPECT_EQ(image.Depths[image.Pixel(0, 0)], 1.0F);
  EXPECT_EQ(ColorAt(image, 0, 0), (std::array<int, 4>{0, 0, 0, 0}));
}

TEST(FieldRenderer, BlendsTranslucentSurfacesFrontToBack)
{
  FieldView view = ViewAlongZ(65);
  view.Looks = {{{1.0, 0.0, 0.0}, 0.25}, {{0.0, 1.0, 0.0}, 1.0}};
  const FieldImage image = Draw(FieldRenderer(Spheres({6.0, 3.0}), view));
  // One crossing of red lies in front of green, which is opaque.
  EXPECT_EQ(ColorAt(image, 32, 32), (std::array<int, 4>{64, 191, 0, 255}));
  // Next to green the ray enters and leaves red: 1/4 + 3/4 * 1/4.
  EXPECT_EQ(ColorAt(image, 32 + 14, 32), (std::array<int, 4>{112, 0, 0, 112}));
}

TEST(FieldRenderer, ZeroOpacityHidesMaterial)
{
  FieldView view = ViewAlongZ(65);
  view.Looks = {{{1.0, 0.0, 0.0}, 0.0}, {{0.0, 1.0, 0.0}, 1.0}};
  const FieldRenderer renderer(Spheres({6.0, 3.0}), view);
  const FieldImage image = Draw(renderer);
  EXPECT_TRUE(renderer.IsOpaque());
  EXPECT_EQ(ColorAt(image, 32, 32), (std::array<int, 4>{0, 255, 0, 255}));
  EXPECT_EQ(ColorAt(image, 32 + 14, 32)[3], 0);
}

TEST(FieldRenderer, ClippingPlaneShowsBackOfSurface)
{
  FieldView view = ViewAlongZ(65);
  view.Kept.emplace_back(-Vector3::UnitZ(), 0.0); // z <= 0
  const FieldImage image = Draw(FieldRenderer(Spheres({6.0}), view));
  const FieldHit& hit = image.Hits[image.Pixel(32, 32)];
  EXPECT_NEAR(hit.Position[2], -6.0, 1e-9);
  EXPECT_FALSE(hit.IsEntering);
}

TEST(FieldRenderer, SceneDepthsEndRays)
{
  FieldView view = ViewAlongZ(65);
  view.Looks = {{{1.0, 0.0, 0.0}, 0.5}};
  // Between the front at depth 0.35 and the back at 0.65; then in front of both.
  view.SceneDepths.assign(65 * 65, 0.5F);
  view.SceneDepths[32 * 65 + 33] = 0.3F;
  const FieldImage image = Draw(FieldRenderer(Spheres({6.0}), view));
  EXPECT_EQ(ColorAt(image, 32, 32), (std::array<int, 4>{128, 0, 0, 128}));
  EXPECT_EQ(ColorAt(image, 33, 32), (std::array<int, 4>{0, 0, 0, 0}));
}

TEST(FieldRenderer, TilesMatchWholeImage)
{
  const FieldRenderer renderer(Spheres({6.0}), ViewAlongZ(50));
  const FieldImage whole = Draw(renderer);
  FieldImage tiled;
  tiled.Resize(50, 50, true);
  for (int row = 0; row < 50; row += 7)
  {
    for (int column = 0; column < 50; column += 9)
    {
      renderer.DrawTile(column, std::min(50, column + 9), row, std::min(50, row + 7), tiled);
    }
  }
  EXPECT_EQ(whole.Colors, tiled.Colors);
  EXPECT_EQ(whole.Depths, tiled.Depths);
}

TEST(FieldRenderer, ScenePlacementAffectsOnlyShading)
{
  FieldView view = ViewAlongZ(65);
  view.Finish = {true, 0.0, 1.0, 0.0, 1.0};
  view.Lights = {{false, Vector3::UnitX(), Vector3::Ones(), Vector3::Ones()}};
  view.Looks = {{Vector3::Ones(), 1.0}};
  // Rotated so that the field's +z is the scene's +x: the side facing the viewer is fully lit.
  view.ToScene.topLeftCorner<3, 3>() =
      Eigen::AngleAxisd(M_PI / 2.0, Vector3::UnitY()).toRotationMatrix();
  const FieldImage image = Draw(FieldRenderer(Spheres({6.0}), view));
  EXPECT_EQ(ColorAt(image, 32, 32), (std::array<int, 4>{255, 255, 255, 255}));
}
} // namespace
} // namespace palpate::field_renderer_test
