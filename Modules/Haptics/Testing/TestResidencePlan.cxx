#include "FieldCases.h"
#include "ProceduralFields.h"
#include "ResidencePlan.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate
{
namespace
{
// A surface through every brick of voxels of 0.5 mm.
class ResidencePlanTest : public testing::Test
{
protected:
  ResidencePlanTest()
      : Grid({161, 161, 161}, Vector3(-40.0, 10.0, 5.0), Vector3::Constant(0.5),
             Eigen::AngleAxisd(0.4, Vector3(1.0, 2.0, 3.0).normalized()).toRotationMatrix()),
        Field(test::MakeField(
            Grid, test::SampleAtIndices<float>(Grid.Size(), test::GyroidField{9.0}), 0.0)),
        Survey(std::make_shared<const FieldSurvey>(*Field))
  {
    this->Settings.AskedReach = 3.0;
    this->Settings.Room = 2000;
  }
  ResidencePlan Plan() const { return {this->Grid, this->Survey, this->Settings}; }
  Vector3 World(double i, double j, double k) const { return this->Grid.PointWorld({i, j, k}); }
  // Whether everything within `reach` (mm) of a place lies in a box.
  bool Holds(const BrickBox& box, const Vector3& place, double reach) const
  {
    const FieldGrid& grid = this->Grid;
    const BrickLayout part = this->Survey->Layout().Part(box);
    const Vector3 index = grid.PointIndex(place);
    bool isIn = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      isIn = isIn && (box.First[a] == 0 || index[axis] - reach / 0.5 > part.Lower[a]) &&
             (part.IsLastOfGrid(a) || index[axis] + reach / 0.5 < part.Upper[a]);
    }
    return isIn;
  }

  FieldGrid Grid;
  std::shared_ptr<const ScalarField> Field;
  std::shared_ptr<const FieldSurvey> Survey;
  ResidenceSettings Settings;
};

// At any speed up to the promised one, in any direction, with looks and versions that take as long
// as they may, what a tick asks is at hand.
TEST_F(ResidencePlanTest, AToolThatIsNoFasterThanPromisedDoesNotLeaveWhatIsAtHand)
{
  std::mt19937_64 random(61);
  constexpr double LookPeriod = 0.005;
  for (int run = 0; run < 20; ++run)
  {
    ResidencePlan plan = this->Plan();
    Vector3 place = this->World(80.0, 80.0, 80.0);
    std::optional<BrickBox> box = plan.Look({0.0, place});
    ASSERT_TRUE(box);
    plan.Made(0.015);
    BrickBox current = *box;
    BrickBox next;
    bool isMaking = false;
    double readyAt = 0.0;
    int versions = 0;
    Vector3 way = Vector3::UnitX();
    for (int tick = 1; tick < 3000; ++tick)
    {
      const double time = 0.001 * tick;
      if (tick % 100 == 1)
      {
        way = Vector3::Random().normalized() * (random() % 2 == 0 ? 100.0 : 40.0);
      }
      place += 0.001 * way;
      if (isMaking && time >= readyAt)
      {
        current = next;
        isMaking = false;
        plan.Made(0.015);
        ++versions;
      }
      ASSERT_TRUE(this->Holds(current, place, this->Settings.AskedReach)) << run << ' ' << tick;
      if (!isMaking && std::fmod(time + 1e-9, LookPeriod) < 0.001)
      {
        const std::optional<BrickBox> wanted = plan.Look({time, place});
        isMaking = wanted.has_value();
        next = wanted.value_or(next);
        readyAt = time + 0.0149;
      }
    }
    EXPECT_GT(versions, 5);
  }
}

TEST_F(ResidencePlanTest, AToolThatStaysWantsNothingNew)
{
  ResidencePlan plan = this->Plan();
  const Vector3 place = this->World(60.0, 70.0, 80.0);
  ASSERT_TRUE(plan.Look({0.0, place}));
  plan.Made(0.01);
  for (int look = 1; look < 1000; ++look)
  {
    const Vector3 trembling = 0.3 * Vector3(std::sin(look), std::cos(look), std::sin(0.7 * look));
    ASSERT_FALSE(plan.Look({0.05 * look, place + trembling}));
  }
}

TEST_F(ResidencePlanTest, AFasterToolIsKeptMoreRoundIt)
{
  ResidencePlan slow = this->Plan();
  ResidencePlan fast = this->Plan();
  const Vector3 place = this->World(80.0, 80.0, 80.0);
  ASSERT_TRUE(slow.Look({0.0, place}));
  ASSERT_TRUE(fast.Look({0.0, place}));
  slow.Made(0.01);
  fast.Made(0.01);
  const auto wantedSlow = slow.Look({0.1, place + Vector3(9.0, 0.0, 0.0)});
  const auto wantedFast = fast.Look({0.01, place + Vector3(9.0, 0.0, 0.0)}); // 900 mm/s
  ASSERT_TRUE(wantedSlow && wantedFast);
  EXPECT_GT(wantedFast->Count(), wantedSlow->Count());
  EXPECT_GE(fast.KeptSpeed(), 3.0 * slow.KeptSpeed());
}

TEST_F(ResidencePlanTest, VersionsThatTakeLongAreMadeForMore)
{
  ResidencePlan plan = this->Plan();
  const Vector3 place = this->World(80.0, 80.0, 80.0);
  const auto quick = plan.Look({0.0, place});
  plan.Made(0.08);
  const auto slow = plan.Look({10.0, place + Vector3(3.0, 0.0, 0.0)});
  ASSERT_TRUE(quick && slow);
  EXPECT_GT(slow->Count(), quick->Count());
  EXPECT_NEAR(plan.KeptSpeed(), 100.0, 1e-9);
}

TEST_F(ResidencePlanTest, WithLittleRoomItSaysAtWhichSpeedItKeepsUp)
{
  this->Settings.Room = 100;
  ResidencePlan plan = this->Plan();
  const auto box = plan.Look({0.0, this->World(80.0, 80.0, 80.0)});
  ASSERT_TRUE(box);
  EXPECT_LE(this->Survey->RecordCount(*box), 100u);
  EXPECT_LT(plan.KeptSpeed(), 100.0);
  plan.Made(0.01);
  EXPECT_FALSE(plan.Look({0.01, this->World(80.1, 80.0, 80.0)})) << "again and again the same";
}

TEST_F(ResidencePlanTest, WhereAllHasRoomAllIsWantedOnce)
{
  this->Settings.Room = this->Survey->RecordCount();
  ResidencePlan plan = this->Plan();
  const auto box = plan.Look({0.0, this->World(80.0, 80.0, 80.0)});
  ASSERT_TRUE(box);
  EXPECT_EQ(box->Count(), this->Survey->Layout().BrickCount());
  plan.Made(0.5);
  for (int look = 1; look < 100; ++look)
  {
    ASSERT_FALSE(plan.Look({0.01 * look, this->World(1.5 * look, 10.0, 20.0)}));
  }
  EXPECT_TRUE(std::isinf(plan.KeptSpeed()));
}

TEST_F(ResidencePlanTest, WhatCouldNotBeMadeIsWantedAgain)
{
  ResidencePlan plan = this->Plan();
  const Vector3 place = this->World(80.0, 80.0, 80.0);
  ASSERT_TRUE(plan.Look({0.0, place}));
  plan.Failed();
  EXPECT_TRUE(plan.Look({0.01, place}));
}

TEST_F(ResidencePlanTest, PlacesThatAreNoneAndFarOnesDoNoHarm)
{
  ResidencePlan plan = this->Plan();
  EXPECT_FALSE(plan.Look({0.0, Vector3::Constant(std::nan(""))}));
  const auto box = plan.Look({0.0, Vector3(1e12, -1e12, 1e12)});
  ASSERT_TRUE(box);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    EXPECT_GE(box->First[axis], 0);
    EXPECT_LE(box->First[axis], box->Last[axis]);
    EXPECT_LT(box->Last[axis], this->Survey->Layout().Bricks[axis]);
  }
}
} // namespace
} // namespace palpate
