#include "ControllerDevice.h"

#include "DeviceContract.h"
#include "ManualClock.h"
#include "SdlLibrary.h"
#include "SteadyClock.h"
#include "TouchState.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <dlfcn.h>
#include <thread>

namespace palpate::controller_device_test
{
namespace
{
/// SDL's own virtual joystick (wiki.libsdl.org, SDL_JoystickAttachVirtualEx): what it is told by
/// SDL about rumble, and what a test sets of its axes, goes through the real library.
class VirtualController
{
public:
  struct Turned
  {
    std::atomic<int> Slow{0};
    std::atomic<int> Fast{0};
    std::atomic<int> Calls{0};
  };

  explicit VirtualController(Turned& turned)
  {
    this->Find("SDL_JoystickAttachVirtualEx", this->Attach);
    this->Find("SDL_JoystickDetachVirtual", this->Detach);
    this->Find("SDL_JoystickOpen", this->Open);
    this->Find("SDL_JoystickClose", this->Close);
    this->Find("SDL_JoystickSetVirtualAxis", this->SetAxisOf);
    this->Find("SDL_JoystickSetVirtualButton", this->SetButtonOf);
    this->Describe(turned);
    this->Index = this->Attach(&this->Description);
    EXPECT_GE(this->Index, 0);
    this->Joystick = this->Open(this->Index);
  }
  ~VirtualController() { this->Unplug(); }

  void SetAxis(int axis, std::int16_t value) { this->SetAxisOf(this->Joystick, axis, value); }
  void SetButton(int button, bool isDown) { this->SetButtonOf(this->Joystick, button, isDown); }
  void Unplug()
  {
    if (this->Index >= 0)
    {
      this->Close(this->Joystick);
      this->Detach(this->Index);
      this->Index = -1;
    }
  }

private:
  struct VirtualJoystick // SDL_VirtualJoystickDesc of SDL 2.24 and later
  {
    std::uint16_t Version, Type, AxisCount, ButtonCount, HatCount, Vendor, Product, Padding;
    std::uint32_t ButtonMask, AxisMask;
    const char* Name;
    void* UserData;
    void (*Update)(void*);
    void (*SetPlayerIndex)(void*, int);
    int (*Rumble)(void*, std::uint16_t, std::uint16_t);
    int (*RumbleTriggers)(void*, std::uint16_t, std::uint16_t);
    int (*SetLed)(void*, std::uint8_t, std::uint8_t, std::uint8_t);
    int (*SendEffect)(void*, const void*, int);
  };

  template <typename Function>
  void Find(const char* name, Function& function)
  {
    void* const library = dlopen("libSDL2-2.0.so.0", RTLD_NOW);
    function = reinterpret_cast<Function>(dlsym(library, name));
    ASSERT_NE(function, nullptr) << name;
  }
  void Describe(Turned& turned)
  {
    this->Description.Version = 1;
    this->Description.Type = 1; // a game controller
    this->Description.AxisCount = SdlLibrary::AxisCount;
    this->Description.ButtonCount = SdlLibrary::ButtonCount;
    this->Description.ButtonMask = (1u << SdlLibrary::ButtonCount) - 1;
    this->Description.AxisMask = (1u << SdlLibrary::AxisCount) - 1;
    this->Description.Name = "Virtual pad";
    this->Description.UserData = &turned;
    this->Description.Rumble = [](void* data, std::uint16_t slow, std::uint16_t fast)
    {
      auto& told = *static_cast<Turned*>(data);
      told.Slow = slow;
      told.Fast = fast;
      ++told.Calls;
      return 0;
    };
  }

  VirtualJoystick Description{};
  int Index = -1;
  void* Joystick = nullptr;
  int (*Attach)(const VirtualJoystick*) = nullptr;
  int (*Detach)(int) = nullptr;
  void* (*Open)(int) = nullptr;
  void (*Close)(void*) = nullptr;
  int (*SetAxisOf)(void*, int, std::int16_t) = nullptr;
  int (*SetButtonOf)(void*, int, std::uint8_t) = nullptr;
};

class ControllerTest : public testing::Test
{
protected:
  void SetUp() override
  {
    if (!SdlLibrary::Load(this->Sdl).IsOk())
    {
      GTEST_SKIP() << "without SDL 2";
    }
    ASSERT_TRUE(this->Sdl->Begin().IsOk());
    this->HasBegun = true;
    this->Pad.emplace(this->Turned);
    ASSERT_TRUE(RegisterControllerDevices(this->Registry).IsOk());
    ASSERT_TRUE(this->Registry.Make("controller", this->Time, this->Device).IsOk());
  }
  void TearDown() override
  {
    this->Device.reset();
    this->Pad.reset();
    if (this->HasBegun)
    {
      this->Sdl->End();
    }
  }
  /// Reads once a millisecond until it is true, at most for some seconds.
  template <typename Condition>
  bool ReadUntil(const Condition& isTrue)
  {
    for (int n = 0; n < 5000; ++n)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      this->IsRead = this->Device->Read(this->Sample);
      if (isTrue())
      {
        return true;
      }
    }
    return false;
  }

  std::shared_ptr<const SdlLibrary> Sdl;
  bool HasBegun = false;
  VirtualController::Turned Turned;
  std::optional<VirtualController> Pad;
  SteadyClock Time;
  DeviceRegistry Registry;
  std::unique_ptr<HapticDevice> Device;
  DeviceSample Sample;
  bool IsRead = false;
};

TEST_F(ControllerTest, KeepsTheContractOfDevices)
{
  test::ExpectDeviceContract(*this->Device,
                             [] { std::this_thread::sleep_for(std::chrono::milliseconds(2)); });
}

TEST_F(ControllerTest, IsListedByItsName)
{
  std::vector<FoundDevice> found;
  ASSERT_TRUE(this->Registry.Kinds().front().FindDevices(this->Time, found).IsOk());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found.front().Argument, "1");
  EXPECT_EQ(found.front().Details, "Virtual pad");
  EXPECT_TRUE(found.front().IsUsable);
}

TEST_F(ControllerTest, LeftStickMovesTheHandAndButtonsArePassedOn)
{
  ASSERT_TRUE(this->Device->Open().IsOk());
  this->Pad->SetAxis(0, 20000);
  this->Pad->SetAxis(1, -20000); // up
  this->Pad->SetButton(1, true);
  EXPECT_TRUE(this->ReadUntil(
      [&] { return this->Sample.Position.X > 2.0 && this->Sample.Position.Y > 2.0; }));
  EXPECT_EQ(this->Sample.Buttons, 2u);
  EXPECT_NEAR(this->Sample.Position.Z, 36.0, 1e-6) << "triggers rest at their middle or their end";
}

TEST_F(ControllerTest, MotorsTurnWhileItTouchesAndStopWhenClosed)
{
  ASSERT_TRUE(this->Device->Open().IsOk());
  TouchState touched;
  touched.Structure = 0;
  touched.ForceDevice = Vector3(0.0, 0.0, 3.0);
  touched.Depth = 2.0;
  this->Device->Show(touched);
  EXPECT_TRUE(this->ReadUntil([&] { return this->Turned.Slow > 30000; }));
  this->Device->Show(TouchState());
  EXPECT_TRUE(this->ReadUntil([&] { return this->Turned.Slow == 0; }));
  this->Device->Show(touched);
  EXPECT_TRUE(this->ReadUntil([&] { return this->Turned.Slow > 30000; }));
  this->Device->Close();
  EXPECT_EQ(this->Turned.Slow, 0);
}

TEST_F(ControllerTest, UnpluggedOneIsAnError)
{
  ASSERT_TRUE(this->Device->Open().IsOk());
  this->Pad->Unplug();
  EXPECT_TRUE(this->ReadUntil([&] { return !this->IsRead; }));
  EXPECT_EQ(this->Device->State(), DeviceState::Error);
  EXPECT_NE(this->Device->Problem().find("unplugged"), std::string::npos);
  this->Device->Close();
  const Status status = this->Device->Open();
  EXPECT_EQ(status.Message(), "No game controller is plugged in: plug one in, or pair it.");
}

TEST_F(ControllerTest, NumbersThatAreNoneAreRefused)
{
  std::unique_ptr<HapticDevice> other;
  for (const char* text : {"controller:0", "controller:-1", "controller:two", "controller:1.5"})
  {
    EXPECT_FALSE(this->Registry.Make(text, this->Time, other).IsOk()) << text;
  }
  ASSERT_TRUE(this->Registry.Make("controller:2", this->Time, other).IsOk());
  EXPECT_EQ(other->Open().Message(), "There is no game controller 2.");
}
} // namespace
} // namespace palpate::controller_device_test
