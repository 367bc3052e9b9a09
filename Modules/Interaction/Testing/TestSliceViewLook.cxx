#include "FieldContours.h"
#include "SliceViewTest.h"
#include "vtkProbeRepresentation.h"
#include "vtkSubVoxelVolume.h"
#include "vtkSubVoxelVolumeMapper.h"
#include "vtkSurfaceDisplay.h"

#include "vtkSphereSource.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate::slice_view_look_test
{
namespace
{
constexpr int Orientations[] = {vtkSliceView::AXIAL, vtkSliceView::CORONAL, vtkSliceView::SAGITTAL};

class SliceViewLook : public palpate::test::SliceViewTest
{
protected:
  // Where the ramp is 110.
  vtkSmartPointer<vtkSubVoxelVolume> Field() const
  {
    vtkNew<vtkSubVoxelVolumeMapper> mapper;
    mapper->SetInputData(this->Image);
    mapper->SetIsoValue(0, 110.0);
    mapper->SetMaterialColor(0, 0.0, 1.0, 0.0);
    auto volume = vtkSmartPointer<vtkSubVoxelVolume>::New();
    volume->SetMapper(mapper);
    return volume;
  }
  template <typename Is>
  int Count(Is&& is)
  {
    const RasterImage image = this->Draw();
    int count = 0;
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        count += is(PixelAt(image, x, y)) ? 1 : 0;
      }
    }
    return count;
  }
  static bool IsGreen(const std::uint8_t* p) { return p[1] > p[0] + 60 && p[1] > p[2] + 60; }
  static bool IsRed(const std::uint8_t* p) { return p[0] > p[1] + 60 && p[0] > p[2] + 60; }
};

TEST_F(SliceViewLook, ContourOfAFieldIsWhereItsSurfaceIs)
{
  const auto volume = this->Field();
  auto* mapper = vtkSubVoxelVolumeMapper::SafeDownCast(volume->GetMapper());
  PixelGrid pixels;
  pixels.FirstWorld = Vector3(-20.0, -20.0, 3.0);
  pixels.ColumnWorld = Vector3(0.5, 0.0, 0.0);
  pixels.RowWorld = Vector3(0.0, 0.5, 0.0);
  pixels.Width = pixels.Height = 80;
  const auto curves = ContourOfField(mapper->GetField(), 0, pixels);
  ASSERT_GT(curves.size(), 20U);
  for (const SurfaceCurve& curve : curves)
  {
    // From every pixel: a line crosses one at most.
    EXPECT_LT((curve.Points[0] - curve.Points[1]).norm(), 0.5 * std::sqrt(2.0) + 1e-6);
    for (const Vector3& point : curve.Points)
    {
      EXPECT_NEAR(test::Ramp(point), 110.0, 1e-3); // values are floats
      EXPECT_NEAR(point.z(), 3.0, 1e-9);
    }
  }
  EXPECT_TRUE(ContourOfField(nullptr, 0, pixels).empty());
  EXPECT_TRUE(ContourOfField(mapper->GetField(), 1, pixels).empty());
}

TEST_F(SliceViewLook, FieldHasAContourInEverySlice)
{
  const auto volume = this->Field();
  this->View->AddField(volume);
  for (const int orientation : Orientations)
  {
    this->View->SetOrientation(orientation);
    const RasterImage image = this->Draw();
    int green = 0;
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        if (IsGreen(PixelAt(image, x, y)))
        {
          const Vector3 world = this->WorldAt(x, y);
          green += std::abs(test::Ramp(world) - 110.0) < 2.5 ? 1 : 0; // within 2 mm
        }
      }
    }
    EXPECT_GT(green, 60) << orientation;
  }
  const int cuts = this->View->GetCutCount();
  this->Draw();
  EXPECT_EQ(this->View->GetCutCount(), cuts) << "nothing changed";
  auto* mapper = vtkSubVoxelVolumeMapper::SafeDownCast(volume->GetMapper());
  mapper->SetIsoValue(0, 90.0);
  this->Draw();
  EXPECT_EQ(this->View->GetCutCount(), cuts + 1);
  this->View->RemoveField(volume);
  EXPECT_EQ(this->Count(IsGreen), 0);
}

TEST_F(SliceViewLook, ForbiddenSurfaceHasARedContourEvenIfHidden)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(20.0);
  sphere->Update();
  vtkNew<vtkSurfaceDisplay> surface;
  surface->SetSurface(sphere->GetOutput());
  surface->SetColor(0.0, 1.0, 0.0);
  surface->VisibilityOff();
  this->View->AddSurface(surface);
  EXPECT_EQ(this->Count(IsRed), 0);
  surface->ForbiddenOn();
  EXPECT_GT(this->Count(IsRed), 100);
  EXPECT_EQ(this->Count(IsGreen), 0);
}

TEST_F(SliceViewLook, PressedToolHasItsForceWrittenNextToIt)
{
  vtkNew<vtkProbeRepresentation> probe;
  probe->SetToolSphere(4.0);
  probe->SetForce(0.0, 2.0, 0.0);
  const double* place = this->Crosshair->GetPositionWorld();
  probe->SetProxyPosition(place[0], place[1], place[2]);
  probe->SetProbePosition(place[0], place[1] + 3.0, place[2]);
  this->View->SetProbe(probe);
  const auto isWhite = [](const std::uint8_t* p) { return std::min({p[0], p[1], p[2]}) > 200; };
  const int before = this->Count(isWhite);
  probe->InContactOn();
  EXPECT_GT(this->Count(isWhite), before + 40);
  probe->SetProxyPosition(place[0], place[1], place[2] + 100.0);
  EXPECT_EQ(this->Count(isWhite), before) << "the slice does not cut the tool";
}
} // namespace
} // namespace palpate::slice_view_look_test
