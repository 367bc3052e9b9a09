#include "BootStream.h"
#include "FalconTestBed.h"
#include "TemporaryFolder.h"
#include "TouchPanel.h"
#include "WindowTest.h"

#include <QComboBox>
#include <QLabel>

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>

namespace palpate::falcon_in_window_test
{
namespace
{
using test::FalconTestBed;
using test::UsbfsFalcon;
using test::VirtualFalcon;

double Norm(const PlainVector3& vector)
{
  return std::hypot(vector.X, vector.Y, vector.Z);
}

// Pulls the handle out and pushes it in, twice a second.
Vector3 HomingHand(double seconds)
{
  return {0.0, 0.0, 130.0 - 45.0 * std::cos(4.0 * M_PI * seconds)};
}

// The window with a virtual Falcon on a virtual bus, in real time. Replies take some milliseconds
// there, so rates are not tested.
class FalconInWindowTest : public test::WindowTest
{
protected:
  FalconInWindowTest() { this->Time = std::make_unique<SteadyClock>(); }
  void SetUp() override
  {
    // Not skipped: a lost wrapper must not look like success.
    ASSERT_TRUE(FalconTestBed::IsPossible()) << "umockdev is not preloaded: use umockdev-wrapper";
    test::WindowTest::SetUp();
    if (IsSkipped())
    {
      return;
    }
    const std::vector<std::uint8_t> image = test::BootStream();
    const auto firmware = this->Phantom.Folder / "firmware.bin";
    test::WriteAll(firmware, {image.begin(), image.end()});
    this->OpenPhantom();
    StudyState next = this->Study->State();
    next.Structures.resize(1); // the sphere
    this->Study->Change("Keep the ball", next);
    this->Settle();
    auto* device = this->Window->findChild<QComboBox*>("device");
    device->setCurrentText("falcon:firmware=" + QString::fromStdString(firmware.string()));
    this->Window->Messages()->Clear(); // on structures that cannot be modelled
  }

  void SetHand(std::function<Vector3(double)> path)
  {
    this->Bus.WithFalcon([&](VirtualFalcon& falcon)
                         { falcon.Mechanism().Settings.Path = std::move(path); });
  }
  void StartTouch()
  {
    this->SetHand(HomingHand);
    this->Button("start-touch")->click();
    WaitUntil([this] { return this->Study->IsTouching() || !this->Messages().empty(); });
  }
  // Starts, homes, and presses the sphere from the user's side.
  void TouchTheSphere()
  {
    this->StartTouch();
    ASSERT_TRUE(this->Study->IsTouching()) << this->Messages();
    WaitUntil([this] { return this->Study->Reading().Newest.State == DeviceState::Ready; });
    const Vector3 sphere = this->Study->Current().Touch().Frame().ToDevice({-15.0, 0.0, 0.0});
    // In and out again, since after a delay of the machine the sphere around the tool is silent.
    this->SetHand(
        [sphere](double seconds) -> Vector3
        {
          const double out = 15.0 * (1.0 + std::cos(1.5 * seconds)); // mm
          return sphere + Vector3(0.0, 0.0, CenterHeight + out);
        });
    this->FeelDespiteDelaysUntil(
        [this]
        {
          const StudyTouchReading& reading = this->Study->Reading();
          return reading.TouchedId == 1 && Norm(reading.Newest.ForceDevice) > 0.2;
        });
  }
  // Allows forces again, as a user would, after delays of the machine or the virtual bus, which can
  // occur in real time; no other fault may occur. Throws if it never becomes true.
  void FeelDespiteDelaysUntil(const std::function<bool()>& isTrue)
  {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(100);
    WaitUntil(
        [&]
        {
          const SafetyFault fault = this->Study->Reading().Newest.Safety.Fault;
          // A bus that was silent for too long loses the device, which comes back without force.
          const bool isBack = !this->Study->Current().DeviceNotice().empty();
          if (fault == SafetyFault::StalledTick || fault == SafetyFault::StaleSample ||
              fault == SafetyFault::UntakenForce || fault == SafetyFault::ImplausibleMotion ||
              isBack)
          {
            this->Study->Current().Touch().SwitchForcesOn();
          }
          if (std::chrono::steady_clock::now() > end)
          {
            throw std::runtime_error(
                std::string("Not felt in time: ") + Describe(fault) + " " +
                this->Window->findChild<QLabel*>("advice")->text().toStdString());
          }
          return isTrue();
        });
  }

  static constexpr double CenterHeight = 125.0; // mm, of the workspace over the base

  VirtualFalcon Model;
  UsbfsFalcon Bus{Model};
  FalconTestBed Bed;
};

TEST_F(FalconInWindowTest, ReportsMissingFalconAndContinues)
{
  this->StartTouch();
  EXPECT_FALSE(this->Study->IsTouching());
  EXPECT_NE(this->Messages().find("There is no Falcon on USB"), std::string::npos);
  EXPECT_EQ(this->Button("start-touch")->text(), "Start touching");
}

TEST_F(FalconInWindowTest, ShowsHomingInstructions)
{
  this->Bed.Plug(this->Bus, 2);
  this->SetHand([](double) -> Vector3 { return {0.0, 0.0, 125.0}; });
  this->Button("start-touch")->click();
  auto* advice = this->Window->findChild<QLabel*>("advice");
  WaitUntil([this, advice] { return !advice->text().isEmpty() || !this->Messages().empty(); });
  EXPECT_EQ(this->Messages(), "");
  EXPECT_FALSE(this->Study->Reading().Guidance.empty());
  EXPECT_TRUE(advice->text().contains(QString::fromStdString(this->Study->Reading().Guidance)));
}

TEST_F(FalconInWindowTest, UnpluggingEndsForcesAndReplugRestoresTouch)
{
  this->Bed.Plug(this->Bus, 2);
  ASSERT_NO_FATAL_FAILURE(this->TouchTheSphere());
  this->Bed.Unplug(2);
  auto* advice = this->Window->findChild<QLabel*>("advice");
  WaitUntil([advice] { return advice->text().contains("unplugged"); });
  EXPECT_EQ(Norm(this->Study->Reading().Newest.ForceDevice), 0.0);
  EXPECT_NE(this->Study->Reading().Newest.Safety.Fault, SafetyFault::None);
  this->Button("start-touch")->click(); // stops
  EXPECT_FALSE(this->Study->IsTouching());
  this->Bed.Plug(this->Bus, 2);
  ASSERT_NO_FATAL_FAILURE(this->TouchTheSphere());
  this->FeelDespiteDelaysUntil([this] { return this->Window->Contents().Probe()->GetInContact(); });
}
} // namespace
} // namespace palpate::falcon_in_window_test
