#include "OpenHapticsArm.h"

#include "ClampedLength.h"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>
#include <utility>

namespace palpate
{
namespace
{
// Of the HDAPI's reference.
constexpr unsigned NoDevice = 0xFFFFFFFF;
constexpr unsigned CurrentButtons = 0x2000;
constexpr unsigned CurrentPosition = 0x2050;  // mm
constexpr unsigned CurrentTransform = 0x2052; // 4 x 4, column by column
constexpr unsigned UsableWorkspace = 0x2551;  // mm, least x, y, z, largest x, y, z
constexpr unsigned OutputDegrees = 0x2554;    // 6: forces, and torques of the gimbal
constexpr unsigned NominalStiffness = 0x2602; // N/mm
constexpr unsigned NominalForce = 0x2603;     // N
constexpr unsigned NominalTorque = 0x2622;    // mN m, so N mm; only in the header
constexpr unsigned CurrentForce = 0x2700;     // N
constexpr unsigned CurrentTorque = 0x2701;    // mN m
constexpr unsigned ForceOutput = 0x4000;
constexpr unsigned GoesOn = 1;
constexpr unsigned IsDone = 0;
constexpr unsigned short LargestPriority = 65535;
constexpr unsigned WarmMotors = 0x0200; // a warning

constexpr double UsualForce = 3.3;    // N, of a Touch
constexpr double StrongestArm = 40.0; // N
constexpr double UsualTorque = 48.0;  // N mm, of a Phantom Premium 6DOF about its weakest axis
constexpr double StrongestTorque = 1000.0;
constexpr std::chrono::milliseconds LongestEnd(100);
} // namespace

struct OpenHapticsArm::Calls
{
  DynamicLibrary Library{"PALPATE_LIBHD", {"libHD.so", "libHD.so.3"}};
  Handle (*Init)(const char*) = nullptr;
  void (*Disable)(Handle) = nullptr;
  void (*MakeCurrent)(Handle) = nullptr;
  void (*Enable)(unsigned) = nullptr;
  void (*BeginFrame)(Handle) = nullptr;
  void (*EndFrame)(Handle) = nullptr;
  void (*GetDoubles)(unsigned, double*) = nullptr;
  void (*GetIntegers)(unsigned, int*) = nullptr;
  void (*SetDoubles)(unsigned, const double*) = nullptr;
  Error (*GetError)() = nullptr;
  unsigned long (*Schedule)(Callback, void*, unsigned short) = nullptr;
  void (*StartScheduler)() = nullptr;
  void (*StopScheduler)() = nullptr;

  Calls()
  {
    this->Library.Find("hdInitDevice", this->Init);
    this->Library.Find("hdDisableDevice", this->Disable);
    this->Library.Find("hdMakeCurrentDevice", this->MakeCurrent);
    this->Library.Find("hdEnable", this->Enable);
    this->Library.Find("hdBeginFrame", this->BeginFrame);
    this->Library.Find("hdEndFrame", this->EndFrame);
    this->Library.Find("hdGetDoublev", this->GetDoubles);
    this->Library.Find("hdGetIntegerv", this->GetIntegers);
    this->Library.Find("hdSetDoublev", this->SetDoubles);
    this->Library.Find("hdGetError", this->GetError);
    this->Library.Find("hdScheduleAsynchronous", this->Schedule);
    this->Library.Find("hdStartScheduler", this->StartScheduler);
    this->Library.Find("hdStopScheduler", this->StopScheduler);
  }
};

OpenHapticsArm::OpenHapticsArm(std::string name) : Name(std::move(name)), Device(NoDevice)
{
  this->Known.Name = "3D Systems Touch";
  this->Known.DegreesOfFreedom = 6;
  this->Known.Buttons = 2; // of the stylus
  this->Known.Workspace = {Vector3(-80.0, -60.0, -35.0), Vector3(80.0, 60.0, 35.0)};
  this->Known.MaximumForce = UsualForce;
  this->Known.Rate = 1000.0;
  this->Known.LongestGap = 0.005; // its scheduler is another thread than the servo's
}

Status OpenHapticsArm::Open()
{
  auto calls = std::make_unique<Calls>();
  if (!calls->Library.IsWhole())
  {
    return Status::Failure("OpenHaptics is not installed (libHD.so): install the driver of the "
                           "Touch and OpenHaptics from 3D Systems.");
  }
  this->Hd = std::move(calls);
  this->Device = this->Hd->Init(this->Name.empty() ? nullptr : this->Name.c_str());
  const Error error = this->Hd->GetError();
  if (this->Device == NoDevice || error.Code != 0)
  {
    this->Failure = error.Code;
    return Status::Failure(this->Trouble());
  }
  this->IsOpen = true;
  this->Failure = 0;
  this->Hd->MakeCurrent(this->Device);
  this->TakeAbilities();
  this->Hd->Enable(ForceOutput);
  return Status::Success();
}

// What a library says is believed within what arms can be.
void OpenHapticsArm::TakeAbilities()
{
  std::array<double, 6> box{};
  double force = 0.0;
  double stiffness = 0.0;
  this->Hd->GetDoubles(UsableWorkspace, box.data());
  this->Hd->GetDoubles(NominalForce, &force);
  this->Hd->GetDoubles(NominalStiffness, &stiffness);
  int degrees = 0;
  double torque = 0.0;
  this->Hd->GetIntegers(OutputDegrees, &degrees);
  this->Hd->GetDoubles(NominalTorque, &torque);
  static_cast<void>(this->Hd->GetError()); // older drivers do not know all of them
  const Eigen::AlignedBox3d workspace(Vector3(box[0], box[1], box[2]),
                                      Vector3(box[3], box[4], box[5]));
  const Vector3 sizes = workspace.sizes();
  if (sizes.minCoeff() > 10.0 && sizes.maxCoeff() < 2000.0)
  {
    this->Known.Workspace = workspace;
  }
  this->Known.MaximumForce = force > 0.0 && force <= StrongestArm ? force : UsualForce;
  torque = torque > 0.0 && torque <= StrongestTorque ? torque : UsualTorque;
  this->Known.MaximumTorque = degrees == 6 ? torque : 0.0;
  this->Known.MaximumStiffness = stiffness > 0.0 && stiffness < 100.0 ? stiffness : 0.0;
}

unsigned OpenHapticsArm::StepOf(void* arm)
{
  auto& self = *static_cast<OpenHapticsArm*>(arm);
  if (!self.HasEnded && !self.Step())
  {
    self.HasEnded = true;
  }
  return self.HasEnded ? IsDone : GoesOn;
}

Status OpenHapticsArm::Run(std::function<bool()> step)
{
  this->Step = std::move(step);
  this->HasEnded = false;
  this->Hd->Schedule(&OpenHapticsArm::StepOf, this, LargestPriority);
  this->Hd->StartScheduler();
  const Error error = this->Hd->GetError();
  this->IsRunning = error.Code == 0;
  this->Failure = error.Code;
  return this->IsRunning ? Status::Success() : Status::Failure(this->Trouble());
}

bool OpenHapticsArm::Measure(DeviceSample& sample) noexcept
{
  std::array<double, 3> place{};
  std::array<double, 16> transform{};
  int buttons = 0;
  this->Hd->BeginFrame(this->Device);
  this->Hd->GetDoubles(CurrentPosition, place.data());
  this->Hd->GetDoubles(CurrentTransform, transform.data());
  this->Hd->GetIntegers(CurrentButtons, &buttons);
  sample.Position = Vector3(place[0], place[1], place[2]);
  const Matrix3 turn = Eigen::Map<const Eigen::Matrix4d>(transform.data()).topLeftCorner<3, 3>();
  Eigen::Map<Eigen::Vector4d>(sample.Orientation.data()) =
      Eigen::Quaterniond(turn).normalized().coeffs();
  sample.Buttons = static_cast<unsigned>(buttons);
  return this->Failure == 0;
}

bool OpenHapticsArm::Push(const Vector3& force, const Vector3& torque) noexcept
{
  const Vector3 shown = ClampedLength(force, this->Known.MaximumForce);
  this->Hd->SetDoubles(CurrentForce, shown.data());
  if (this->Known.MaximumTorque > 0.0)
  {
    const Vector3 turn = ClampedLength(torque, this->Known.MaximumTorque);
    this->Hd->SetDoubles(CurrentTorque, turn.data());
  }
  this->Hd->EndFrame(this->Device);
  const Error error = this->Hd->GetError();
  this->Failure = error.Code != WarmMotors ? error.Code : 0;
  return this->Failure == 0;
}

// The scheduler may have stopped by itself: then no step comes, and none is waited for long.
void OpenHapticsArm::End() noexcept
{
  if (this->IsRunning)
  {
    const auto end = std::chrono::steady_clock::now() + LongestEnd;
    while (!this->HasEnded && std::chrono::steady_clock::now() < end)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    this->HasEnded = true;
    this->Hd->StopScheduler();
    this->IsRunning = false;
  }
  if (this->IsOpen)
  {
    this->Hd->Disable(this->Device);
    this->IsOpen = false;
  }
}

std::string OpenHapticsArm::Trouble() const
{
  std::array<char, 16> code{};
  std::snprintf(code.data(), code.size(), "0x%04x", this->Failure.load());
  return std::string("OpenHaptics reports the error ") + code.data() +
         ": check the device's cable and power, calibrate it by its maker's program, then open it "
         "again.";
}
} // namespace palpate
