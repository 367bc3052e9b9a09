// Pixels of a volume that is drawn as a whole, seen from the front in parallel projection.
#include "RenderedVolume.h"

#include "DisplayTest.h"
#include "LabelImages.h"
#include "WindowImage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkVolume.h"

#include <cmath>

namespace palpate::rendered_volume_view_test
{
namespace
{
constexpr int Side = 160; // pixels, 80 mm
constexpr double PixelMillimeters = 0.5;

// A bright sphere of 8 mm at (10, 5, -12) mm, on an oblique grid.
vtkSmartPointer<vtkImageData> SphereImage()
{
  test::LabelGrid grid;
  grid.Size = {{60, 70, 40}};
  grid.Spacing = {{1.0, 0.9, 1.6}};
  std::mt19937_64 random(31);
  grid.Direction = test::RandomRotation(random);
  grid.CenterOnOrigin();
  return test::MakeLabelImage<short>(
      grid,
      [](double x, double y, double z) { return std::hypot(x - 10.0, y - 5.0, z + 12.0) < 8.0; },
      1000);
}

class RenderedVolumeView : public test::DisplayTest
{
protected:
  void SetUp() override
  {
    DisplayTest::SetUp();
    this->Window = vtkSmartPointer<vtkRenderWindow>::New();
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(Side, Side);
    this->Window->AddRenderer(this->Renderer);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetPosition(0.0, -200.0, 0.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetParallelScale(0.5 * Side * PixelMillimeters);
  }
  RasterImage Draw()
  {
    this->Renderer->ResetCameraClippingRange();
    this->Window->Render();
    return ReadWindow(this->Window);
  }
  RasterImage Draw(RenderedVolume& volume, VolumePreset preset = VolumePreset::Bone,
                   double window = 1000.0, double level = 500.0)
  {
    volume.Show(preset, window, level);
    this->Renderer->AddViewProp(volume.Prop());
    return this->Draw();
  }
  // A blue ball of 3 mm in front of or behind the sphere's centre.
  void AddBall(double y)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(3.0);
    ball->SetCenter(10.0, y, -12.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(ball->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.0, 0.0, 1.0);
    this->Renderer->AddActor(actor);
  }
  static const std::uint8_t* At(const RasterImage& raster, double x, double z)
  {
    return raster.Pixel(static_cast<int>(0.5 * Side + x / PixelMillimeters),
                        static_cast<int>(0.5 * Side - z / PixelMillimeters));
  }
  static bool IsBright(const std::uint8_t* p) { return p[0] > 80 && p[1] > 80; }
  static bool IsBlack(const std::uint8_t* p) { return p[0] + p[1] + p[2] == 0; }
  static bool IsBlue(const std::uint8_t* p) { return p[2] > p[0] + 60; }

  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
};

// On the processor, and by OpenGL's shaders.
TEST_F(RenderedVolumeView, BrightSphereIsSeenWhereItIs)
{
  const auto image = SphereImage();
  for (const bool usesCard : {false, true})
  {
    RenderedVolume volume(image, usesCard);
    const RasterImage raster = this->Draw(volume);
    EXPECT_TRUE(IsBright(At(raster, 10.0, -12.0))) << usesCard;
    for (const double off : {-6.0, 6.0})
    {
      EXPECT_FALSE(IsBlack(At(raster, 10.0 + off, -12.0))) << usesCard;
      EXPECT_FALSE(IsBlack(At(raster, 10.0, -12.0 + off))) << usesCard;
      EXPECT_TRUE(IsBlack(At(raster, 10.0 + 1.8 * off, -12.0))) << usesCard;
      EXPECT_TRUE(IsBlack(At(raster, 10.0, -12.0 + 1.8 * off))) << usesCard;
    }
    EXPECT_TRUE(IsBlack(At(raster, -10.0, 12.0))) << usesCard;
    this->Renderer->RemoveViewProp(volume.Prop());
  }
}

TEST_F(RenderedVolumeView, SurfaceInFrontHidesItAndOneBehindIsHidden)
{
  const auto image = SphereImage();
  for (const bool usesCard : {false, true})
  {
    RenderedVolume volume(image, usesCard);
    this->AddBall(-10.0);
    EXPECT_TRUE(IsBlue(At(this->Draw(volume), 10.0, -12.0))) << usesCard;
    this->Renderer->RemoveAllViewProps();
    this->AddBall(20.0);
    EXPECT_TRUE(IsBright(At(this->Draw(volume), 10.0, -12.0))) << usesCard;
    EXPECT_FALSE(IsBlue(At(this->Draw(volume), 10.0, -12.0))) << usesCard;
    this->Renderer->RemoveAllViewProps();
  }
}

TEST_F(RenderedVolumeView, OpacityFollowsTheWindow)
{
  RenderedVolume volume(SphereImage(), false);
  EXPECT_TRUE(IsBright(At(this->Draw(volume), 10.0, -12.0)));
  EXPECT_TRUE(IsBlack(At(this->Draw(volume, VolumePreset::Bone, 1000.0, 1600.0), 10.0, -12.0)));
  EXPECT_TRUE(IsBright(At(this->Draw(volume, VolumePreset::Bone, 100.0, 800.0), 10.0, -12.0)));
}

TEST_F(RenderedVolumeView, MaximumShowsWhatOpaqueShellsHide)
{
  test::LabelGrid grid;
  grid.Size = {{50, 50, 50}};
  grid.CenterOnOrigin();
  const auto image = test::MakeLabelImage<short>(
      grid, [](double x, double y, double z) { return std::hypot(x, y, z) < 20.0; }, 700);
  for (int n = -1; n <= 1; ++n)
  {
    *static_cast<short*>(image->GetScalarPointer(25 + n, 25, 25)) = 1000;
  }
  RenderedVolume volume(image, false);
  const auto step = [this, &volume](VolumePreset preset)
  {
    const RasterImage raster = this->Draw(volume, preset);
    return At(raster, 0.5, 0.5)[0] - At(raster, 0.5, 6.0)[0];
  };
  EXPECT_GT(step(VolumePreset::MaximumIntensity), 25);
  EXPECT_LT(std::abs(step(VolumePreset::Bone)), 12);
}

TEST_F(RenderedVolumeView, EveryPresetDrawsTheSphereItsOwnWay)
{
  RenderedVolume volume(SphereImage(), false);
  std::vector<RasterImage> pictures;
  for (const VolumePreset preset : AllVolumePresets)
  {
    pictures.push_back(this->Draw(volume, preset));
    EXPECT_FALSE(IsBlack(At(pictures.back(), 10.0, -12.0))) << NameOf(preset);
    for (std::size_t n = 0; n + 1 < pictures.size(); ++n)
    {
      const auto* now = At(pictures.back(), 10.0, -12.0);
      const auto* other = At(pictures[n], 10.0, -12.0);
      EXPECT_FALSE(std::equal(now, now + 3, other)) << NameOf(preset);
    }
  }
}

TEST_F(RenderedVolumeView, FewerRaysDrawTheSameMoreCoarsely)
{
  RenderedVolume volume(SphereImage(), false);
  const RasterImage fine = this->Draw(volume);
  volume.LimitRays(Side, Side, 1600.0);
  const RasterImage coarse = this->Draw();
  double difference = 0.0;
  for (int row = 0; row < Side; ++row)
  {
    for (int column = 0; column < Side; ++column)
    {
      difference += std::abs(fine.Pixel(column, row)[0] - coarse.Pixel(column, row)[0]);
    }
  }
  EXPECT_GT(difference, 0.0);
  EXPECT_LT(difference / (Side * Side), 6.0);
  EXPECT_TRUE(IsBright(At(coarse, 10.0, -12.0)));
}
} // namespace
} // namespace palpate::rendered_volume_view_test
