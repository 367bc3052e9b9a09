#include "ForceDimensionArm.h"

#include "ClampedLength.h"

#include <chrono>
#include <utility>

namespace palpate
{
namespace
{
constexpr double LargestReach = 55.0; // mm; the smallest of the arms, omega, has as much
constexpr double ForceOfAll = 8.0;    // N; the weakest of the arms, omega, displays 12
constexpr double TorqueOfAll = 150.0; // N mm; the weakest of the wrists
constexpr double NewtonMeters = 1e-3; // per N mm: torques of the SDK
constexpr double FromMeters = 1000.0;
constexpr std::chrono::microseconds StepPeriod(500);

// From the SDK's axes to ours.
const Matrix3& Axes()
{
  static const Matrix3 axes = (Matrix3() << 0, 1, 0, 0, 0, 1, 1, 0, 0).finished();
  return axes;
}
} // namespace

struct ForceDimensionArm::Calls
{
  DynamicLibrary Library{"PALPATE_LIBDHD", {"libdhd.so", "libdhd.so.3"}};
  int (*Open)() = nullptr;
  int (*Close)(char) = nullptr;
  const char* (*GetSystemName)(char) = nullptr;
  const char* (*GetLastError)() = nullptr;
  int (*EnableForce)(unsigned char, char) = nullptr;
  int (*GetPose)(double*, double*, double*, double (*)[3], char) = nullptr;
  unsigned (*GetButtons)(char) = nullptr;
  bool (*HasActiveWrist)(char) = nullptr; // null in libraries that know none
  int (*SetForce)(double, double, double, double, double, double, double, char) = nullptr;

  Calls()
  {
    this->Library.Find("dhdOpen", this->Open);
    this->Library.Find("dhdClose", this->Close);
    this->Library.Find("dhdGetSystemName", this->GetSystemName);
    this->Library.Find("dhdErrorGetLastStr", this->GetLastError);
    this->Library.Find("dhdEnableForce", this->EnableForce);
    this->Library.Find("dhdGetPositionAndOrientationFrame", this->GetPose);
    this->Library.Find("dhdGetButtonMask", this->GetButtons);
    this->Library.FindIfThere("dhdHasActiveWrist", this->HasActiveWrist);
    this->Library.Find("dhdSetForceAndTorqueAndGripperForce", this->SetForce);
  }
};

ForceDimensionArm::ForceDimensionArm()
{
  this->Known.Name = "Force Dimension";
  this->Known.DegreesOfFreedom = 6;
  this->Known.Buttons = 1; // which all have
  this->Known.Workspace = {Vector3::Constant(-LargestReach), Vector3::Constant(LargestReach)};
  this->Known.MaximumForce = ForceOfAll;
  this->Known.Rate = 1000.0;
  this->Known.LongestGap = 0.005; // a thread of its own, which USB paces
}

Status ForceDimensionArm::Open()
{
  auto calls = std::make_unique<Calls>();
  if (!calls->Library.IsWhole())
  {
    return Status::Failure(
        "Force Dimension's SDK is not installed (libdhd.so): install it from its "
        "maker.");
  }
  this->Dhd = std::move(calls);
  this->Device = this->Dhd->Open();
  if (this->Device < 0)
  {
    return Status::Failure(this->Trouble());
  }
  const auto id = static_cast<char>(this->Device);
  const char* const name = this->Dhd->GetSystemName(id);
  this->Known.Name = std::string("Force Dimension ") + (name != nullptr ? name : "device");
  const bool turns = this->Dhd->HasActiveWrist != nullptr && this->Dhd->HasActiveWrist(id);
  this->Known.MaximumTorque = turns ? TorqueOfAll : 0.0;
  if (this->Dhd->EnableForce(1, id) < 0)
  {
    const std::string trouble = this->Trouble();
    this->End();
    return Status::Failure(trouble);
  }
  return Status::Success();
}

Status ForceDimensionArm::Run(std::function<bool()> step)
{
  this->Thread = std::thread(
      [step = std::move(step)]
      {
        // The calls themselves wait for USB; this is for arms that do not.
        while (step())
        {
          std::this_thread::sleep_for(StepPeriod);
        }
      });
  return Status::Success();
}

bool ForceDimensionArm::Measure(DeviceSample& sample) noexcept
{
  const auto id = static_cast<char>(this->Device);
  Vector3 place = Vector3::Zero();
  double rows[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  if (this->Dhd->GetPose(&place.x(), &place.y(), &place.z(), rows, id) < 0)
  {
    return false;
  }
  sample.Position = Vector3(FromMeters * (Axes() * place));
  const Matrix3 turn = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rows[0]);
  Eigen::Map<Eigen::Vector4d>(sample.Orientation.data()) =
      Eigen::Quaterniond(Matrix3(Axes() * turn * Axes().transpose())).normalized().coeffs();
  sample.Buttons = this->Dhd->GetButtons(id);
  return true;
}

bool ForceDimensionArm::Push(const Vector3& force, const Vector3& torque) noexcept
{
  const Vector3 shown = Axes().transpose() * ClampedLength(force, ForceOfAll);
  const Vector3 turn =
      NewtonMeters * (Axes().transpose() * ClampedLength(torque, this->Known.MaximumTorque));
  return this->Dhd->SetForce(shown.x(), shown.y(), shown.z(), turn.x(), turn.y(), turn.z(), 0.0,
                             static_cast<char>(this->Device)) >= 0;
}

void ForceDimensionArm::End() noexcept
{
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
  if (this->Device >= 0)
  {
    this->Dhd->Close(static_cast<char>(this->Device));
    this->Device = -1;
  }
}

std::string ForceDimensionArm::Trouble() const
{
  const char* const said = this->Dhd != nullptr ? this->Dhd->GetLastError() : nullptr;
  return std::string("Force Dimension's library reports: ") + (said != nullptr ? said : "nothing") +
         ". Check the device's cable, power and force button, then open it again.";
}
} // namespace palpate
