#include "InputError.h"
#include "ModelFile.h"
#include "RandomShapes.h"
#include "SceneKeeper.h"
#include "SteadyClock.h"
#include "TemporaryFolder.h"
#include "TouchRun.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
bool GoOn(double, const std::string&)
{
  return true;
}

// Models of organs in a row.
class SceneDegreesTest : public testing::Test
{
protected:
  static constexpr int Count = 6;
  static constexpr double Apart = 50.0; // mm

  void SetUp() override
  {
    test::Random random(6400);
    for (int n = 0; n < Count; ++n)
    {
      const SphericalHarmonicModel organ = test::RandomOrgan(random, 12);
      const auto file = this->Folder / (std::to_string(n) + ".json");
      const Vector3 middle(Apart * n, 0.0, 0.0);
      WriteModel(file, {SphericalHarmonicModel(12, organ.Coefficients(), middle), {}});
      this->Organ.File = file;
      this->Organ.IsSeen = false;
      this->Organs.push_back(this->Organ);
    }
  }

  TouchSettings Settings(std::optional<double> megabytes) const
  {
    TouchSettings settings;
    settings.Structures = this->Organs;
    settings.Tool.Radius = 2.0;
    settings.Scale = 1.0;
    settings.MemoryMegabytes = megabytes;
    return settings;
  }
  // To places above and in the row, one after the other, at 95 mm/s.
  static TouchScript Script()
  {
    constexpr double Speed = 95.0;
    test::Random random(6401);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::vector<HandPath::Place> places{{0.0, Vector3(0.0, 0.0, 60.0)}};
    for (int n = 0; n < 24; ++n)
    {
      const Vector3 next((Count - 1) * Apart * part(random), 10.0 * part(random),
                         n % 2 == 0 ? 5.0 : 40.0);
      const double way = (next - places.back().PointWorld).norm();
      places.push_back({places.back().Time + way / Speed, next});
    }
    TouchScript script;
    script.Path = HandPath(places);
    return script;
  }
  // With what is kept, in MB.
  double All() const
  {
    const TouchStructures made = MakeTouchStructures(this->Settings(1000.0), false, GoOn);
    double bytes = 0.0;
    for (const TouchableStructure& one : made.Touched)
    {
      bytes += static_cast<double>(one.Harmonics->KeptBytes() + one.Harmonics->BytesAtHand());
    }
    return 1e-6 * bytes;
  }

  test::TemporaryFolder Folder;
  TouchStructureSettings Organ;
  std::vector<TouchStructureSettings> Organs;
};

TEST_F(SceneDegreesTest, WhatComesAndGoesHasTheBitsOfWhatStays)
{
  const PreparedTouch whole = PrepareTouch(this->Settings({}), Script(), GoOn);
  EXPECT_EQ(whole.Degrees, nullptr);
  const auto file = this->Folder / "session.touch";
  const TouchResult expected = RunTouch(whole, {true, file, {}, {}}, GoOn);
  EXPECT_GT(expected.TouchedSeconds.at(1) + expected.TouchedSeconds.at(Count - 2), 0.5);
  const PreparedTouch less = PrepareTouch(this->Settings(0.6 * this->All()), Script(), GoOn);
  ASSERT_NE(less.Degrees, nullptr);
  const auto lessFile = this->Folder / "less.touch";
  const TouchResult felt = RunTouch(less, {true, lessFile, {}, {}}, GoOn);
  EXPECT_EQ(felt.CoarseTicks, 0u);
  EXPECT_EQ(felt.MissingParts, "");
  EXPECT_GT(less.Degrees->Counts().Dropped, 3u);
  EXPECT_LE(less.Degrees->Counts().MostBytes, less.Degrees->Room());
  EXPECT_EQ(CompareTouch(less, file).DifferentTicks, 0u);
  EXPECT_EQ(CompareTouch(whole, lessFile).DifferentTicks, 0u);
}

// In virtual time it follows from the path, what there is room for too.
TEST_F(SceneDegreesTest, WithTooLittleForAllThatIsNearASessionIsFeltAgainToTheBit)
{
  for (TouchStructureSettings& organ : this->Organs)
  {
    organ.Friction = {0.3, 0.2};
  }
  const PreparedTouch touch = PrepareTouch(this->Settings(0.32 * this->All()), Script(), GoOn);
  const auto file = this->Folder / "session.touch";
  const TouchResult felt = RunTouch(touch, {true, file, {}, {}}, GoOn);
  EXPECT_LE(touch.Degrees->Counts().MostBytes, touch.Degrees->Room());
  EXPECT_GT(touch.Degrees->Counts().Dropped, 3u);
  EXPECT_GT(felt.Ticks, 7000u);
  EXPECT_EQ(CompareTouch(touch, file).DifferentTicks, 0u);
}

TEST_F(SceneDegreesTest, TheAccountSaysFromWhereWhatIsAtHand)
{
  const TouchStructures made = MakeTouchStructures(this->Settings(6.0), false, GoOn);
  EXPECT_EQ(made.Account.MemoryBudget, 6000000u);
  const SceneItem& contact = made.Account.Structures.at(0).Contact;
  EXPECT_NE(contact.Is.find("coarse degree 4, raised by "), std::string::npos) << contact.Is;
  EXPECT_NE(contact.Is.find("within 4.0 mm of its box"), std::string::npos) << contact.Is;
  EXPECT_EQ(contact.Bytes, made.Touched.at(0).Harmonics->KeptBytes());
  std::uintmax_t kept = 0;
  for (const SceneStructureAccount& one : made.Account.Structures)
  {
    kept += one.Contact.Bytes;
  }
  EXPECT_LE(kept + made.Account.HarmonicsRoom, made.Account.MemoryBudget);
  EXPECT_EQ(made.Touched[0].Represented, contact.Is);
}

TEST_F(SceneDegreesTest, WhatHasNoLowerDegreeStaysAndSaysSo)
{
  WriteModel(this->Organs[0].File, {SphericalHarmonicModel(0, {70.0}, Vector3::Zero()), {}});
  this->Organs.resize(1);
  const TouchStructures made = MakeTouchStructures(this->Settings(6.0), false, GoOn);
  EXPECT_EQ(made.Touched.at(0).Harmonics, nullptr);
  EXPECT_EQ(made.Degrees, nullptr);
  EXPECT_NE(made.Touched.at(0).Represented.find("whole, since"), std::string::npos);
}

TEST_F(SceneDegreesTest, ABudgetThatDoesNotHoldTheLargestIsRefusedByName)
{
  try
  {
    MakeTouchStructures(this->Settings(1.0), false, GoOn);
    FAIL() << "made of nothing";
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("the largest model takes"), std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("memory_mb"), std::string::npos) << error.what();
  }
}

// As in real time: a thread looks where the servo left the probe.
TEST_F(SceneDegreesTest, AKeeperFollowsTheProbeOnItsOwnThread)
{
  const TouchStructures made = MakeTouchStructures(this->Settings(0.4 * this->All()), false, GoOn);
  const auto probe = std::make_shared<LatestValue<PlainVector3>>();
  const SteadyClock clock;
  SceneKeeper keeper({{}, made.Degrees}, probe);
  keeper.Start(clock);
  for (const int n : {0, Count - 1, 0})
  {
    probe->Publish(Vector3(Apart * n, 0.0, 0.0));
    while (!made.Touched[static_cast<std::size_t>(n)].Harmonics->IsAtHand())
    {
      std::this_thread::yield();
    }
  }
  keeper.Stop();
  EXPECT_EQ(keeper.Problem(), "");
  EXPECT_FALSE(made.Touched[Count - 1].Harmonics->IsAtHand());
  EXPECT_EQ(keeper.CoarseTicks(), 0u);
}
} // namespace
} // namespace palpate
