#include "SlicePosition.h"
#include "SliceViewTest.h"
#include "vtkLandmarks.h"
#include "vtkProbeRepresentation.h"
#include "vtkSurfaceDisplay.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkPropCollection.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::vtk_slice_view_test
{
namespace
{
using vtkSliceViewTest = palpate::test::SliceViewTest;

constexpr int Orientations[] = {vtkSliceView::AXIAL, vtkSliceView::CORONAL, vtkSliceView::SAGITTAL};

vtkSmartPointer<vtkSurfaceDisplay> SphereDisplay(const Vector3& center, double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(center.x(), center.y(), center.z());
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(80);
  sphere->SetPhiResolution(80);
  sphere->Update();
  auto display = vtkSmartPointer<vtkSurfaceDisplay>::New();
  display->SetSurface(sphere->GetOutput());
  display->SetColor(0.0, 1.0, 0.0);
  return display;
}

bool IsGreen(const std::uint8_t* pixel)
{
  return pixel[1] > pixel[0] + 60 && pixel[1] > pixel[2] + 60;
}

TEST_F(vtkSliceViewTest, FitsToSurfacesUntilThereIsAVolume)
{
  const Vector3 center(400.0, -300.0, 900.0);
  constexpr double Radius = 20.0;
  constexpr double Margin = 1.25;
  this->Display->SetImage(nullptr);
  this->Crosshair->SetPositionWorld(center.data());
  for (const int orientation : Orientations)
  {
    this->View->SetOrientation(orientation);
    const auto ball = SphereDisplay(center, Radius);
    this->View->AddSurface(ball);
    this->View->FitToImage();
    const RasterImage image = this->Draw();
    int green = 0;
    for (int y = 0; y < Height; ++y)
    {
      green += IsGreen(PixelAt(image, Width / 2, y)) ? 1 : 0;
    }
    EXPECT_GT(green, 0) << orientation;
    // Flat triangles and the poles are inside the sphere.
    EXPECT_NEAR(this->View->GetPixelMillimeters(), Margin * 2.0 * Radius / Height, 0.01);
    this->View->RemoveSurface(ball);
  }
  const auto ball = SphereDisplay(center, Radius);
  this->View->AddSurface(ball);
  const auto above = SphereDisplay(center + Vector3(0.0, 0.0, 3.0 * Radius), Radius);
  this->View->AddSurface(above);
  this->Draw();
  EXPECT_NEAR(this->View->GetPixelMillimeters(), Margin * 5.0 * Radius / Height, 0.02);
  this->View->Zoom(2.0, 0.5 * Width, 0.5 * Height);
  const auto farther = SphereDisplay(center + Vector3(0.0, 0.0, 9.0 * Radius), Radius);
  this->View->AddSurface(farther);
  this->Draw();
  EXPECT_NEAR(this->View->GetPixelMillimeters(), 0.5 * Margin * 5.0 * Radius / Height, 0.01);
  this->View->FitToImage();
  this->Draw();
  this->Display->SetImage(this->Image);
  this->Draw();
  const double fitted = this->View->GetPixelMillimeters();
  this->View->FitToImage();
  this->Draw();
  EXPECT_EQ(this->View->GetPixelMillimeters(), fitted);
}

TEST_F(vtkSliceViewTest, PixelsShowVolumeAtWorldCoordinates)
{
  this->Crosshair->SetPositionWorld(3.0, -5.0, 7.0);
  const ImageAxes axes(this->Image);
  for (const int orientation : Orientations)
  {
    for (const bool isAlongImage : {true, false})
    {
      this->View->SetOrientation(orientation);
      this->View->SetAlongImage(isAlongImage);
      this->View->FitToImage();
      const RasterImage image = this->Draw();
      int inside = 0;
      for (int y = 0; y < Height; ++y)
      {
        for (int x = 0; x < Width; ++x)
        {
          const Vector3 index = axes.ToIndex(this->WorldAt(x, y));
          const Vector3 last(45.0, 60.0, 30.0);
          const std::uint8_t* pixel = PixelAt(image, x, y);
          if ((index.array() > 0.01).all() && ((last - index).array() > 0.01).all())
          {
            const double value = palpate::test::Ramp(this->WorldAt(x, y));
            // Rounding to 256 levels, and of single precision next to a half.
            ASSERT_NEAR(pixel[0], std::clamp(255.0 * (value + 50.0) / 300.0, 0.0, 255.0), 0.502)
                << x << ", " << y;
            ++inside;
          }
          else if ((index.array() < -0.51).any() || ((last - index).array() < -0.51).any())
          {
            ASSERT_EQ(pixel[0], 0) << x << ", " << y;
          }
        }
      }
      EXPECT_GT(inside, Width * Height / 4);
    }
  }
}

TEST_F(vtkSliceViewTest, PlanePassesThroughCrosshairAndFacesViewer)
{
  this->Crosshair->SetPositionWorld(12.0, 4.0, -9.0);
  for (const int orientation : Orientations)
  {
    this->View->SetOrientation(orientation);
    this->Draw();
    const palpate::SlicePosition position = this->View->GetPosition();
    // Rounding of numbers around 100.
    EXPECT_NEAR(position.HeightOver(Vector3(12.0, 4.0, -9.0)), 0.0, 1e-12);
    const Vector3 direction(this->Renderer->GetActiveCamera()->GetDirectionOfProjection());
    EXPECT_NEAR((direction + position.Frame.TowardsViewerWorld).norm(), 0.0, 1e-12);
  }
}

TEST_F(vtkSliceViewTest, NearestInterpolationShowsVoxelValues)
{
  this->Display->InterpolateOff();
  const RasterImage image = this->Draw();
  const ImageAxes axes(this->Image);
  int checked = 0;
  for (int y = 20; y < Height - 20; y += 3)
  {
    for (int x = 60; x < Width - 60; x += 3)
    {
      const Vector3 index = axes.ToIndex(this->WorldAt(x, y));
      const Vector3 voxel = index.array().round().matrix();
      const bool isInside =
          voxel.minCoeff() >= 0.0 && voxel.x() <= 45.0 && voxel.y() <= 60.0 && voxel.z() <= 30.0;
      if (isInside && (index - voxel).cwiseAbs().maxCoeff() < 0.499)
      {
        const double value = palpate::test::Ramp(axes.ToWorld(voxel));
        ASSERT_NEAR(PixelAt(image, x, y)[0], 255.0 * (value + 50.0) / 300.0, 0.502);
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 500);
}

TEST_F(vtkSliceViewTest, BlendsLabelsOverImage)
{
  vtkNew<vtkImageData> labels;
  labels->DeepCopy(this->Image);
  auto* values = static_cast<float*>(labels->GetScalarPointer());
  // 1 where the ramp is high, 2 elsewhere, and 2 has no colour.
  std::transform(values, values + labels->GetNumberOfPoints(), values,
                 [](float value) { return value > 100.0F ? 1.0F : 2.0F; });
  const int layer = this->Display->AddLabels(labels);
  this->Display->SetLabelColor(layer, 1, 1.0, 0.0, 0.0, 1.0);
  this->Display->SetLabelOpacity(0.5);
  const RasterImage image = this->Draw();
  const ImageAxes axes(labels);
  int painted = 0;
  for (int y = 40; y < Height - 40; ++y)
  {
    for (int x = 80; x < Width - 80; ++x)
    {
      const std::uint8_t* pixel = PixelAt(image, x, y);
      const double grey = 255.0 * (palpate::test::Ramp(this->WorldAt(x, y)) + 50.0) / 300.0;
      const Vector3 voxel = axes.ToIndex(this->WorldAt(x, y)).array().round().matrix();
      if (std::abs(palpate::test::Ramp(axes.ToWorld(voxel)) - 100.0) < 0.01)
      {
        continue;
      }
      const bool isLabelled = palpate::test::Ramp(axes.ToWorld(voxel)) > 100.0;
      // Two roundings to levels.
      ASSERT_NEAR(pixel[0], isLabelled ? 0.5 * grey + 127.5 : grey, 1.1);
      ASSERT_NEAR(pixel[1], isLabelled ? 0.5 * grey : grey, 1.1);
      painted += isLabelled ? 1 : 0;
    }
  }
  EXPECT_GT(painted, 1000);
  EXPECT_LT(painted, 7000);
}

TEST_F(vtkSliceViewTest, ContourLiesOnSurfaceAndPlane)
{
  const Vector3 center(5.0, -8.0, 4.0);
  const auto surface = SphereDisplay(center, 20.0);
  this->View->AddSurface(surface);
  for (const int orientation : Orientations)
  {
    this->View->SetOrientation(orientation);
    const RasterImage image = this->Draw();
    const palpate::SlicePosition position = this->View->GetPosition();
    const double height = position.HeightOver(center);
    const double radius = std::sqrt(400.0 - height * height);
    int green = 0;
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        if (IsGreen(PixelAt(image, x, y)))
        {
          const double distance = (this->WorldAt(x, y) - position.Projected(center)).norm();
          // A line of 1.5 points, to the pixel, along chords up to 0.02 mm inside.
          ASSERT_NEAR(distance, radius, 1.6 * position.PixelMillimeters + 0.02);
          ++green;
        }
      }
    }
    EXPECT_GT(green, 2.0 * M_PI * radius / position.PixelMillimeters * 0.8);
  }
}

TEST_F(vtkSliceViewTest, RemovedOrHiddenSurfaceHasNoContour)
{
  const auto surface = SphereDisplay(Vector3::Zero(), 20.0);
  const auto count = [this]
  {
    const RasterImage image = this->Draw();
    int green = 0;
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        green += IsGreen(PixelAt(image, x, y)) ? 1 : 0;
      }
    }
    return green;
  };
  this->View->AddSurface(surface);
  EXPECT_GT(count(), 50);
  surface->ContourVisibilityOff();
  EXPECT_EQ(count(), 0);
  surface->ContourVisibilityOn();
  EXPECT_GT(count(), 50);
  this->View->RemoveSurface(surface);
  EXPECT_EQ(count(), 0);
}

TEST_F(vtkSliceViewTest, UpdatesOnlyChanges)
{
  const auto surface = SphereDisplay(Vector3::Zero(), 20.0);
  this->View->AddSurface(surface);
  this->Draw();
  this->Draw();
  EXPECT_EQ(this->View->GetPaintCount(), 1);
  EXPECT_EQ(this->View->GetCutCount(), 1);
  this->View->Zoom(1.5, 10.0, 10.0);
  this->Draw();
  EXPECT_EQ(this->View->GetPaintCount(), 2);
  EXPECT_EQ(this->View->GetCutCount(), 1) << "the plane is the same";
  const Vector3 inPlane = this->WorldAt(30.0, 40.0);
  this->Crosshair->SetPositionWorld(inPlane.data());
  this->View->Scroll(1);
  this->Draw();
  EXPECT_EQ(this->View->GetPaintCount(), 3);
  EXPECT_EQ(this->View->GetCutCount(), 2);
  this->Display->SetWindowLevel(50.0, 80.0);
  this->Draw();
  EXPECT_EQ(this->View->GetPaintCount(), 4);
  EXPECT_EQ(this->View->GetCutCount(), 2);
}

TEST_F(vtkSliceViewTest, LinkedViewsShareThePoint)
{
  vtkNew<vtkSliceView> other;
  vtkNew<vtkRenderer> renderer;
  this->Window->AddRenderer(renderer);
  this->Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  other->SetRenderer(renderer);
  other->SetOrientation(vtkSliceView::CORONAL);
  other->SetImageDisplay(this->Display);
  other->SetCrosshair(this->Crosshair);
  this->Draw();
  this->View->MoveCrosshairTo(77.0, 101.0);
  const Vector3 point(this->Crosshair->GetPositionWorld());
  EXPECT_NEAR((point - this->WorldAt(77.0, 101.0)).norm(), 0.0, 1e-12);
  // Rounding of numbers around 100.
  EXPECT_NEAR(other->GetPosition().HeightOver(point), 0.0, 1e-11);
  other->MoveCrosshairTo(180.0, 20.0);
  EXPECT_NEAR(this->View->GetPosition().HeightOver(Vector3(this->Crosshair->GetPositionWorld())),
              0.0, 1e-11);
}

TEST_F(vtkSliceViewTest, WindowPositionsMatchCamera)
{
  this->Renderer->SetViewport(0.25, 0.5, 1.0, 1.0);
  this->View->Pan(13.0, -7.0);
  this->Draw();
  const Vector3 world = this->WorldAt(100.0, 120.0);
  this->Renderer->SetWorldPoint(world.x(), world.y(), world.z(), 1.0);
  this->Renderer->WorldToDisplay();
  const double* display = this->Renderer->GetDisplayPoint();
  // The pixel's centre; the camera computes in double precision.
  EXPECT_NEAR(display[0], 100.5, 1e-6);
  EXPECT_NEAR(display[1], 120.5, 1e-6);
}

TEST_F(vtkSliceViewTest, NeurologicalConventionMirrorsAxialAndCoronalSlices)
{
  const auto sphere = SphereDisplay(Vector3(15.0, 8.0, 10.0), 12.0);
  this->View->AddSurface(sphere);
  this->Crosshair->SetPositionWorld(15.0, 8.0, 10.0);
  for (const int orientation : Orientations)
  {
    this->View->SetOrientation(orientation);
    this->View->NeurologicalOff();
    this->View->FitToImage();
    const RasterImage radiological = this->Draw();
    const Vector3 left = this->WorldAt(0, 60);
    const int slice = this->View->GetSliceNumber();
    this->View->NeurologicalOn();
    const RasterImage neurological = this->Draw();
    const bool isMirrored = orientation != vtkSliceView::SAGITTAL;
    EXPECT_NEAR((this->WorldAt(isMirrored ? Width - 1 : 0, 60) - left).norm(), 0.0, 1e-9);
    EXPECT_EQ(this->View->GetSliceNumber(), slice);
    int green = 0;
    int greenInBoth = 0;
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        const std::uint8_t* before = PixelAt(radiological, x, y);
        const std::uint8_t* after = PixelAt(neurological, isMirrored ? Width - 1 - x : x, y);
        const bool areGreen = IsGreen(before) && IsGreen(after);
        green += IsGreen(before) ? 1 : 0;
        greenInBoth += areGreen ? 1 : 0;
        // Lines may be drawn a pixel beside.
        if (!IsGreen(before) && !IsGreen(after))
        {
          ASSERT_NEAR(before[0], after[0], 1.0) << orientation << ": " << x << ", " << y;
        }
      }
    }
    EXPECT_GT(green, 50);
    EXPECT_GT(greenInBoth, green / 3);
  }
}

TEST_F(vtkSliceViewTest, ZoomKeepsPointUnderPointerAndPanMovesIt)
{
  this->Draw();
  const Vector3 before = this->WorldAt(33.0, 44.0);
  const double pixel = this->View->GetPixelMillimeters();
  this->View->Zoom(2.5, 33.0, 44.0);
  EXPECT_NEAR((this->WorldAt(33.0, 44.0) - before).norm(), 0.0, 1e-11);
  EXPECT_NEAR(this->View->GetPixelMillimeters(), pixel / 2.5, 1e-12);
  this->View->Pan(10.0, -4.0);
  EXPECT_NEAR((this->WorldAt(43.0, 40.0) - before).norm(), 0.0, 1e-11);
  this->View->Zoom(0.0, 1.0, 1.0);
  this->View->Zoom(std::nan(""), 1.0, 1.0);
  EXPECT_NEAR((this->WorldAt(43.0, 40.0) - before).norm(), 0.0, 1e-11);
}

TEST_F(vtkSliceViewTest, CentresAPointThatIsOutOfView)
{
  this->Draw();
  const Vector3 before = this->View->GetPosition().CenterWorld;
  this->View->ShowPoint(this->WorldAt(40.0, 30.0).data());
  EXPECT_EQ(this->View->GetPosition().CenterWorld, before) << "it is in view";
  const Vector3 outside = this->WorldAt(-20.0, 50.0);
  this->View->ShowPoint(outside.data());
  EXPECT_NEAR((this->View->GetPosition().CenterWorld - outside).norm(), 0.0, 1e-9);
}

TEST_F(vtkSliceViewTest, ScrollsVolumeSlicesAndStopsAtEnds)
{
  const ImageAxes axes(this->Image);
  this->Crosshair->SetPositionWorld(1.0, 2.0, 3.0);
  EXPECT_EQ(this->View->GetNumberOfSlices(), 31);
  const int first = this->View->GetSliceNumber();
  this->View->Scroll(1);
  EXPECT_EQ(this->View->GetSliceNumber(), first + 1);
  const Vector3 index = axes.ToIndex(Vector3(this->Crosshair->GetPositionWorld()));
  EXPECT_NEAR(index.z(), std::round(index.z()), 1e-9); // on a slice's centre plane
  EXPECT_NEAR(index.z(), first, 1e-9);                 // numbers count from 1, indices from 0
  this->View->Scroll(1000);
  EXPECT_EQ(this->View->GetSliceNumber(), 31);
  this->View->Scroll(-1000);
  EXPECT_EQ(this->View->GetSliceNumber(), 1);
}

TEST_F(vtkSliceViewTest, ShowsLandmarksWithinReachOnly)
{
  vtkNew<vtkLandmarks> landmarks;
  landmarks->SetColor(0.0, 1.0, 0.0);
  landmarks->SetRadius(3.0);
  const palpate::SlicePosition position = this->View->GetPosition();
  const Vector3 normal = position.Frame.TowardsViewerWorld;
  const Vector3 near = position.CenterWorld + 2.0 * normal;
  landmarks->AddLandmark("near", near.data());
  this->View->SetLandmarks(landmarks);
  const auto radiusSeen = [this, &position]
  {
    const RasterImage image = this->Draw();
    double radius = 0.0;
    const Vector3 middle = this->View->GetPosition().Projected(position.CenterWorld);
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width / 2; ++x) // its name is on the right
      {
        if (IsGreen(PixelAt(image, x, y)))
        {
          radius = std::max(radius, (this->WorldAt(x, y) - middle).norm());
        }
      }
    }
    return radius;
  };
  this->View->Zoom(3.0, 0.5 * Width - 0.5, 0.5 * Height - 0.5);
  // The cross-section of a sphere of 3 mm at 2 mm; a line of two pixels of 0.25 mm, and half a
  // pixel diagonal.
  EXPECT_NEAR(radiusSeen(), std::sqrt(5.0), 0.5);
  const Vector3 away = -1.5 * normal; // now 3.5 mm off
  this->Crosshair->SetPositionWorld(away.data());
  EXPECT_EQ(radiusSeen(), 0.0);
}

// Oblique to the slice: as far to the right as above it.
TEST_F(vtkSliceViewTest, DrawsThePartOfACurveWithinReach)
{
  vtkNew<vtkLandmarks> landmarks;
  landmarks->SetColor(0.0, 1.0, 0.0);
  landmarks->SetRadius(3.0);
  const palpate::SlicePosition position = this->View->GetPosition();
  const Vector3 along = position.Frame.TowardsViewerWorld + position.Frame.RightWorld;
  const Vector3 right = position.Frame.RightWorld;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const double place : {-10.0, 4.0, 10.0})
  {
    points->InsertNextPoint(Vector3(position.CenterWorld + place * along).data());
  }
  ASSERT_TRUE(landmarks->AddCurve("", points->GetPoint(0), points, false));
  this->View->SetLandmarks(landmarks);
  this->View->Zoom(3.0, 0.5 * Width - 0.5, 0.5 * Height - 0.5);
  const RasterImage image = this->Draw();
  double least = 0.0;
  double most = 0.0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      if (IsGreen(PixelAt(image, x, y)))
      {
        const double place = (this->WorldAt(x, y) - position.CenterWorld).dot(right);
        least = std::min(least, place);
        most = std::max(most, place);
      }
    }
  }
  EXPECT_NEAR(least, -3.0, 0.5);
  EXPECT_NEAR(most, 3.0, 0.5);
}

TEST_F(vtkSliceViewTest, DrawsNothingWithoutContents)
{
  vtkNew<vtkSliceView> empty;
  vtkNew<vtkRenderer> renderer;
  this->Window->RemoveRenderer(this->Renderer);
  this->Window->AddRenderer(renderer);
  empty->SetRenderer(renderer);
  empty->AnnotationVisibilityOff();
  const RasterImage image = this->Draw();
  EXPECT_TRUE(std::all_of(image.Rgba.begin(), image.Rgba.end(),
                          [](std::uint8_t part) { return part == 0 || part == 255; }));
  empty->Scroll(3);
  EXPECT_EQ(empty->GetNumberOfSlices(), 0);
}

TEST_F(vtkSliceViewTest, ReleasedRendererIsEmpty)
{
  this->View->AddSurface(SphereDisplay(Vector3::Zero(), 9.0));
  this->Draw();
  this->View->SetRenderer(nullptr);
  EXPECT_EQ(this->Renderer->GetViewProps()->GetNumberOfItems(), 0);
  EXPECT_FALSE(this->Renderer->HasObserver(vtkCommand::StartEvent));
}

TEST_F(vtkSliceViewTest, MayOutliveItsWindow)
{
  this->View->AddSurface(SphereDisplay(Vector3::Zero(), 9.0));
  this->Draw();
  this->Window = nullptr;
  this->View->Update();
  this->View->SetRenderer(nullptr);
  EXPECT_EQ(this->Renderer->GetViewProps()->GetNumberOfItems(), 0);
}
} // namespace
} // namespace palpate::vtk_slice_view_test
