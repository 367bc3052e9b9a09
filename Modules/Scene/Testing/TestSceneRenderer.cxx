#include "SceneRenderer.h"

#include "BaselineImage.h"
#include "DisplayTest.h"
#include "SceneField.h"
#include "SyntheticFit.h"
#include "vtkNew.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>

namespace palpate::scene_renderer_test
{
namespace
{
using palpate::test::ExpectLikeBaseline;

const std::filesystem::path Baselines = PALPATE_BASELINES;
constexpr SceneRenderer::Color Tan{{0.85, 0.66, 0.55}};

class SceneRendererTest : public palpate::test::DisplayTest
{
};

bool IsBackground(const std::uint8_t* pixel)
{
  return pixel[0] == 255 && pixel[1] == 255 && pixel[2] == 255;
}

TEST_F(SceneRendererTest, ErrorMapLooksLikeItsBaseline)
{
  const palpate::test::SyntheticFit fit;
  SceneRenderer scene;
  scene.AddSurface(fit.Result.ModelSurface, Tan, 1.0);
  ASSERT_TRUE(scene.ColorByArray("DistanceToSurface"));
  ExpectLikeBaseline(scene.Render(palpate::ObliqueFrame(), 480, 480),
                     Baselines / "SceneErrorMap.png");
}

TEST_F(SceneRendererTest, SurfaceInObliqueSlicesLooksLikeItsBaseline)
{
  const palpate::test::SyntheticFit fit;
  SceneRenderer scene;
  scene.SetBackground({{0.1, 0.1, 0.12}});
  scene.AddSurface(fit.Result.Surface, Tan, 0.6);
  scene.AddSlice(fit.Mri.Image, SceneRenderer::Plane::Axial, palpate::test::SyntheticFit::Center);
  scene.AddSlice(fit.Mri.Image, SceneRenderer::Plane::Sagittal,
                 palpate::test::SyntheticFit::Center);
  ExpectLikeBaseline(scene.Render(palpate::ObliqueFrame(), 480, 360),
                     Baselines / "SceneSlices.png");
}

TEST_F(SceneRendererTest, FieldCoversThePixelsOfItsMesh)
{
  const palpate::test::SyntheticFit fit;
  palpate::Segmentation mask;
  mask.Layers = {fit.Result.Mask};
  mask.Segments = {fit.Result.Structure};
  const auto field =
      palpate::MakeSegmentField(mask, mask.Segments, palpate::FieldInterpolation::Trilinear, 0.5,
                                [](double, const std::string&) { return true; });
  // Both are in both scenes, so that the frames agree, but only one is visible.
  const auto draw = [&](double meshOpacity, double fieldOpacity)
  {
    SceneRenderer scene;
    scene.AddSurface(fit.Result.Surface, Tan, meshOpacity);
    scene.AddField(field, {Tan}, fieldOpacity);
    return scene.Render(palpate::ObliqueFrame(), 300, 300);
  };
  const RasterImage seenMesh = draw(1.0, 0.0);
  const RasterImage seenField = draw(0.0, 1.0);
  int covered = 0;
  int different = 0;
  for (int row = 0; row < 300; ++row)
  {
    for (int column = 0; column < 300; ++column)
    {
      const bool isMesh = !IsBackground(seenMesh.Pixel(column, row));
      covered += isMesh ? 1 : 0;
      different += isMesh != !IsBackground(seenField.Pixel(column, row)) ? 1 : 0;
    }
  }
  // The outline is some 700 pixels long; the mask's slices are six pixels thick, and the mesh is
  // that of the body itself.
  EXPECT_GT(covered, 20000);
  EXPECT_LT(different, 1400);
}

TEST_F(SceneRendererTest, ObliqueSliceAgreesWithTheSurface)
{
  // The bright body in the slice must fill the model's silhouette: both lie in patient space.
  const palpate::test::SyntheticFit fit;
  SceneRenderer scene;
  scene.SetBackground({{0.0, 0.0, 0.0}});
  scene.AddSlice(fit.Mri.Image, SceneRenderer::Plane::Axial, palpate::test::SyntheticFit::Center);
  const RasterImage slice = scene.Render(FrameOf(ViewSide::Inferior), 300, 300);
  const auto mesh = fit.Result.Surface;
  SceneRenderer both;
  both.SetBackground({{0.0, 0.0, 0.0}});
  both.AddSlice(fit.Mri.Image, SceneRenderer::Plane::Axial, palpate::test::SyntheticFit::Center);
  both.AddSurface(mesh, {{0.0, 0.0, 1.0}}, 1.0);
  const RasterImage covered = both.Render(FrameOf(ViewSide::Inferior), 300, 300);
  double bright = 0.0;
  double brightAndCovered = 0.0;
  for (int row = 60; row < 240; ++row) // without the letters
  {
    for (int column = 60; column < 240; ++column)
    {
      const std::uint8_t* over = covered.Pixel(column, row);
      if (slice.Pixel(column, row)[0] > 180)
      {
        bright += 1.0;
        brightAndCovered += over[2] > over[0] + 8 ? 1.0 : 0.0;
      }
    }
  }
  ASSERT_GT(bright, 2000.0);
  // The rest are pixels along the rim, in partial-volume voxels.
  EXPECT_GT(brightAndCovered / bright, 0.98);
}

TEST_F(SceneRendererTest, EverythingFitsIntoTheImage)
{
  const palpate::test::SyntheticFit fit;
  SceneRenderer scene;
  scene.AddSurface(fit.Result.Surface, {{0.0, 0.0, 1.0}}, 1.0);
  for (const ViewSide side : palpate::AllViewSides)
  {
    const RasterImage image = scene.Render(FrameOf(side), 240, 150);
    int blue = 0;
    for (int row = 0; row < image.Height; ++row)
    {
      for (int column = 0; column < image.Width; ++column)
      {
        const std::uint8_t* pixel = image.Pixel(column, row);
        const bool isSurface = pixel[2] > pixel[0] + 40;
        blue += isSurface ? 1 : 0;
        const bool isRim =
            row == 0 || column == 0 || row + 1 == image.Height || column + 1 == image.Width;
        ASSERT_FALSE(isRim && isSurface) << palpate::NameOf(side);
      }
    }
    EXPECT_GT(blue, 240 * 150 / 5) << palpate::NameOf(side);
  }
}

TEST_F(SceneRendererTest, BodyOfAnySizeFillsTheImage)
{
  for (const double radius : {1e-6, 1e-3, 1.0, 1e6})
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(radius);
    ball->SetCenter(3.0 * radius, 0.0, 0.0);
    ball->Update();
    SceneRenderer scene;
    scene.AddSurface(ball->GetOutput(), Tan, 1.0);
    const RasterImage image = scene.Render(palpate::ObliqueFrame(), 100, 100);
    EXPECT_FALSE(IsBackground(image.Pixel(50, 50))) << radius;
    EXPECT_FALSE(IsBackground(image.Pixel(25, 50))) << radius;
  }
}

TEST_F(SceneRendererTest, MissingArraysColorNothing)
{
  const palpate::test::SyntheticFit fit;
  SceneRenderer scene;
  scene.AddSurface(fit.Result.ModelSurface, Tan, 1.0);
  EXPECT_FALSE(scene.ColorByArray("NoSuchArray"));
  EXPECT_EQ(scene.ArrayNames(), std::vector<std::string>{"DistanceToSurface"});
}

TEST_F(SceneRendererTest, ImageDoesNotDependOnEarlierOnes)
{
  const palpate::test::SyntheticFit fit;
  const auto color = [](SceneRenderer& scene)
  {
    scene.SetBackground({{0.1, 0.1, 0.1}}); // and so its letters are light
    return scene.ColorByArray("DistanceToSurface");
  };
  const auto drawnFirst = [&](int width, int height)
  {
    SceneRenderer scene;
    scene.AddSurface(fit.Result.ModelSurface, Tan, 1.0);
    EXPECT_TRUE(color(scene));
    return scene.Render(FrameOf(ViewSide::Superior), width, height);
  };
  SceneRenderer scene;
  scene.AddSurface(fit.Result.ModelSurface, Tan, 1.0);
  scene.Render(FrameOf(ViewSide::Left), 300, 240);
  ASSERT_TRUE(color(scene));
  EXPECT_EQ(scene.Render(FrameOf(ViewSide::Superior), 300, 240).Rgba, drawnFirst(300, 240).Rgba);
  EXPECT_EQ(scene.Render(FrameOf(ViewSide::Superior), 160, 130).Rgba, drawnFirst(160, 130).Rgba);
}

TEST_F(SceneRendererTest, EmptySceneShowsTheBackground)
{
  SceneRenderer scene;
  const RasterImage image = scene.Render(FrameOf(ViewSide::Left), 64, 48);
  EXPECT_EQ(image.Width, 64);
  EXPECT_EQ(image.Height, 48);
  EXPECT_TRUE(IsBackground(image.Pixel(20, 12)));
}
} // namespace
} // namespace palpate::scene_renderer_test
