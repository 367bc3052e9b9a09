#include "DisplayTest.h"
#include "Vector3.h"
#include "vtkInteractorStyleMouseHand.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::vtk_interactor_style_mouse_hand_test
{
namespace
{
constexpr double Notch = 0.2; // mm, a fiftieth of the view's height

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
  this->Send(vtkCommand::MouseWheelForwardEvent, 100, 50);
  this->Send(vtkCommand::MouseWheelForwardEvent, 100, 50);
  this->Send(vtkCommand::MouseWheelBackwardEvent, 100, 50);
  EXPECT_LT((this->Hand() - Vector3(0.0, 0.0, -Notch)).norm(), 1e-9);
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
  const double height = 200.0 * std::tan(15.0 * M_PI / 180.0);
  EXPECT_NEAR((this->Hand() - before).norm(), height / 50.0, 1e-6);
}

// What can be touched: a plate at z = 5 on the right half of the view, with the tool 1 mm above it.
class MouseHandPressTest : public MouseHandStyleTest
{
protected:
  void SetUp() override
  {
    MouseHandStyleTest::SetUp();
    this->Style->AddObserver(vtkInteractorStyleMouseHand::AimedEvent, this,
                             &MouseHandPressTest::Answer);
    this->Style->AddObserver(vtkInteractorStyleMouseHand::PressedEvent, this,
                             &MouseHandPressTest::CountPress);
    this->Style->AddObserver(vtkInteractorStyleMouseHand::LiftedEvent, this,
                             &MouseHandPressTest::CountLift);
    this->Style->SetMostPush(4.0);
  }
  void Answer()
  {
    const double* from = this->Style->GetSightFrom();
    EXPECT_GT(from[2], this->Style->GetSightTo()[2]);
    if (from[0] > 0.0)
    {
      const double rest[3] = {from[0], from[1], 6.0};
      this->Style->SetRest(rest, this->Normal.data());
    }
  }
  void CountPress() { ++this->Presses; }
  void CountLift() { ++this->Lifts; }
  void Wait(int intervals)
  {
    for (int i = 0; i < intervals; ++i)
    {
      this->Interactor->InvokeEvent(vtkCommand::TimerEvent);
    }
  }

  Vector3 Normal = Vector3::UnitZ();
  int Presses = 0;
  int Lifts = 0;
};

TEST_F(MouseHandPressTest, ToolRestsOnTheSurfaceUnderThePointer)
{
  this->Send(vtkCommand::MouseMoveEvent, 130, 40);
  EXPECT_LT((this->Hand() - Vector3(3.0, -1.0, 6.0)).norm(), 0.08);
  EXPECT_EQ(this->Presses, 0);
}

TEST_F(MouseHandPressTest, HeldPressPushesHarderUpToTheStrongest)
{
  this->Send(vtkCommand::LeftButtonPressEvent, 130, 40);
  EXPECT_EQ(this->Presses, 1);
  const double first = this->Hand().z();
  EXPECT_LT(first, 6.0);
  this->Wait(20);
  EXPECT_LT(this->Hand().z(), first);
  this->Wait(500);
  EXPECT_NEAR(this->Hand().z(), 2.0, 1e-9) << "the strongest push";
  EXPECT_EQ(this->Presses, 1);
}

TEST_F(MouseHandPressTest, StrokeKeepsThePushAndReleaseLifts)
{
  this->Send(vtkCommand::LeftButtonPressEvent, 130, 40);
  this->Wait(20);
  const double pressed = this->Hand().z();
  this->Send(vtkCommand::MouseMoveEvent, 160, 60);
  EXPECT_LT((this->Hand() - Vector3(6.0, 1.0, pressed)).norm(), 0.08);
  this->Send(vtkCommand::MouseMoveEvent, 40, 60);
  EXPECT_LT((this->Hand() - Vector3(6.0, 1.0, pressed)).norm(), 0.08) << "waits at the edge";
  this->Send(vtkCommand::LeftButtonReleaseEvent, 160, 60);
  EXPECT_NEAR(this->Hand().z(), 6.0, 1e-9);
  EXPECT_EQ(this->Lifts, 1);
  this->Wait(20);
  EXPECT_NEAR(this->Hand().z(), 6.0, 1e-9) << "no longer pushed";
}

TEST_F(MouseHandPressTest, WheelAndPenPushWithoutAButton)
{
  this->Send(vtkCommand::MouseMoveEvent, 130, 40);
  this->Send(vtkCommand::MouseWheelForwardEvent, 130, 40);
  this->Send(vtkCommand::MouseWheelForwardEvent, 130, 40);
  EXPECT_NEAR(this->Hand().z(), 6.0 - 2.0 * 0.05 * 4.0, 1e-9);
  EXPECT_EQ(this->Presses, 1);
  for (int notch = 0; notch < 3; ++notch)
  {
    this->Send(vtkCommand::MouseWheelBackwardEvent, 130, 40);
  }
  EXPECT_EQ(this->Lifts, 1);
  EXPECT_NEAR(this->Hand().z(), 6.0, 1e-9);
  this->Style->SetPush(0.5);
  EXPECT_NEAR(this->Hand().z(), 4.0, 1e-9);
  this->Style->SetPush(0.0);
  EXPECT_EQ(this->Lifts, 2);
}

TEST_F(MouseHandPressTest, ArrowsAimAndTheSpaceBarPushes)
{
  const auto key = [this](unsigned long event, const char* name)
  {
    this->Interactor->SetKeyEventInformation(0, 0, 0, 0, name);
    this->Interactor->InvokeEvent(event);
  };
  for (int n = 0; n < 31; ++n) // to the view's middle, then by a pixel each
  {
    key(vtkCommand::KeyPressEvent, "Right");
  }
  EXPECT_EQ(this->Interactor->GetEventPosition()[0], 130);
  EXPECT_EQ(this->Presses, 0);
  key(vtkCommand::KeyPressEvent, "space");
  EXPECT_EQ(this->Presses, 1);
  const double first = this->Hand().z();
  this->Wait(20);
  EXPECT_LT(this->Hand().z(), first);
  key(vtkCommand::KeyReleaseEvent, "space");
  EXPECT_EQ(this->Lifts, 1);
}

TEST_F(MouseHandPressTest, LeavingTheViewAndLiftEndAPush)
{
  this->Send(vtkCommand::LeftButtonPressEvent, 130, 40);
  this->Send(vtkCommand::LeaveEvent, 130, 40);
  EXPECT_EQ(this->Lifts, 1);
  this->Send(vtkCommand::LeftButtonPressEvent, 130, 40);
  this->Style->Lift();
  EXPECT_EQ(this->Lifts, 2);
  EXPECT_FALSE(this->Style->IsPressed());
}

TEST_F(MouseHandPressTest, PressBesideTheSurfaceTurnsTheCamera)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  this->Send(vtkCommand::LeftButtonPressEvent, 60, 50);
  this->Send(vtkCommand::MouseMoveEvent, 20, 50);
  this->Send(vtkCommand::LeftButtonReleaseEvent, 20, 50);
  EXPECT_GT((Vector3(camera->GetPosition()) - Vector3(0.0, 0.0, 100.0)).norm(), 1.0);
  EXPECT_EQ(this->Presses, 0);
}

TEST_F(MouseHandPressTest, PushesAlongTheNormalOrTheLineOfSight)
{
  this->Normal = Vector3(0.6, 0.0, 0.8);
  this->Send(vtkCommand::LeftButtonPressEvent, 130, 40);
  this->Wait(500);
  const Vector3 rest(this->Hand() + 4.0 * this->Normal);
  EXPECT_NEAR(rest.z(), 6.0, 1e-9);
  this->Style->Lift();
  this->Style->PushAlongSightOn();
  this->Send(vtkCommand::LeftButtonPressEvent, 130, 40);
  this->Wait(500);
  EXPECT_LT((this->Hand() - (rest - Vector3(0.0, 0.0, 4.0))).norm(), 1e-9);
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
  this->Send(vtkCommand::MouseWheelForwardEvent, 100, 50);
  EXPECT_LT((Vector3(this->Style->GetDraggedWorld()) - Vector3(4.0, 0.0, 20.0 - Notch)).norm(),
            1e-9);
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
