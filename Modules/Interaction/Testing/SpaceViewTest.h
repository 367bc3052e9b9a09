#pragma once

#include "AnatomicalView.h"
#include "OffScreenTest.h"
#include "SliceViewTest.h"
#include "vtkSpaceView.h"
#include "vtkSurfaceDisplay.h"

#include "vtkCamera.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::test::space_view
{
constexpr int Side = 200; // pixels, 60 mm
constexpr double PixelMillimeters = 0.3;

inline vtkSmartPointer<vtkPolyData> Sphere(const Vector3& center, double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(center.x(), center.y(), center.z());
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(100);
  sphere->SetPhiResolution(100);
  sphere->Update();
  return sphere->GetOutput();
}

// A view of the origin from the front, in parallel projection; tests choose the contents.
class SpaceViewTest : public OffScreenTest
{
protected:
  SpaceViewTest() : OffScreenTest(Side) {}
  void SetUp() override
  {
    OffScreenTest::SetUp();
    if (IsSkipped())
    {
      return;
    }
    this->View->SetRenderer(this->Renderer);
    this->View->SetCrosshair(this->Crosshair);
    this->View->AnnotationVisibilityOff();
    this->Surface->SetColor(0.0, 0.0, 1.0);
  }

  // The first frame chooses a camera; this replaces it.
  RasterImage Draw(int side = vtkSpaceView::ANTERIOR)
  {
    this->Window->Render();
    this->View->LookFrom(side);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const Vector3 eye =
        100.0 * FrameOf(AllViewSides[static_cast<std::size_t>(side)]).TowardsViewerWorld;
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetPosition(eye.data());
    camera->SetParallelScale(0.5 * Side * PixelMillimeters);
    this->Window->Render();
    return ReadWindow(this->Window);
  }
  Vector3 Sight() { return Vector3(this->Renderer->GetActiveCamera()->GetDirectionOfProjection()); }
  // From the front: x to the right, z up, mm.
  static const std::uint8_t* PixelAt(const RasterImage& raster, double x, double z)
  {
    return raster.Pixel(static_cast<int>(0.5 * Side + x / PixelMillimeters),
                        static_cast<int>(0.5 * Side - z / PixelMillimeters));
  }
  bool PickAt(double x, double z, Vector3& world)
  {
    return this->View->Pick(std::floor(0.5 * Side + x / PixelMillimeters),
                            std::floor(0.5 * Side + z / PixelMillimeters), world.data());
  }
  static bool IsBlue(const std::uint8_t* p) { return p[2] > p[0] + 60 && p[2] > p[1] + 60; }
  static bool IsRed(const std::uint8_t* p) { return p[0] > p[1] + 60 && p[0] > p[2] + 60; }
  static bool IsBlack(const std::uint8_t* p) { return p[0] + p[1] + p[2] == 0; }

  vtkNew<vtkSpaceView> View;
  vtkNew<vtkCrosshair> Crosshair;
  vtkNew<vtkSurfaceDisplay> Surface;
};
} // namespace palpate::test::space_view
