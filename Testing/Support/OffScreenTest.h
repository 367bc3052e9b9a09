#pragma once

#include "DisplayTest.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

namespace palpate::test
{
/// Tests that draw into a square window off screen, without smooth edges. A test whose SetUp begins
/// with this one's returns where IsSkipped() holds.
class OffScreenTest : public DisplayTest
{
protected:
  /// `side` in pixels.
  explicit OffScreenTest(int side) : WindowSide(side) {}

  void SetUp() override
  {
    DisplayTest::SetUp();
    if (IsSkipped())
    {
      return;
    }
    this->Renderer = vtkSmartPointer<vtkRenderer>::New();
    this->Window = vtkSmartPointer<vtkRenderWindow>::New();
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(this->WindowSide, this->WindowSide);
    this->Window->AddRenderer(this->Renderer);
  }

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;

private:
  int WindowSide;
};
} // namespace palpate::test
