#include "SpaceViewTest.h"
#include "SurfaceMaterial.h"
#include "vtkLandmarks.h"
#include "vtkSubVoxelVolume.h"
#include "vtkSubVoxelVolumeMapper.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace palpate::space_view_look_test
{
namespace
{
using namespace palpate::test::space_view;

class SpaceViewLook : public SpaceViewTest
{
protected:
  static int Largest(const RasterImage& raster)
  {
    int largest = 0;
    for (int row = 0; row < Side; ++row)
    {
      for (int column = 0; column < Side; ++column)
      {
        const std::uint8_t* p = raster.Pixel(column, row);
        largest = std::max({largest, +p[0], +p[1], +p[2]});
      }
    }
    return largest;
  }
  // Pixels in a row of the image, from a place to the right, for which something holds.
  template <typename Is>
  static int Count(const RasterImage& raster, Is&& is)
  {
    int count = 0;
    for (int row = 0; row < Side; ++row)
    {
      for (int column = 0; column < Side; ++column)
      {
        count += is(raster.Pixel(column, row)) ? 1 : 0;
      }
    }
    return count;
  }
  static bool IsWhite(const std::uint8_t* p) { return std::min({p[0], p[1], p[2]}) > 220; }
  static vtkSmartPointer<vtkPolyData> Valued(vtkSmartPointer<vtkPolyData> sphere, double value)
  {
    vtkNew<vtkDoubleArray> distances;
    distances->SetName("DistanceToSurface");
    distances->SetNumberOfTuples(sphere->GetNumberOfPoints());
    distances->Fill(value);
    sphere->GetPointData()->AddArray(distances);
    return sphere;
  }
};

TEST_F(SpaceViewLook, NoShadedPixelBurnsOut)
{
  this->Surface->SetSurface(Sphere(Vector3::Zero(), 25.0));
  this->Surface->SetColor(1.0, 1.0, 1.0);
  this->View->AddSurface(this->Surface);
  for (const int side : {vtkSpaceView::ANTERIOR, vtkSpaceView::LEFT, vtkSpaceView::SUPERIOR})
  {
    const int largest = Largest(this->Draw(side));
    EXPECT_LT(largest, 255);
    EXPECT_GT(largest, 225) << "nor is it dull";
  }
}

// White is the colour of 0 in maps.
TEST_F(SpaceViewLook, SurfaceOfAMapIsShadedThroughout)
{
  this->Surface->SetSurface(Valued(Sphere(Vector3::Zero(), 25.0), 0.0));
  this->Surface->SetColorArray("DistanceToSurface");
  this->Surface->SetColorLimit(2.0);
  this->View->AddSurface(this->Surface);
  const RasterImage raster = this->Draw();
  EXPECT_LT(Largest(raster), 255);
  // From the middle to the rim that the key light does not reach.
  int last = 256;
  for (double step = 0.25; step < 1.0; step += 0.15)
  {
    const int grey = PixelAt(raster, -7.0 + 26.0 * step, 9.0 - 26.0 * step)[0];
    EXPECT_LT(grey, last) << step;
    last = grey;
  }
  EXPECT_LT(last, 170);
}

TEST_F(SpaceViewLook, FieldIsShadedLikeASurface)
{
  vtkNew<vtkSubVoxelVolumeMapper> mapper;
  mapper->SetInputData(palpate::test::RampImage(Matrix3::Identity()));
  mapper->SetIsoValue(0, 100.0);
  mapper->SetMaterialColor(0, 1.0, 1.0, 1.0);
  vtkNew<vtkSubVoxelVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->ShadeOn();
  SurfaceMaterial::Set(volume->GetProperty());
  this->Renderer->AddVolume(volume);
  const RasterImage field = this->Draw(vtkSpaceView::POSTERIOR);
  Vector3 place;
  ASSERT_TRUE(this->PickAt(0.0, 0.0, place));
  this->Renderer->RemoveVolume(volume);
  // A sphere has the plane's normal somewhere: that of the ramp's fall.
  this->Surface->SetSurface(Sphere(Vector3::Zero(), 20.0));
  this->Surface->SetColor(1.0, 1.0, 1.0);
  this->View->AddSurface(this->Surface);
  const RasterImage surface = this->Draw(vtkSpaceView::POSTERIOR);
  const Vector3 normal = 20.0 * Vector3(-0.6, 0.9, -0.7).normalized();
  EXPECT_NEAR(PixelAt(field, 0.0, 0.0)[0], PixelAt(surface, -normal.x(), normal.z())[0], 6);
}

TEST_F(SpaceViewLook, TranslucentSurfaceKeepsItsColor)
{
  this->Surface->SetSurface(Sphere(Vector3::Zero(), 20.0));
  this->Surface->SetColor(0.9, 0.6, 0.2);
  this->View->AddSurface(this->Surface);
  const RasterImage solid = this->Draw();
  this->Surface->SetOpacity(0.5);
  const RasterImage clear = this->Draw();
  double share = 0.0;
  int count = 0;
  for (double x = -19.0; x <= 19.0; x += 2.0)
  {
    share += 1.0 * PixelAt(clear, x, 0.0)[0] / PixelAt(solid, x, 0.0)[0];
    ++count;
    EXPECT_NEAR(1.0 * PixelAt(clear, x, 0.0)[1] / PixelAt(clear, x, 0.0)[0],
                1.0 * PixelAt(solid, x, 0.0)[1] / PixelAt(solid, x, 0.0)[0], 0.08)
        << x;
  }
  EXPECT_GT(share / count, 0.62) << "on black, half of it would be 0.5";
  EXPECT_GT(1.0 * PixelAt(clear, 19.0, 0.0)[0] / PixelAt(solid, 19.0, 0.0)[0], 0.75) << "its rim";
}

TEST_F(SpaceViewLook, TranslucentSurfacesAreBlendedByTheirDepths)
{
  vtkNew<vtkSurfaceDisplay> other;
  for (vtkSurfaceDisplay* surface : {this->Surface.Get(), other.Get()})
  {
    surface->SetOpacity(0.7);
    this->View->AddSurface(surface);
  }
  this->Window->SetAlphaBitPlanes(1);
  this->Surface->SetSurface(Sphere(Vector3(0.0, -15.0, 0.0), 10.0)); // nearer, though added first
  other->SetSurface(Sphere(Vector3(0.0, 15.0, 0.0), 10.0));
  other->SetColor(1.0, 0.0, 0.0);
  EXPECT_TRUE(IsBlue(PixelAt(this->Draw(), 0.0, 0.0)));
  EXPECT_TRUE(IsRed(PixelAt(this->Draw(vtkSpaceView::POSTERIOR), 0.0, 0.0)));
}

TEST_F(SpaceViewLook, SelectedSurfaceIsOutlined)
{
  this->Surface->SetSurface(Sphere(Vector3::Zero(), 20.0));
  this->View->AddSurface(this->Surface);
  const RasterImage plain = this->Draw();
  this->Surface->HighlightOn();
  const RasterImage outlined = this->Draw();
  const double around = 2.0 * M_PI * 20.0 / PixelMillimeters;
  EXPECT_GT(Count(outlined, IsWhite), 1.5 * around);
  EXPECT_LT(Count(outlined, IsWhite), 7.0 * around) << "a line";
  EXPECT_EQ(Count(plain, IsWhite), 0);
  EXPECT_EQ(PixelAt(outlined, 5.0, 0.0)[2], PixelAt(plain, 5.0, 0.0)[2]) << "as bright as before";
  this->Renderer->SetBackground(1.0, 1.0, 1.0);
  EXPECT_GT(Count(this->Draw(), [](const std::uint8_t* p) { return p[0] + p[1] + p[2] < 100; }),
            around)
      << "dark on light ground";
}

TEST_F(SpaceViewLook, SelectedFieldIsOutlined)
{
  vtkNew<vtkSubVoxelVolumeMapper> mapper;
  mapper->SetInputData(palpate::test::RampImage(palpate::test::SkewTurn()));
  mapper->SetIsoValue(0, 100.0);
  mapper->SetMaterialColor(0, 0.0, 0.0, 0.7);
  vtkNew<vtkSubVoxelVolume> volume;
  volume->SetMapper(mapper);
  this->Renderer->AddVolume(volume);
  this->Draw(vtkSpaceView::POSTERIOR);
  this->Renderer->GetActiveCamera()->SetParallelScale(80.0); // all of it
  this->Window->Render();
  EXPECT_EQ(Count(ReadWindow(this->Window), IsWhite), 0);
  mapper->SetOutlineWidth(2.0);
  this->Window->Render();
  EXPECT_GT(Count(ReadWindow(this->Window), IsWhite), 300);
}

TEST_F(SpaceViewLook, ForbiddenSurfaceIsOutlinedInRedEvenIfHidden)
{
  const auto isReddish = [](const std::uint8_t* p) { return p[0] > p[1] + 30; };
  this->Surface->SetSurface(Sphere(Vector3::Zero(), 12.0));
  this->Surface->VisibilityOff();
  this->View->AddSurface(this->Surface);
  EXPECT_EQ(Count(this->Draw(), isReddish), 0);
  this->Surface->ForbiddenOn();
  RasterImage raster = this->Draw();
  EXPECT_GT(Count(raster, IsRed), 200);
  EXPECT_TRUE(IsBlack(PixelAt(raster, 3.0, 0.0))) << "only its outline";
  Vector3 world;
  EXPECT_FALSE(this->PickAt(0.0, 0.0, world));
  // Behind something else it is fainter.
  vtkNew<vtkSurfaceDisplay> front;
  front->SetSurface(Sphere(Vector3(0.0, -20.0, 0.0), 20.0));
  front->SetColor(0.5, 0.5, 0.5);
  this->View->AddSurface(front);
  raster = this->Draw();
  EXPECT_GT(Count(raster, isReddish), 200);
  EXPECT_LT(Count(raster, [](const std::uint8_t* p) { return p[0] > p[1] + 150; }), 20);
}

TEST_F(SpaceViewLook, HiddenLandmarkAndItsTextAreFaint)
{
  const auto green = [](const RasterImage& raster, int from, int to)
  {
    double most = 0.0;
    for (int column = from; column < to; ++column)
    {
      for (int row = Side / 2 - 12; row < Side / 2 + 12; ++row)
      {
        const std::uint8_t* p = raster.Pixel(column, row);
        most = std::max(most, p[1] - 0.5 * (p[0] + p[2]));
      }
    }
    return most;
  };
  vtkNew<vtkLandmarks> landmarks;
  landmarks->SetColor(0.0, 1.0, 0.0);
  landmarks->SetRadius(3.0);
  landmarks->AddLandmark("here", 0.0, 0.0, 0.0);
  this->View->SetLandmarks(landmarks);
  this->Surface->SetSurface(Sphere(Vector3(0.0, -25.0, 0.0), 22.0));
  this->Surface->SetColor(0.5, 0.5, 0.5);
  this->Surface->VisibilityOff();
  this->View->AddSurface(this->Surface);
  constexpr int Middle = Side / 2;
  const RasterImage seen = this->Draw();
  this->Surface->VisibilityOn();
  const RasterImage hidden = this->Draw();
  for (const auto& [from, to] :
       {std::pair{Middle - 8, Middle + 8}, std::pair{Middle + 16, Middle + 50}})
  {
    EXPECT_GT(green(seen, from, to), 150.0) << from;
    EXPECT_GT(green(hidden, from, to), 15.0) << from;
    EXPECT_LT(green(hidden, from, to), 0.6 * green(seen, from, to)) << from;
  }
}

TEST_F(SpaceViewLook, LandmarkHasADarkRimOnAnySurface)
{
  vtkNew<vtkLandmarks> landmarks;
  landmarks->SetRadius(4.0);
  landmarks->AddLandmark("", 0.0, -27.0, 0.0); // in front of the surface
  this->View->SetLandmarks(landmarks);
  this->Surface->SetSurface(Sphere(Vector3::Zero(), 20.0));
  this->Surface->SetColor(0.62, 0.98, 0.45); // the landmark's
  this->View->AddSurface(this->Surface);
  const RasterImage raster = this->Draw();
  int dark = 0;
  for (double x = -6.0; x < 0.0; x += PixelMillimeters)
  {
    const std::uint8_t* p = PixelAt(raster, x, 0.0);
    dark += p[0] + p[1] + p[2] < 60 ? 1 : 0;
  }
  EXPECT_GE(dark, 2);
  EXPECT_GT(PixelAt(raster, 0.0, 0.0)[1], 150) << "around it, not over it";
}

TEST_F(SpaceViewLook, EffectsRestWhileItMoves)
{
  this->Surface->SetSurface(Sphere(Vector3::Zero(), 15.0));
  this->View->AddSurface(this->Surface);
  const RasterImage rough = this->Draw();
  this->View->AntialiasingOn();
  this->View->AmbientOcclusionOn();
  this->View->MovingOn();
  EXPECT_EQ(this->Draw().Rgba, rough.Rgba);
  this->View->MovingOff();
  EXPECT_NE(this->Draw().Rgba, rough.Rgba);
}

TEST_F(SpaceViewLook, OcclusionLeavesGradedGroundAsItIs)
{
  this->Surface->SetSurface(Sphere(Vector3::Zero(), 10.0));
  this->View->AddSurface(this->Surface);
  this->Renderer->GradientBackgroundOn();
  this->Renderer->SetBackground(0.1, 0.1, 0.1);
  this->Renderer->SetBackground2(0.4, 0.4, 0.5);
  const RasterImage plain = this->Draw();
  this->View->AmbientOcclusionOn();
  const RasterImage occluded = this->Draw();
  for (const double height : {-28.0, 0.0, 28.0})
  {
    EXPECT_NEAR(PixelAt(occluded, 28.0, height)[2], PixelAt(plain, 28.0, height)[2], 1) << height;
  }
  EXPECT_GT(PixelAt(plain, 28.0, 28.0)[2], PixelAt(plain, 28.0, -28.0)[2] + 50);
}

TEST_F(SpaceViewLook, TellsWhetherTheCameraIsInside)
{
  this->Surface->SetSurface(Sphere(Vector3::Zero(), 15.0));
  this->View->AddSurface(this->Surface);
  this->Draw();
  EXPECT_FALSE(this->View->IsCameraInside());
  this->Renderer->GetActiveCamera()->SetPosition(1.0, -8.0, 2.0);
  EXPECT_TRUE(this->View->IsCameraInside());
}
} // namespace
} // namespace palpate::space_view_look_test
