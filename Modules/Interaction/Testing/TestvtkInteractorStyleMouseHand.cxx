#include "DisplayTest.h"
#include "Vector3.h"
#include "vtkInteractorStyleMouseHand.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::vtk_interactor_style_mouse_hand_test
{
namespace
{
// A camera 100 mm in front of the origin that looks along -z; parallel, so that a pixel is a tenth
// of a millimetre everywhere.
class MouseHandStyleTest : public test::DisplayTest
{
protected:
  void SetUp() override
  {
    DisplayTest::SetUp();
    if (IsSkipped())
    {
      return;
    }
    this->Window->SetOffScreenRendering(1);
    this->Window->SetSize(200, 100);
    this->Window->AddRenderer(this->Renderer);
    this->Interactor->SetRenderWindow(this->Window);
    this->Interactor->SetInteractorStyle(this->Style);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 100.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(5.0);
    camera->SetClippingRange(1.0, 200.0);
    this->Window->Render();
    this->Style->AddObserver(vtkInteractorStyleMouseHand::HandMovedEvent, this,
                             &MouseHandStyleTest::Count);
    this->Style->AddObserver(vtkInteractorStyleMouseHand::DragEndEvent, this,
                             &MouseHandStyleTest::Count);
    this->Style->HandOn();
  }
  void Count() { ++this->Moves; }
  void Send(unsigned long event, int x, int y, bool hasControl = false)
  {
    this->Interactor->SetEventInformation(x, y, hasControl ? 1 : 0, 0);
    this->Interactor->InvokeEvent(event);
  }
  Vector3 Hand() { return Vector3(this->Style->GetHandWorld()); }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkInteractorStyleMouseHand> Style;
  int Moves = 0;
};

TEST_F(MouseHandStyleTest, PointerMovesHandInItsScreenPlane)
{
  const double start[3] = {0.0, 0.0, 20.0};
  this->Style->SetHandWorld(start);
  this->Send(vtkCommand::MouseMoveEvent, 130, 40);
  // Pixel 100 of 200 is the centre; within half a pixel of rounding.
  EXPECT_NEAR(this->Hand().x(), 3.0, 0.051);
  EXPECT_NEAR(this->Hand().y(), -1.0, 0.051);
  // The depth goes through a normalised coordinate and back, in double precision.
  EXPECT_NEAR(this->Hand().z(), 20.0, 1e-9);
  EXPECT_EQ(this->Moves, 1);
}

TEST_F(MouseHandStyleTest, WheelMovesHandAlongLineOfSight)
{
  this->Style->SetNotchMillimeters(0.5);
  this->Send(vtkCommand::MouseWheelForwardEvent, 100, 50);
  this->Send(vtkCommand::MouseWheelForwardEvent, 100, 50);
  this->Send(vtkCommand::MouseWheelBackwardEvent, 100, 50);
  EXPECT_LT((this->Hand() - Vector3(0.0, 0.0, -0.5)).norm(), 1e-12);
  EXPECT_EQ(this->Moves, 3);
}

TEST_F(MouseHandStyleTest, PerspectiveKeepsHandUnderPointer)
{
  this->Renderer->GetActiveCamera()->ParallelProjectionOff();
  this->Renderer->GetActiveCamera()->SetViewAngle(30.0);
  this->Send(vtkCommand::MouseMoveEvent, 130, 40);
  const Vector3 before = this->Hand();
  this->Send(vtkCommand::MouseWheelForwardEvent, 130, 40);
  const Vector3 eye(0.0, 0.0, 100.0);
  EXPECT_LT((this->Hand() - eye).normalized().cross((before - eye).normalized()).norm(), 1e-12);
  EXPECT_NEAR((this->Hand() - before).norm(), this->Style->GetNotchMillimeters(), 1e-9);
}

TEST_F(MouseHandStyleTest, DragMovesObjectInItsPlaneAndKeepsHand)
{
  const double start[3] = {1.0, 2.0, 20.0};
  this->Style->SetDraggedWorld(start);
  this->Style->DraggingOn();
  this->Send(vtkCommand::MouseMoveEvent, 110, 60);
  this->Send(vtkCommand::LeftButtonPressEvent, 110, 60);
  this->Send(vtkCommand::MouseMoveEvent, 120, 50);
  this->Send(vtkCommand::MouseMoveEvent, 140, 40);
  EXPECT_EQ(this->Moves, 0);
  this->Send(vtkCommand::LeftButtonReleaseEvent, 140, 40);
  EXPECT_EQ(this->Moves, 1);
  this->Send(vtkCommand::MouseMoveEvent, 20, 20);
  const Vector3 dragged(this->Style->GetDraggedWorld());
  // 30 pixels to the right and 20 down, a tenth of a millimetre each; the depth goes through a
  // normalised coordinate and back.
  EXPECT_LT((dragged - Vector3(4.0, 0.0, 20.0)).norm(), 1e-9);
  EXPECT_EQ(this->Hand(), Vector3(Vector3::Zero()));
  this->Style->SetNotchMillimeters(0.5);
  this->Send(vtkCommand::MouseWheelForwardEvent, 100, 50);
  EXPECT_LT((Vector3(this->Style->GetDraggedWorld()) - Vector3(4.0, 0.0, 19.5)).norm(), 1e-9);
}

TEST_F(MouseHandStyleTest, ControlMovesCameraInsteadOfHand)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  this->Send(vtkCommand::LeftButtonPressEvent, 100, 50, true);
  this->Send(vtkCommand::MouseMoveEvent, 140, 50, true);
  this->Send(vtkCommand::LeftButtonReleaseEvent, 140, 50, true);
  EXPECT_GT((Vector3(camera->GetPosition()) - Vector3(0.0, 0.0, 100.0)).norm(), 1.0);
  const double scale = camera->GetParallelScale();
  this->Send(vtkCommand::MouseWheelForwardEvent, 100, 50, true);
  EXPECT_LT(camera->GetParallelScale(), scale);
  EXPECT_EQ(this->Moves, 0);
}

TEST_F(MouseHandStyleTest, IsTrackballWithoutHand)
{
  this->Style->HandOff();
  this->Send(vtkCommand::MouseMoveEvent, 130, 40);
  this->Send(vtkCommand::LeftButtonPressEvent, 100, 50);
  this->Send(vtkCommand::MouseMoveEvent, 140, 50);
  this->Send(vtkCommand::LeftButtonReleaseEvent, 140, 50);
  EXPECT_GT(
      (Vector3(this->Renderer->GetActiveCamera()->GetPosition()) - Vector3(0.0, 0.0, 100.0)).norm(),
      1.0);
  EXPECT_EQ(this->Moves, 0);
}

TEST_F(MouseHandStyleTest, IgnoresNonFinitePosition)
{
  const double bad[3] = {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0};
  this->Style->SetHandWorld(bad);
  EXPECT_EQ(this->Hand(), Vector3::Zero());
}
} // namespace
} // namespace palpate::vtk_interactor_style_mouse_hand_test
