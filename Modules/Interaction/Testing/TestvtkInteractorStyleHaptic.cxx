#include "vtkInteractorStyleHaptic.h"

#include "CameraAxes.h"
#include "DisplayTest.h"
#include "PlacedDevice.h"
#include "SafetyReport.h"
#include "SimulatedDevice.h"
#include "SteadyClock.h"
#include "vtkProbeRepresentation.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkTestErrorObserver.h"

#include <chrono>
#include <cmath>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace palpate::vtk_interactor_style_haptic_test
{
namespace
{
constexpr double SphereRadius = 20.0; // mm
constexpr double ToolRadius = 2.0;
constexpr int Side = 200; // pixels

// A sphere in a window, and the style on its interactor, in real time: the servo runs in parallel.
class StyleHapticTest : public test::DisplayTest
{
protected:
  using Style = vtkInteractorStyleHaptic;

  void SetUp() override
  {
    DisplayTest::SetUp();
    if (IsSkipped())
    {
      return;
    }
    this->Window = vtkSmartPointer<vtkRenderWindow>::New();
    this->Window->SetOffScreenRendering(1);
    this->Window->SetSize(Side, Side);
    this->Renderer = vtkSmartPointer<vtkRenderer>::New();
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->GetActiveCamera()->ParallelProjectionOn();
    this->Renderer->GetActiveCamera()->SetParallelScale(50.0); // half a mm per pixel
    this->LookFrom({0.0, 0.0, 1.0}, {0.0, 1.0, 0.0});
    this->Interactor = vtkSmartPointer<vtkGenericRenderWindowInteractor>::New();
    this->Interactor->SetRenderWindow(this->Window);
    this->Touch = vtkSmartPointer<Style>::New();
    this->Interactor->SetInteractorStyle(this->Touch);
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(SphereRadius);
    sphere->SetThetaResolution(60);
    sphere->SetPhiResolution(60);
    sphere->Update();
    this->Touch->SetToolRadius(ToolRadius);
    ASSERT_EQ(this->Touch->AddSurface(sphere->GetOutput(), 0.5), 0);
    this->Listen();
  }
  void TearDown() override
  {
    if (this->Touch != nullptr)
    {
      this->Touch->StopTouch();
    }
  }

  void LookFrom(const Vector3& towardsViewer, const Vector3& up)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const Vector3 eye = 200.0 * towardsViewer;
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetPosition(eye.data());
    camera->SetViewUp(up.data());
  }

  void Listen()
  {
    vtkNew<vtkCallbackCommand> listener;
    listener->SetClientData(this);
    listener->SetCallback(
        [](vtkObject*, unsigned long event, void* test, void* data)
        {
          auto* self = static_cast<StyleHapticTest*>(test);
          self->Events.push_back(event);
          if (event == Style::FaultEvent)
          {
            self->Message = static_cast<const char*>(data);
          }
        });
    for (unsigned long event = Style::ContactBeginEvent; event <= Style::FaultEvent; ++event)
    {
      this->Touch->AddObserver(event, listener);
    }
  }

  // Polls, like the timer, until it is so. The servo determines when; gives up after ten seconds.
  bool PollUntil(const std::function<bool()>& isSo)
  {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    do
    {
      this->Touch->Poll();
      if (isSo())
      {
        return true;
      }
      std::this_thread::yield();
    } while (std::chrono::steady_clock::now() < end);
    return false;
  }
  bool Comes(unsigned long event)
  {
    return this->PollUntil([&] { return !this->Events.empty() && this->Events.back() == event; });
  }

  Vector3 Probe() { return PlaceOf(this->Touch->GetProbe()->GetProbeMatrix()); }
  Vector3 Proxy() { return PlaceOf(this->Touch->GetProbe()->GetProxyMatrix()); }
  double Force() { return Vector3(this->Touch->GetProbe()->GetForce()).norm(); }
  static Vector3 PlaceOf(vtkMatrix4x4* matrix)
  {
    return {matrix->GetElement(0, 3), matrix->GetElement(1, 3), matrix->GetElement(2, 3)};
  }

  void MoveMouse(int right, int up)
  {
    this->Mouse[0] += right;
    this->Mouse[1] += up;
    this->Interactor->SetEventInformation(this->Mouse[0], this->Mouse[1]);
    this->Interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
  }
  void Wheel(unsigned long event, int notches)
  {
    for (int n = 0; n < notches; ++n)
    {
      this->Interactor->InvokeEvent(event);
    }
  }
  // Pushes what is under the pointer with some 2 N.
  void Press()
  {
    EXPECT_TRUE(this->Touch->GetHasRest());
    this->Interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent);
    this->Wheel(vtkCommand::MouseWheelForwardEvent, 8);
  }
  void Release() { this->Interactor->InvokeEvent(vtkCommand::LeftButtonReleaseEvent); }
  // Starts in front of the sphere, and moves the hand to its right.
  void StartNextToTheSphere()
  {
    ASSERT_TRUE(this->Touch->StartTouch());
    this->MoveMouse(70, 0);                              // 35 mm
    this->Wheel(vtkCommand::MouseWheelForwardEvent, 20); // 40 mm
    ASSERT_TRUE(this->PollUntil(
        [&] { return this->Probe().x() > 30.0 && std::abs(this->Probe().z()) < 2.0; }));
    this->Events.clear();
  }

  SteadyClock Time; // of devices, which live until the touch ends
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkGenericRenderWindowInteractor> Interactor;
  vtkSmartPointer<Style> Touch;
  std::vector<unsigned long> Events;
  std::string Message;
  int Mouse[2] = {Side / 2, Side / 2};
};

TEST_F(StyleHapticTest, MouseTouchesSurfacesOfWindow)
{
  this->StartNextToTheSphere();
  this->MoveMouse(-36, 0); // to 17 mm, over the sphere
  this->Press();
  ASSERT_TRUE(this->Comes(Style::ContactBeginEvent));
  ASSERT_TRUE(this->PollUntil([&] { return this->Force() > 0.5; }));
  // Facets lie up to 0.03 mm inside the sphere.
  EXPECT_NEAR(this->Proxy().norm(), SphereRadius + ToolRadius, 0.1);
  EXPECT_LT(this->Probe().norm(), SphereRadius + ToolRadius);
  EXPECT_TRUE(this->Touch->GetProbe()->GetInContact());
  this->Release();
  EXPECT_TRUE(this->Comes(Style::ContactEndEvent));
  EXPECT_TRUE(this->PollUntil([&] { return this->Force() == 0.0; }));
}

TEST_F(StyleHapticTest, WheelMovesInDepth)
{
  this->StartNextToTheSphere();
  const double before = this->Probe().z();
  this->Wheel(vtkCommand::MouseWheelForwardEvent, 6);
  EXPECT_TRUE(this->PollUntil([&] { return this->Probe().z() < before - 10.0; }));
  this->Wheel(vtkCommand::MouseWheelBackwardEvent, 6);
  EXPECT_TRUE(this->PollUntil([&] { return this->Probe().z() > before - 1.0; }));
}

TEST_F(StyleHapticTest, DeviceAxesEqualCameraAxesAtRest)
{
  this->StartNextToTheSphere();
  // Seen from the left with the head up: 35 mm to the viewer's right stays so.
  this->LookFrom({1.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
  EXPECT_TRUE(this->PollUntil([&] { return this->Probe().y() > 30.0; }));
  EXPECT_NEAR(this->Probe().x(), 0.0, 2.0); // the hand settles to within its friction
  this->MoveMouse(0, 60);
  EXPECT_TRUE(this->PollUntil([&] { return this->Probe().z() > 25.0; }));
}

TEST_F(StyleHapticTest, ClutchHoldsToolWithoutForce)
{
  auto owned = std::make_unique<test::PlacedDevice>(this->Time);
  test::PlacedDevice* device = owned.get();
  const auto move = [&](double from, double to)
  {
    for (double part = 0.0; part <= 1.0; part += 0.05) // no faster than a hand
    {
      device->Put({from + part * (to - from), 0.0, 0.0}, 0);
      std::this_thread::sleep_for(std::chrono::milliseconds(4));
    }
  };
  device->Put({25.0, 0.0, 0.0}, 0);
  ASSERT_TRUE(this->Touch->StartTouch(std::move(owned)));
  move(25.0, 15.0);
  ASSERT_TRUE(this->PollUntil([&] { return device->Force() > 0.5; }));
  device->Put({15.0, 0.0, 0.0}, 4);
  ASSERT_TRUE(this->Comes(Style::ButtonPressEvent));
  const Vector3 held = this->Probe();
  EXPECT_TRUE(this->PollUntil([&] { return device->Force() == 0.0; }));
  for (double x = 15.0; x > -15.0; x -= 0.5) // no faster than a hand
  {
    device->Put({x, 0.0, 0.0}, 4);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  this->Touch->Poll();
  EXPECT_EQ(this->Probe(), held);
  EXPECT_EQ(device->Force(), 0.0);
  device->Put({-15.0, 0.0, 0.0}, 0);
  ASSERT_TRUE(this->Comes(Style::ButtonReleaseEvent));
  // The sphere around the tool is silent until the tool has left it.
  EXPECT_TRUE(this->PollUntil([&] { return (this->Probe() - held).norm() < 1e-9; }));
  EXPECT_EQ(device->Force(), 0.0);
  move(-15.0, -5.0);
  move(-5.0, -15.0);
  EXPECT_TRUE(this->PollUntil([&] { return device->Force() > 0.5; }));
  EXPECT_LT(this->Proxy().x() - this->Probe().x(), 10.0); // pushed out to the same side
  EXPECT_GT(this->Proxy().x(), this->Probe().x());
}

TEST_F(StyleHapticTest, EscapeSwitchesForcesOffAndFSwitchesThemOn)
{
  this->StartNextToTheSphere();
  this->MoveMouse(-36, 0);
  this->Press();
  ASSERT_TRUE(this->PollUntil([&] { return this->Force() > 0.5; }));
  this->Interactor->SetKeySym("Escape");
  this->Interactor->InvokeEvent(vtkCommand::KeyPressEvent);
  ASSERT_TRUE(this->Comes(Style::FaultEvent));
  EXPECT_EQ(this->Message, Describe(SafetyFault::SwitchedOff));
  EXPECT_EQ(this->Touch->GetStatusText(), this->Message);
  EXPECT_EQ(this->Force(), 0.0);
  EXPECT_TRUE(this->Touch->IsTouching());
  this->Interactor->SetKeyCode('f');
  this->Interactor->InvokeEvent(vtkCommand::CharEvent);
  ASSERT_TRUE(
      this->PollUntil([&] { return this->Touch->GetStatusText() == Describe(SafetyFault::None); }));
  this->Release();
  this->MoveMouse(2, 0); // hovers
  this->Press();
  EXPECT_TRUE(this->PollUntil([&] { return this->Force() > 0.5; }));
  EXPECT_EQ(this->Touch->GetStatusText(), Describe(SafetyFault::None));
}

TEST_F(StyleHapticTest, LostDeviceRaisesFaultWithInstructions)
{
  auto owned = std::make_unique<SimulatedDevice>(this->Time, SimulatedSettings());
  SimulatedDevice* device = owned.get();
  ASSERT_TRUE(owned->Open().IsOk());
  ASSERT_TRUE(this->Touch->StartTouch(std::move(owned)));
  device->Inject(SimulatedFault::Unplugged);
  ASSERT_TRUE(this->Comes(Style::FaultEvent));
  EXPECT_NE(this->Message, "");
  EXPECT_EQ(this->Touch->GetStatusText(), device->Problem());
}

TEST_F(StyleHapticTest, AddsStructureWhileTouching)
{
  this->StartNextToTheSphere();
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(35.0, 25.0, 0.0);
  sphere->SetRadius(15.0);
  sphere->Update();
  EXPECT_EQ(this->Touch->AddSurface(sphere->GetOutput(), 0.3), 1);
  this->MoveMouse(0, 26); // 13 mm up
  this->Press();
  EXPECT_TRUE(this->Comes(Style::ContactBeginEvent));
  this->Touch->RemoveAllStructures();
  EXPECT_TRUE(this->Comes(Style::ContactEndEvent));
}

TEST_F(StyleHapticTest, DrawsToolWhileTouching)
{
  const int before = this->Renderer->GetViewProps()->GetNumberOfItems();
  this->StartNextToTheSphere();
  EXPECT_GT(this->Renderer->GetViewProps()->GetNumberOfItems(), before);
  this->Window->Render();
  this->Touch->StopTouch();
  EXPECT_EQ(this->Renderer->GetViewProps()->GetNumberOfItems(), before);
}

TEST_F(StyleHapticTest, RejectsInvalidRequestsWithMessage)
{
  vtkNew<vtkTest::ErrorObserver> errors;
  this->Touch->AddObserver(vtkCommand::ErrorEvent, errors);
  this->Touch->SetDeviceName("phantom");
  EXPECT_FALSE(this->Touch->StartTouch());
  EXPECT_NE(errors->GetErrorMessage().find("phantom"), std::string::npos);
  vtkNew<vtkPolyData> nothing;
  EXPECT_EQ(this->Touch->AddSurface(nothing, 1.0), -1);
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  EXPECT_EQ(this->Touch->AddSurface(sphere->GetOutput(), -1.0), -1);
  EXPECT_EQ(this->Touch->GetNumberOfStructures(), 1);
  this->Interactor->SetInteractorStyle(nullptr);
  this->Touch->SetDeviceName("simulated");
  EXPECT_FALSE(this->Touch->StartTouch());
  EXPECT_FALSE(this->Touch->IsTouching());
}

TEST_F(StyleHapticTest, LostWindowStopsTouch)
{
  this->StartNextToTheSphere();
  this->Interactor->SetInteractorStyle(nullptr);
  EXPECT_FALSE(this->Touch->IsTouching());
}

TEST(CameraAxes, AreRightHandedWhateverTheViewUp)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(3.0, -2.0, 5.0);
  camera->SetFocalPoint(-1.0, 0.5, 0.0);
  camera->SetViewUp(0.2, 0.3, 0.9); // not perpendicular to the view direction
  const Matrix3 axes = CameraAxes(camera);
  EXPECT_LT((axes.transpose() * axes - Matrix3::Identity()).norm(), 1e-14);
  EXPECT_NEAR(axes.determinant(), 1.0, 1e-14);
  EXPECT_GT(axes.col(2).dot(Vector3(4.0, -2.5, 5.0)), 0.0);
  EXPECT_GT(axes.col(1).dot(Vector3(0.2, 0.3, 0.9)), 0.0);
}
} // namespace
} // namespace palpate::vtk_interactor_style_haptic_test
