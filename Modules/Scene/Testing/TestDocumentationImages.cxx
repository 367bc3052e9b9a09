#include "BaselineImage.h"
#include "DisplayTest.h"
#include "FitStructure.h"
#include "HeadCt.h"
#include "PhantomSampler.h"
#include "ProstateLikeModel.h"
#include "SceneField.h"
#include "SceneRenderer.h"
#include "TemporaryFolder.h"
#include "TestData.h"
#include "VolumeFile.h"

#include "vtkNew.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace palpate::documentation_images_test
{
namespace
{
constexpr SceneRenderer::Color Tan{{0.85, 0.66, 0.55}};

RasterImage SideBySide(const std::vector<RasterImage>& panels)
{
  RasterImage whole(0, panels.front().Height);
  for (const RasterImage& panel : panels)
  {
    whole.Width += panel.Width;
  }
  whole.Rgba.resize(4 * static_cast<std::size_t>(whole.Width * whole.Height));
  int left = 0;
  for (const RasterImage& panel : panels)
  {
    for (int row = 0; row < whole.Height; ++row)
    {
      std::copy_n(panel.Pixel(0, row), 4 * static_cast<std::size_t>(panel.Width),
                  whole.Pixel(left, row));
    }
    left += panel.Width;
  }
  return whole;
}

// A phantom on a clinical grid, and the fit of its mask.
struct PhantomFit
{
  PhantomFit()
  {
    palpate::PhantomGrid grid;
    grid.Spacing = {0.4, 0.4, 3.0};
    grid.CenterOn(palpate::Vector3::Zero());
    palpate::PhantomAppearance look;
    look.NoiseDeviation = 12.0;
    this->Phantom = palpate::MakePhantom(
        palpate::MakeProstateLikeModel(8, 4, palpate::Vector3::Zero()), grid, look);
    palpate::Segmentation segmentation;
    segmentation.Layers.emplace_back(this->Phantom.Mask);
    palpate::Segment structure;
    structure.Label = 1;
    structure.Value = 1;
    segmentation.Segments.push_back(structure);
    palpate::FitSettings settings;
    this->Model = palpate::FitStructure(segmentation, structure, settings);
    settings.Method = palpate::FitSettings::SurfaceMethod::Plain;
    this->Steps = palpate::FitStructure(segmentation, structure, settings);
  }

  palpate::PhantomImages Phantom;
  palpate::FitResult Model;
  palpate::FitResult Steps; // the mask's own boundary
};
class DocumentationImages : public palpate::test::DisplayTest
{
};

TEST_F(DocumentationImages, OverviewShowsMaskModelAndError)
{
  const PhantomFit fit;
  ASSERT_EQ(fit.Model.State, palpate::FitResult::Outcome::Fitted) << fit.Model.Message;
  std::vector<RasterImage> panels;
  {
    SceneRenderer scene;
    scene.AddSurface(fit.Steps.Surface, Tan, 1.0);
    panels.push_back(scene.Render(palpate::ObliqueFrame(), 400, 400));
  }
  {
    SceneRenderer scene;
    vtkImageData* volume = fit.Phantom.Volume;
    scene.AddSurface(fit.Model.ModelSurface, Tan, 0.75);
    scene.AddSlice(volume, SceneRenderer::Plane::Axial, palpate::Vector3::Zero());
    scene.AddSlice(volume, SceneRenderer::Plane::Sagittal, palpate::Vector3::Zero());
    panels.push_back(scene.Render(palpate::ObliqueFrame(), 400, 400));
  }
  {
    SceneRenderer scene;
    scene.AddSurface(fit.Model.ModelSurface, Tan, 1.0);
    ASSERT_TRUE(scene.ColorByArray("DistanceToSurface"));
    panels.push_back(scene.Render(palpate::ObliqueFrame(), 400, 400));
  }
  palpate::test::ExpectLikeBaseline(
      SideBySide(panels), std::filesystem::path(PALPATE_DOCUMENTATION_IMAGES) / "overview.png");
}

TEST_F(DocumentationImages, DrawsSkullFromCtAloneAndUnderSkin)
{
  PALPATE_REQUIRE_FILE(palpate::test::HeadCtProject);
  const palpate::test::TemporaryFolder folder;
  ASSERT_TRUE(palpate::test::ConvertHeadCt(folder / "head.nrrd"));
  const palpate::Volume head = palpate::ReadVolume(folder / "head.nrrd");
  const auto field = [&head](double iso)
  {
    return palpate::MakeIsoField(head.Image, {iso}, palpate::FieldInterpolation::Trilinear,
                                 [](double, const std::string&) { return true; });
  };
  constexpr SceneRenderer::Color Bone{{0.93, 0.89, 0.80}};
  std::vector<RasterImage> panels;
  for (const bool hasSkin : {false, true})
  {
    SceneRenderer scene;
    scene.AddField(field(300.0), {Bone}, 1.0);
    if (hasSkin)
    {
      scene.AddField(field(-300.0), {Tan}, 0.4);
    }
    panels.push_back(scene.Render(palpate::FrameOf(palpate::ViewSide::Anterior), 500, 480));
  }
  palpate::test::ExpectLikeBaseline(
      SideBySide(panels), std::filesystem::path(PALPATE_DOCUMENTATION_IMAGES) / "skull.png");
}
} // namespace
} // namespace palpate::documentation_images_test
