#include "vtkInteractorStyleSlice.h"

#include "SlicePosition.h"
#include "SliceViewTest.h"

#include "vtkCamera.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"

#include <gtest/gtest.h>

namespace palpate::vtk_interactor_style_slice_test
{
namespace
{
// VTK's interactor for this system needs a window on a display; tests send their events themselves.
class EventSender : public vtkRenderWindowInteractor
{
public:
  static EventSender* New();
  vtkTypeMacro(EventSender, vtkRenderWindowInteractor);
};
vtkStandardNewMacro(EventSender);

// A slice view at the left and another renderer at the right, with the style.
class vtkInteractorStyleSliceTest : public palpate::test::SliceViewTest
{
protected:
  void SetUp() override
  {
    SliceViewTest::SetUp();
    if (IsSkipped())
    {
      return;
    }
    this->Renderer->SetViewport(0.0, 0.0, 0.75, 1.0);
    this->Other->SetViewport(0.75, 0.0, 1.0, 1.0);
    this->Window->AddRenderer(this->Other);
    this->Style->AddView(this->View);
    this->Interactor->SetRenderWindow(this->Window);
    this->Interactor->SetInteractorStyle(this->Style);
    this->Interactor->Enable();
    this->Draw();
  }

  void Send(unsigned long event, int x, int y, bool isControl = false, const char* key = nullptr)
  {
    this->Interactor->SetEventInformation(x, y, isControl ? 1 : 0, 0,
                                          key == nullptr ? '\0' : key[0], 0, key);
    this->Interactor->InvokeEvent(event);
  }
  // Presses, moves and releases a button; its events follow each other in vtkCommand.
  void Drag(unsigned long press, int fromX, int fromY, int toX, int toY, bool isControl = false)
  {
    this->Send(press, fromX, fromY, isControl);
    this->Send(vtkCommand::MouseMoveEvent, (fromX + toX) / 2, (fromY + toY) / 2, isControl);
    this->Send(vtkCommand::MouseMoveEvent, toX, toY, isControl);
    this->Send(press + 1, toX, toY, isControl);
  }
  Vector3 Place() { return Vector3(this->Crosshair->GetPositionWorld()); }
  void ExpectCrosshairAt(int x, int y)
  {
    // Rounding of numbers around 100.
    EXPECT_NEAR((this->Place() - this->WorldAt(x, y)).norm(), 0.0, 1e-11);
  }

  vtkNew<vtkRenderer> Other;
  vtkNew<vtkInteractorStyleSlice> Style;
  vtkNew<EventSender> Interactor;
};

TEST_F(vtkInteractorStyleSliceTest, LeftDragMovesCrosshairWithPointer)
{
  this->Send(vtkCommand::LeftButtonPressEvent, 50, 60);
  this->ExpectCrosshairAt(50, 60);
  this->Send(vtkCommand::MouseMoveEvent, 80, 20);
  this->ExpectCrosshairAt(80, 20);
  this->Send(vtkCommand::LeftButtonReleaseEvent, 80, 20);
  this->Send(vtkCommand::MouseMoveEvent, 10, 10);
  this->ExpectCrosshairAt(80, 20);
}

TEST_F(vtkInteractorStyleSliceTest, DragBeyondViewStaysWithItsView)
{
  this->Drag(vtkCommand::LeftButtonPressEvent, 50, 60, 220, 90); // ends over the other renderer
  this->ExpectCrosshairAt(220, 90);
}

TEST_F(vtkInteractorStyleSliceTest, LeftDragChangesWindowAndLevelInThatMode)
{
  this->Style->SetLeftButtonMode(vtkInteractorStyleSlice::WINDOW_LEVEL);
  const Vector3 before = this->Place();
  this->Drag(vtkCommand::LeftButtonPressEvent, 50, 60, 80, 60);
  EXPECT_GT(this->Display->GetWindow(), 300.0);
  EXPECT_NEAR(this->Display->GetLevel(), 100.0, 1e-9); // from the window's ends, rounded
  this->Drag(vtkCommand::LeftButtonPressEvent, 50, 60, 50, 90);
  EXPECT_LT(this->Display->GetLevel(), 100.0) << "upwards is brighter";
  EXPECT_EQ(this->Place(), before);
}

TEST_F(vtkInteractorStyleSliceTest, ControlSwapsLeftDragMode)
{
  const Vector3 before = this->Place();
  this->Drag(vtkCommand::LeftButtonPressEvent, 50, 60, 80, 60, true);
  EXPECT_GT(this->Display->GetWindow(), 300.0);
  EXPECT_EQ(this->Place(), before);
  this->Style->SetLeftButtonMode(vtkInteractorStyleSlice::WINDOW_LEVEL);
  this->Drag(vtkCommand::LeftButtonPressEvent, 50, 60, 90, 30, true);
  this->ExpectCrosshairAt(90, 30);
}

TEST_F(vtkInteractorStyleSliceTest, DragBackRestoresWindow)
{
  this->Style->SetLeftButtonMode(vtkInteractorStyleSlice::WINDOW_LEVEL);
  this->Drag(vtkCommand::LeftButtonPressEvent, 50, 60, 81, 33);
  this->Drag(vtkCommand::LeftButtonPressEvent, 81, 33, 50, 60);
  EXPECT_NEAR(this->Display->GetWindow(), 300.0, 1e-9); // sums of a few numbers of that size
  EXPECT_NEAR(this->Display->GetLevel(), 100.0, 1e-9);
}

TEST_F(vtkInteractorStyleSliceTest, WheelScrollsSlices)
{
  const int slice = this->View->GetSliceNumber();
  this->Send(vtkCommand::MouseWheelForwardEvent, 60, 60);
  this->Send(vtkCommand::MouseWheelForwardEvent, 60, 60);
  EXPECT_EQ(this->View->GetSliceNumber(), slice + 2);
  this->Send(vtkCommand::MouseWheelBackwardEvent, 60, 60);
  EXPECT_EQ(this->View->GetSliceNumber(), slice + 1);
}

TEST_F(vtkInteractorStyleSliceTest, ControlWheelZoomsAroundPointer)
{
  const double pixel = this->View->GetPixelMillimeters();
  const Vector3 under = this->WorldAt(30, 50);
  const Vector3 before = this->Place();
  this->Send(vtkCommand::MouseWheelForwardEvent, 30, 50, true);
  EXPECT_LT(this->View->GetPixelMillimeters(), pixel);
  EXPECT_NEAR((this->WorldAt(30, 50) - under).norm(), 0.0, 1e-11);
  this->Send(vtkCommand::MouseWheelBackwardEvent, 30, 50, true);
  EXPECT_NEAR(this->View->GetPixelMillimeters(), pixel, 1e-12);
  EXPECT_EQ(this->Place(), before);
}

TEST_F(vtkInteractorStyleSliceTest, RightDragZoomsAroundItsStart)
{
  const double pixel = this->View->GetPixelMillimeters();
  const Vector3 under = this->WorldAt(40, 50);
  this->Drag(vtkCommand::RightButtonPressEvent, 40, 50, 44, 110);
  EXPECT_LT(this->View->GetPixelMillimeters(), 0.5 * pixel);
  EXPECT_NEAR((this->WorldAt(40, 50) - under).norm(), 0.0, 1e-11);
}

TEST_F(vtkInteractorStyleSliceTest, MiddleDragPans)
{
  const Vector3 under = this->WorldAt(40, 50);
  this->Drag(vtkCommand::MiddleButtonPressEvent, 40, 50, 71, 33);
  EXPECT_NEAR((this->WorldAt(71, 33) - under).norm(), 0.0, 1e-11);
}

TEST_F(vtkInteractorStyleSliceTest, ShiftMovesCrosshairWithoutButton)
{
  const Vector3 before = this->Place();
  this->Send(vtkCommand::MouseMoveEvent, 70, 40);
  EXPECT_EQ(this->Place(), before);
  this->Interactor->SetEventInformation(80, 20, 0, 1);
  this->Interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
  this->ExpectCrosshairAt(80, 20);
}

TEST_F(vtkInteractorStyleSliceTest, ShiftLeftDragPans)
{
  const Vector3 before = this->Place();
  const Vector3 under = this->WorldAt(40, 50);
  this->Interactor->SetEventInformation(40, 50, 0, 1);
  this->Interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent);
  this->Interactor->SetEventInformation(71, 33, 0, 1);
  this->Interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
  this->Interactor->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
  EXPECT_NEAR((this->WorldAt(71, 33) - under).norm(), 0.0, 1e-11);
  EXPECT_EQ(this->Place(), before);
}

TEST_F(vtkInteractorStyleSliceTest, ArrowsAndPagesScroll)
{
  this->View->Scroll(0);
  const int slice = this->View->GetSliceNumber();
  const auto press = [this](const char* key)
  { this->Send(vtkCommand::KeyPressEvent, 60, 60, false, key); };
  press("Up");
  press("Right");
  EXPECT_EQ(this->View->GetSliceNumber(), slice + 2);
  press("Down");
  press("Left");
  press("Left");
  EXPECT_EQ(this->View->GetSliceNumber(), slice - 1);
  press("Prior");
  EXPECT_EQ(this->View->GetSliceNumber(), slice + 9);
  press("Next");
  EXPECT_EQ(this->View->GetSliceNumber(), slice - 1);
}

TEST_F(vtkInteractorStyleSliceTest, OnlyKeyRActsAndFitsView)
{
  const double pixel = this->View->GetPixelMillimeters();
  this->View->Zoom(3.0, 10.0, 10.0);
  for (const char* key : {"e", "q", "p", "s", "w", "f"})
  {
    this->Send(vtkCommand::CharEvent, 60, 60, false, key);
  }
  EXPECT_FALSE(this->Interactor->GetDone());
  EXPECT_NEAR(this->View->GetPixelMillimeters(), pixel / 3.0, 1e-12);
  this->Send(vtkCommand::CharEvent, 60, 60, false, "r");
  EXPECT_NEAR(this->View->GetPixelMillimeters(), pixel, 1e-12);
}

TEST_F(vtkInteractorStyleSliceTest, OtherRenderersRotateCameraAndKeepCrosshair)
{
  const Vector3 before = this->Place();
  const Vector3 eye(this->Other->GetActiveCamera()->GetPosition());
  this->Drag(vtkCommand::LeftButtonPressEvent, 200, 60, 230, 90);
  EXPECT_GT((Vector3(this->Other->GetActiveCamera()->GetPosition()) - eye).norm(), 1e-3);
  EXPECT_EQ(this->Place(), before);
}

TEST_F(vtkInteractorStyleSliceTest, DrawsViewsThatShareCrosshair)
{
  vtkNew<vtkSliceView> coronal;
  coronal->SetOrientation(vtkSliceView::CORONAL);
  coronal->SetImageDisplay(this->Display);
  coronal->SetCrosshair(this->Crosshair);
  coronal->SetRenderer(this->Other);
  this->Draw();
  const int painted = coronal->GetPaintCount();
  this->Drag(vtkCommand::LeftButtonPressEvent, 50, 20, 50, 100);
  EXPECT_GT(coronal->GetPaintCount(), painted);
}
} // namespace
} // namespace palpate::vtk_interactor_style_slice_test
