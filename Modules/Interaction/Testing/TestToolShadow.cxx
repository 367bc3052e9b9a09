#include "ToolShadow.h"

#include "OffScreenTest.h"
#include "SliceViewTest.h"
#include "vtkProbeRepresentation.h"
#include "vtkSpaceView.h"
#include "vtkSurfaceDisplay.h"

#include "vtkCamera.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::tool_shadow_test
{
namespace
{
constexpr int Pixels = 200; // 60 mm
constexpr double PixelSize = 0.3;

// A view of a blue sphere from the front, in parallel projection.
class ToolShadowTest : public palpate::test::OffScreenTest
{
protected:
  ToolShadowTest() : OffScreenTest(Pixels) {}
  void SetUp() override
  {
    OffScreenTest::SetUp();
    if (IsSkipped())
    {
      return;
    }
    this->View->SetRenderer(this->Renderer);
    this->View->AnnotationVisibilityOff();
    this->Surface->SetColor(0.0, 0.0, 1.0);
  }
  RasterImage Draw()
  {
    this->Window->Render();
    this->View->LookFrom(vtkSpaceView::ANTERIOR);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetPosition(0.0, -100.0, 0.0);
    camera->SetParallelScale(0.5 * Pixels * PixelSize);
    this->Window->Render();
    return palpate::ReadWindow(this->Window);
  }

  vtkNew<vtkSpaceView> View;
  vtkNew<vtkSurfaceDisplay> Surface;
};

// From the front: a large sphere, nearly a wall, and a tool before it, beside the line of sight.
TEST_F(ToolShadowTest, ToolDarkensSurfaceByTheLightThatItKeepsFromIt)
{
  constexpr double Wall = 25.0;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(Wall);
  sphere->SetThetaResolution(100);
  sphere->SetPhiResolution(100);
  sphere->Update();
  this->Surface->SetSurface(sphere->GetOutput());
  this->View->AddSurface(this->Surface);
  vtkNew<vtkProbeRepresentation> probe;
  this->View->SetProbe(probe);
  probe->SetToolSphere(2.0);
  // The tool covers pixels within its radius of (x, z); those tested are beside it.
  const auto drawn = [&](double x, bool isShaded)
  {
    probe->SetProbePosition(x, -29.0, 0.0);
    probe->SetProxyPosition(x, -29.0, 0.0);
    this->View->SetToolShadow(isShaded);
    return this->Draw();
  };
  const auto blueAt = [](const RasterImage& raster, double x)
  {
    return static_cast<double>(
        raster.Pixel(static_cast<int>(0.5 * Pixels + x / PixelSize), Pixels / 2)[2]);
  };
  for (const double tool : {-6.0, 6.0})
  {
    const RasterImage shaded = drawn(tool, true);
    const RasterImage plain = drawn(tool, false);
    const palpate::ToolShadow shadow{Vector3(tool, -29.0, 0.0), 2.0};
    for (const double beside : {-3.0, -2.4, 2.4, 3.0, 5.0})
    {
      const double x = tool + beside;
      const Vector3 normal = Vector3(x, -std::sqrt(Wall * Wall - x * x), 0.0) / Wall;
      const double share = shadow.ShareAt(Wall * normal, normal);
      // Roundings to levels, half a pixel, and a specular share of up to 0.12, which stays.
      EXPECT_NEAR(blueAt(shaded, x), (1.0 - share) * blueAt(plain, x), 6.0) << tool << ", " << x;
    }
    EXPECT_LT(blueAt(shaded, tool + 2.4), blueAt(plain, tool + 2.4) - 12.0);
    EXPECT_NEAR(blueAt(shaded, -tool * 2.5), blueAt(plain, -tool * 2.5), 1.0) << "far away";
  }
  probe->VisibilityOff();
  const double hidden = blueAt(drawn(6.0, true), 8.4);
  EXPECT_EQ(hidden, blueAt(drawn(6.0, false), 8.4));
}
} // namespace
} // namespace palpate::tool_shadow_test
