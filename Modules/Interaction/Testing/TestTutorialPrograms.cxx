#include "DisplayTest.h"
#include "vtkInteractorStyleHaptic.h"

#include "vtkCallbackCommand.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkVersion.h"

#include <chrono>
#include <iostream>
#include <sstream>
#include <thread>

/// The unmodified program of Documentation/Tutorial; the build renames its main.
int TouchASurface(int argc, char** argv);

namespace palpate::tutorial_programs_test
{
namespace
{
// An interactor with a simulated user: pushes the hand in depth until contact, and pulls it back
// until release; gives up after ten seconds.
class PushingInteractor : public vtkGenericRenderWindowInteractor
{
public:
  static PushingInteractor* New();
  vtkTypeMacro(PushingInteractor, vtkGenericRenderWindowInteractor);

  void Start() override
  {
    using Haptic = vtkInteractorStyleHaptic;
    vtkNew<vtkCallbackCommand> count;
    count->SetClientData(this);
    count->SetCallback([](vtkObject*, unsigned long event, void* self, void*)
                       { static_cast<PushingInteractor*>(self)->Last = event; });
    this->GetInteractorStyle()->AddObserver(Haptic::ContactBeginEvent, count);
    this->GetInteractorStyle()->AddObserver(Haptic::ContactEndEvent, count);
    this->Wheel(vtkCommand::MouseWheelForwardEvent, Haptic::ContactBeginEvent);
    this->Wheel(vtkCommand::MouseWheelBackwardEvent, Haptic::ContactEndEvent);
    this->GetInteractorStyle()->RemoveObserver(count);
  }

private:
  void Wheel(unsigned long event, unsigned long until)
  {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (this->Last != until && std::chrono::steady_clock::now() < end)
    {
      this->InvokeEvent(event);
      this->InvokeEvent(vtkCommand::TimerEvent);
      std::this_thread::yield();
    }
  }

  unsigned long Last = 0;
};
vtkStandardNewMacro(PushingInteractor);

class PushingFactory : public vtkObjectFactory
{
public:
  static PushingFactory* New();
  vtkTypeMacro(PushingFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "Interactors with a simulated user."; }

protected:
  PushingFactory()
  {
    this->RegisterOverride("vtkRenderWindowInteractor", "PushingInteractor", "", 1,
                           []() -> vtkObject* { return PushingInteractor::New(); });
  }
};
vtkStandardNewMacro(PushingFactory);

class TutorialStyleTest : public palpate::test::DisplayTest
{
protected:
  void SetUp() override
  {
    DisplayTest::SetUp();
    vtkObjectFactory::SetAllEnableFlags(0, "vtkRenderWindowInteractor");
    vtkObjectFactory::RegisterFactory(this->Factory);
    this->Console = std::cout.rdbuf(this->Said.rdbuf());
  }
  void TearDown() override
  {
    std::cout.rdbuf(this->Console);
    vtkObjectFactory::UnRegisterFactory(this->Factory);
    vtkObjectFactory::SetAllEnableFlags(1, "vtkRenderWindowInteractor");
  }

  vtkNew<PushingFactory> Factory;
  std::ostringstream Said;
  std::streambuf* Console = nullptr;
};

TEST_F(TutorialStyleTest, TouchASurfaceReportsContactAndRelease)
{
  std::string name = "TouchASurface";
  char* arguments[] = {name.data(), nullptr};
  EXPECT_EQ(TouchASurface(1, arguments), 0);
  const std::string said = this->Said.str();
  const std::size_t touched = said.find("touched\n");
  EXPECT_NE(touched, std::string::npos) << said;
  EXPECT_NE(said.find("let go\n", touched), std::string::npos) << said;
  EXPECT_EQ(said.find("Forces"), std::string::npos) << said;
}

TEST_F(TutorialStyleTest, TouchASurfaceFailsWithoutItsDevice)
{
  std::string name = "TouchASurface";
  std::string device = "phantom";
  char* arguments[] = {name.data(), device.data(), nullptr};
  EXPECT_NE(TouchASurface(2, arguments), 0);
  EXPECT_EQ(this->Said.str(), "");
}
} // namespace
} // namespace palpate::tutorial_programs_test
