#include "DeviceContract.h"
#include "StandInTest.h"

namespace palpate::vendor_device_test
{
namespace
{
using test::Maker;

class VendorDeviceTest : public test::StandInTest, public testing::WithParamInterface<Maker>
{
protected:
  void SetUp() override { this->Use(this->GetParam()); }
};

TEST_P(VendorDeviceTest, KeepsTheContractOfDevices)
{
  test::ExpectDeviceContract(*this->Device, [this] { test::AwaitSample(*this->Device); });
  EXPECT_FALSE(this->Arm->IsOpen);
}

TEST_P(VendorDeviceTest, PlaceTurnForceAndTorqueAreInThisProgramsFrame)
{
  for (int part = 0; part < 3; ++part)
  {
    this->Arm->Place[part] = this->GetParam().Place[part];
  }
  this->Arm->Buttons = 2;
  ASSERT_TRUE(this->Device->Open().IsOk());
  ASSERT_TRUE(this->BecomesReady());
  EXPECT_TRUE(this->TickUntil([this] { return this->Displayed() == this->GetParam().Force; },
                              {1.0, 2.0, 0.5}, {20.0, 40.0, 10.0}));
  EXPECT_LT((this->DisplayedTorque() - this->GetParam().Torque).norm(), 1e-12);
  EXPECT_LT((Vector3(this->Sample.Position) - Vector3(10.0, 20.0, 30.0)).norm(), 1e-9);
  EXPECT_EQ(this->Sample.Buttons, 2u);
  const double half = std::sqrt(0.5);
  // OpenHaptics: about z; Force Dimension: about its own z, which is y here.
  const bool isAboutZ = std::string(this->GetParam().Kind) == "openhaptics";
  EXPECT_NEAR(this->Sample.Orientation[isAboutZ ? 2 : 1], half, 1e-12);
  EXPECT_NEAR(this->Sample.Orientation[3], half, 1e-12);
}

TEST_P(VendorDeviceTest, ForceAndTorqueAreClampedLapseAndEndWithTheDevice)
{
  ASSERT_TRUE(this->Device->Open().IsOk());
  ASSERT_TRUE(this->BecomesReady());
  EXPECT_TRUE(this->TickUntil([this] { return this->Displayed().norm() > 1.0; }, {0.0, 1e9, 0.0},
                              {1e9, 0.0, 0.0}));
  EXPECT_LE(this->Arm->LargestForce, this->GetParam().Limit + 1e-9);
  EXPECT_NEAR(this->Arm->LargestTorque, this->GetParam().TorqueLimit,
              1e-9 * this->GetParam().TorqueLimit);
  for (int n = 0; n < 2000 && this->IsDisplaying(); ++n)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1)); // without Apply
  }
  EXPECT_FALSE(this->IsDisplaying());
  EXPECT_TRUE(this->TickUntil([this] { return this->Displayed().norm() > 1.0; }, {0.0, 2.0, 0.0},
                              {20.0, 0.0, 0.0}));
  EXPECT_GT(this->DisplayedTorque().norm(), 0.0);
  this->Device->Close();
  EXPECT_FALSE(this->IsDisplaying());
  EXPECT_FALSE(this->Arm->IsOpen);
}

TEST_P(VendorDeviceTest, ArmWithoutMotorsForTurnsGetsNoTorque)
{
  this->Arm->Turns = false;
  ASSERT_TRUE(this->Device->Open().IsOk());
  EXPECT_EQ(this->Device->Capabilities().MaximumTorque, 0.0);
  ASSERT_TRUE(this->BecomesReady());
  EXPECT_TRUE(this->TickUntil([this] { return this->Displayed().norm() > 1.0; }, {0.0, 2.0, 0.0},
                              {20.0, 0.0, 0.0}));
  EXPECT_EQ(this->Arm->LargestTorque, 0.0);
  EXPECT_EQ(this->Device->State(), DeviceState::Ready) << this->Device->Problem();
}

TEST_P(VendorDeviceTest, SearchTellsWhetherTheArmThatAnswersTurns)
{
  for (const bool turns : {true, false})
  {
    this->Arm->Turns = turns;
    std::vector<FoundDevice> found;
    ASSERT_TRUE(this->Registry.Find(this->GetParam().Kind)->FindDevices(this->Time, found).IsOk());
    ASSERT_EQ(found.size(), 1u);
    ASSERT_TRUE(found[0].Capabilities);
    EXPECT_EQ(found[0].Capabilities->MaximumTorque > 0.0, turns);
  }
}

TEST_P(VendorDeviceTest, WithoutADeviceOrALibraryItSaysWhatToDo)
{
  this->Arm->IsMissing = true;
  EXPECT_FALSE(this->Device->Open().IsOk());
  EXPECT_EQ(this->Device->State(), DeviceState::Closed);
  setenv(this->GetParam().Variable, "/no/such/library.so", 1);
  EXPECT_NE(this->Device->Open().Message().find("is not installed"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Each, VendorDeviceTest, testing::ValuesIn(test::Makers),
                         [](const auto& tested) { return std::string(tested.param.Kind); });

class OldLibraryTest : public test::StandInTest
{
};

TEST_F(OldLibraryTest, LibraryThatKnowsNoWristShowsNoTorque)
{
  Maker old = test::Makers[1];
  old.Library = PALPATE_STAND_IN_OLD_DHD;
  this->Use(old);
  ASSERT_TRUE(this->Device->Open().IsOk());
  EXPECT_EQ(this->Device->Capabilities().MaximumTorque, 0.0);
  ASSERT_TRUE(this->BecomesReady());
  EXPECT_TRUE(this->TickUntil([this] { return this->Displayed().norm() > 1.0; }, {0.0, 2.0, 0.0},
                              {20.0, 0.0, 0.0}));
  EXPECT_EQ(this->Arm->LargestTorque, 0.0);
}
} // namespace
} // namespace palpate::vendor_device_test
