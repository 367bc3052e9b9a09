#pragma once

#include "DisplayTest.h"
#include "ImageAxes.h"
#include "RandomOrientation.h"
#include "WindowImage.h"
#include "vtkCrosshair.h"
#include "vtkImageDisplay.h"
#include "vtkSliceView.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <random>

namespace palpate::test
{
/// Values of an image that are a linear function of the world, which any interpolation reproduces.
inline double Ramp(const Vector3& world)
{
  return 100.0 + Vector3(0.6, -0.9, 0.7).dot(world);
}

/// Such an image of some 90 x 96 x 90 mm around the origin, on a grid rotated by `turn`.
inline vtkSmartPointer<vtkImageData> RampImage(const Matrix3& turn)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(46, 61, 31);
  image->SetSpacing(2.0, 1.6, 3.0);
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = turn;
  image->SetDirectionMatrix(rows.data());
  const Vector3 origin = -turn * Vector3(45.0, 48.0, 45.0);
  image->SetOrigin(origin.x(), origin.y(), origin.z());
  image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
  {
    double point[3];
    image->GetPoint(p, point);
    static_cast<float*>(image->GetScalarPointer())[p] = static_cast<float>(Ramp(Vector3(point)));
  }
  return image;
}

/// A rotation by 25 degrees about a skew axis: far from the body's axes, but each axis stays
/// nearest to its own.
inline Matrix3 SkewTurn()
{
  return Eigen::AngleAxisd(M_PI * 25.0 / 180.0, Vector3(1.0, 2.0, -1.0).normalized())
      .toRotationMatrix();
}

/// One slice view off screen, of an image on an oblique grid.
class SliceViewTest : public DisplayTest
{
protected:
  static constexpr int Width = 240;
  static constexpr int Height = 180;

  void SetUp() override
  {
    DisplayTest::SetUp();
    if (IsSkipped())
    {
      return;
    }
    this->Window = vtkSmartPointer<vtkRenderWindow>::New();
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(Width, Height);
    this->Renderer = vtkSmartPointer<vtkRenderer>::New();
    this->Window->AddRenderer(this->Renderer);
    this->Image = RampImage(SkewTurn());
    this->Display->SetImage(this->Image);
    this->Display->SetWindowLevel(300.0, 100.0);
    this->View->SetImageDisplay(this->Display);
    this->View->SetCrosshair(this->Crosshair);
    this->View->SetRenderer(this->Renderer);
    this->Crosshair->VisibilityOff();
    this->View->AnnotationVisibilityOff();
  }

  /// Rows count from below, as in the window.
  RasterImage Draw()
  {
    this->Window->Render();
    return ReadWindow(this->Window);
  }
  static const std::uint8_t* PixelAt(const RasterImage& raster, int x, int y)
  {
    return raster.Pixel(x, raster.Height - 1 - y);
  }
  Vector3 WorldAt(double x, double y)
  {
    Vector3 world;
    this->View->DisplayToWorld(x, y, world.data());
    return world;
  }

  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkImageData> Image;
  vtkNew<vtkImageDisplay> Display;
  vtkNew<vtkCrosshair> Crosshair;
  vtkNew<vtkSliceView> View;
};
} // namespace palpate::test
