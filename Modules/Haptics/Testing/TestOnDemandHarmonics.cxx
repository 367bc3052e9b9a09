#include "CoarseHarmonics.h"
#include "OnDemandHarmonicCases.h"

#include <atomic>
#include <cmath>
#include <thread>

namespace palpate
{
namespace
{
using test::CrowdHand;
using test::HarmonicCrowd;
using test::Random;
using test::ServoRun;

OnDemandHarmonics::Settings Ball(double radius, std::vector<int> standIns = {6, 3})
{
  OnDemandHarmonics::Settings settings;
  settings.Tool = ToolShape::Sphere(radius);
  settings.StandIns = std::move(standIns);
  return settings;
}

// What became of a hand's way through both scenes.
struct Comparison
{
  int Different = 0; // ticks in any bit of their force
  int Touching = 0;
  double Largest = 0.0; // N
};

Comparison Compare(HarmonicCrowd& crowd, double speed, int ticks, std::uint64_t seed)
{
  ServoRun whole(crowd.Whole);
  ServoRun onDemand(crowd.OnDemand);
  CrowdHand hand(speed, seed);
  Comparison comparison;
  crowd.Look(0, hand.Here());
  for (int tick = 1; tick < ticks; ++tick)
  {
    const Vector3 expected = whole.TickAt(hand.Next());
    const Vector3 felt = onDemand.TickAt(hand.Here());
    comparison.Different += felt == expected ? 0 : 1;
    comparison.Largest = std::max(comparison.Largest, (felt - expected).norm());
    comparison.Touching += onDemand.Loop.Latest().Structure >= 0 ? 1 : 0;
    crowd.Look(tick, crowd.Probe->Latest());
  }
  return comparison;
}

std::uint64_t CoarseTicksOf(const HarmonicCrowd& crowd)
{
  return crowd.Degrees->CoarseTicks();
}

TEST(OnDemandHarmonics, AreFeltWithTheBitsOfTheWholeOnesAsFastAsPromised)
{
  for (const double speed : {100.0, 37.0})
  {
    for (const SurfaceFriction& friction : {SurfaceFriction{}, SurfaceFriction{0.4, 0.3}})
    {
      HarmonicCrowd crowd(Ball(2.0), 0.5, friction);
      const Comparison felt = Compare(crowd, speed, 20000, 6301);
      EXPECT_EQ(felt.Different, 0) << felt.Largest << " N";
      EXPECT_GT(felt.Touching, 1000);
      EXPECT_EQ(CoarseTicksOf(crowd), 0u);
      const DegreeCounts counts = crowd.Degrees->Counts();
      EXPECT_EQ(counts.Problem, "");
      EXPECT_GT(counts.Dropped, 10u);
      EXPECT_LE(counts.MostBytes, crowd.Degrees->Room());
    }
  }
}

TEST(OnDemandHarmonics, AreFeltSoInFloatAndByThePublishedLawToo)
{
  OnDemandHarmonics::Settings inFloat = Ball(1.0);
  inFloat.Precision = EvaluationPrecision::Float;
  OnDemandHarmonics::Settings radial = Ball(1.0);
  radial.Mode = HarmonicContactMode::Radial;
  for (const OnDemandHarmonics::Settings& settings : {inFloat, radial})
  {
    HarmonicCrowd crowd(settings, 0.5);
    const Comparison felt = Compare(crowd, 100.0, 6000, 6302);
    EXPECT_EQ(felt.Different, 0) << felt.Largest << " N";
    EXPECT_GT(felt.Touching, 500);
    EXPECT_EQ(CoarseTicksOf(crowd), 0u);
  }
}

// With room for one of those within reach, budget and tool are kept all the same.
TEST(OnDemandHarmonics, StayWithinABudgetThatIsTooSmallAndSaySo)
{
  HarmonicCrowd crowd(Ball(2.0), 0.13);
  ServoRun run(crowd.OnDemand);
  CrowdHand hand(90.0, 6303);
  bool wasSaid = false;
  int touching = 0;
  crowd.Look(0, hand.Here());
  for (int tick = 1; tick < 12000; ++tick)
  {
    const Vector3 force = run.TickAt(hand.Next());
    ASSERT_TRUE(force.allFinite());
    touching += run.Loop.Latest().Structure >= 0 ? 1 : 0;
    crowd.Look(tick, hand.Here());
    const DegreeCounts counts = crowd.Degrees->Counts();
    ASSERT_LE(counts.MostBytes, crowd.Degrees->Room()) << tick;
    wasSaid = wasSaid || !counts.Problem.empty();
  }
  EXPECT_TRUE(wasSaid);
  EXPECT_GT(touching, 500);
  EXPECT_GT(crowd.Degrees->Counts().Brought, 10u);
}

// Nobody looks: what holds the structure is touched no later than the structure.
TEST(OnDemandHarmonics, WhatIsNotAtHandIsHeldByItsCoarseBody)
{
  HarmonicCrowd crowd(Ball(2.0), 1.0);
  Random random(6304);
  for (std::size_t one = 0; one < 4; ++one)
  {
    TouchScene whole = crowd.Whole;
    TouchScene onDemand = crowd.OnDemand;
    whole.Structures = {whole.Structures[one]};
    onDemand.Structures = {onDemand.Structures[one]};
    const Vector3 middle = crowd.Models[one]->CenterWorld();
    for (int way = 0; way < 10; ++way)
    {
      const Vector3 out = test::RandomDirection(random);
      ServoRun fine(whole);
      ServoRun coarse(onDemand);
      for (int tick = 0; tick < 800; ++tick)
      {
        const Vector3 place = middle + (80.0 - 0.1 * tick) * out;
        fine.TickAt(place);
        coarse.TickAt(place);
        const bool isTouched = fine.Loop.Latest().Structure >= 0;
        ASSERT_TRUE(!isTouched || coarse.Loop.Latest().Structure >= 0) << way << ' ' << tick;
      }
      EXPECT_GE(coarse.Loop.Latest().Structure, 0);
    }
  }
  EXPECT_GT(CoarseTicksOf(crowd), 100u);
}

TEST(OnDemandHarmonics, WhatComesWhileItIsTouchedComesWithoutAStep)
{
  HarmonicCrowd crowd(Ball(2.0), 1.0);
  crowd.OnDemand.Structures.resize(1);
  crowd.Whole.Structures.resize(1);
  const SphericalHarmonicModel& model = *crowd.Models[0];
  const Vector3 out = Vector3(1.0, 2.0, -2.0) / 3.0;
  const Vector3 place = model.PointWorld(out) + model.Normal(out); // a millimetre deep
  ServoRun fine(crowd.Whole);
  ServoRun run(crowd.OnDemand);
  for (int tick = 0; tick < 600; ++tick)
  {
    const Vector3 above = place + (60.0 - 0.1 * tick) * out;
    fine.TickAt(above);
    run.TickAt(above);
  }
  const double coarse = run.RestAt(place).norm();
  const double truth = fine.RestAt(place).norm();
  ASSERT_GT(truth, 0.1);
  ASSERT_GT(coarse, truth + 0.1);
  const std::uint64_t before = CoarseTicksOf(crowd);
  crowd.Look(0, place);
  Vector3 last = run.TickAt(place);
  for (int tick = 0; tick < 300; ++tick)
  {
    const Vector3 force = run.TickAt(place);
    // The way from one to the other takes a hundred ticks.
    ASSERT_LE((force - last).norm(), (coarse + truth) / 90.0) << tick;
    last = force;
  }
  EXPECT_NEAR(last.norm(), truth, 1e-6);
  EXPECT_EQ(CoarseTicksOf(crowd), before);
}

// As a keeper does beside the servo, as long as ticks wait where it is late.
TEST(OnDemandHarmonics, AreFeltWithTheSameBitsWhileAnotherThreadLooks)
{
  HarmonicCrowd crowd(Ball(1.0, {}), 0.4);
  ServoRun whole(crowd.Whole);
  ServoRun onDemand(crowd.OnDemand);
  CrowdHand hand(100.0, 6305);
  std::vector<Vector3> places{hand.Here()};
  for (int tick = 1; tick < 12000; ++tick)
  {
    places.push_back(hand.Next());
  }
  const int count = static_cast<int>(places.size());
  std::atomic<int> ticks{0};
  std::atomic<int> looked{-1};
  std::thread worker(
      [&]
      {
        for (int last = -1; last + 1 < count;)
        {
          const int tick = ticks.load(std::memory_order_acquire);
          if (tick == last)
          {
            std::this_thread::yield();
            continue;
          }
          last = tick;
          crowd.Degrees->Look({HarmonicCrowd::Tick * tick, places[static_cast<std::size_t>(tick)]},
                              [tick] { return HarmonicCrowd::Tick * tick + 0.01; });
          looked.store(tick, std::memory_order_release);
        }
      });
  constexpr int Behind = 15; // ticks that the worker may be late
  int different = 0;
  for (int tick = 0; tick < count; ++tick)
  {
    while (looked.load(std::memory_order_acquire) < std::max(0, tick - Behind))
    {
      std::this_thread::yield();
    }
    const Vector3& place = places[static_cast<std::size_t>(tick)];
    different += onDemand.TickAt(place) == whole.TickAt(place) ? 0 : 1;
    ticks.store(tick, std::memory_order_release);
  }
  worker.join();
  EXPECT_EQ(different, 0);
  EXPECT_EQ(CoarseTicksOf(crowd), 0u);
  EXPECT_GT(crowd.Degrees->Counts().Dropped, 3u);
}

TEST(OnDemandHarmonics, SayWhatTheyTake)
{
  HarmonicCrowd crowd(Ball(2.0), 1.0);
  OnDemandHarmonics& one = *crowd.Structures[0];
  const OnDemandHarmonicModel model(crowd.Structures[0], 0);
  const std::size_t kept = one.KeptBytes();
  EXPECT_EQ(model.Bytes(), kept);
  EXPECT_EQ(OnDemandHarmonicModel(crowd.Structures[0], 1).Bytes(), 0u);
  EXPECT_GT(one.BytesAtHand(), crowd.Whole.Structures[0].Model->Bytes());
  EXPECT_LT(kept, one.BytesAtHand() / 2);
  ASSERT_TRUE(one.Bring().IsOk());
  EXPECT_EQ(model.Bytes(), kept + one.BytesAtHand());
  EXPECT_TRUE(one.Drop());
  EXPECT_EQ(model.Bytes(), kept);
  EXPECT_EQ(model.BoundsWorld().min(), crowd.Whole.Structures[0].Model->BoundsWorld().min());
  EXPECT_EQ(model.BoundsWorld().max(), crowd.Whole.Structures[0].Model->BoundsWorld().max());
}

TEST(OnDemandHarmonics, WhatIsTouchedIsNeverDropped)
{
  HarmonicCrowd crowd(Ball(2.0, {}), 1.0);
  OnDemandHarmonics& one = *crowd.Structures[0];
  const auto tracker =
      test::TrackerOf(OnDemandHarmonicModel(crowd.Structures[0], 0), ToolShape::Sphere(2.0));
  ASSERT_TRUE(one.Bring().IsOk());
  const Vector3 middle = crowd.Models[0]->CenterWorld();
  EXPECT_TRUE(tracker->IsAtHand());
  EXPECT_TRUE(tracker->Follow(test::At(middle)).IsTouching);
  EXPECT_FALSE(one.Drop());
  EXPECT_TRUE(tracker->IsAtHand()) << "asked back while it touches";
  EXPECT_TRUE(tracker->Follow(test::At(middle)).IsTouching);
  tracker->Follow(test::At(middle + Vector3(300.0, 0.0, 0.0)));
  EXPECT_FALSE(tracker->IsAtHand()) << "given back";
  EXPECT_TRUE(one.Drop());
  EXPECT_FALSE(one.IsAtHand());
  EXPECT_FALSE(tracker->Follow(test::At(middle)).IsValid) << "nothing is known there";
  EXPECT_TRUE(tracker->Follow(test::At(middle + Vector3(300.0, 0.0, 0.0))).IsValid);
  ASSERT_TRUE(one.Bring().IsOk());
  EXPECT_TRUE(tracker->IsAtHand());
}

TEST(OnDemandHarmonics, ToolsAndFrictionThatCannotBeFeltAreRefused)
{
  HarmonicCrowd crowd(Ball(2.0, {}), 1.0);
  std::unique_ptr<ContactTracker> tracker;
  const OnDemandHarmonicModel model(crowd.Structures[0], 0);
  EXPECT_FALSE(model.MakeTracker(ToolShape::Capsule(1.0, 2.0, 50), {}, tracker).IsOk());
  EXPECT_FALSE(model.MakeTracker(ToolShape::Sphere(1.0), {-1.0, 0.0}, tracker).IsOk());
  EXPECT_EQ(tracker, nullptr);
}

TEST(CoarseHarmonics, HoldTheModelAndAreRaisedNoMoreThanThatTakes)
{
  Random random(6306);
  for (int n = 0; n < 5; ++n)
  {
    const SphericalHarmonicModel model = test::RandomOrgan(random, 12);
    for (const int degree : {0, 2, 4, 12})
    {
      const CoarseHarmonics coarse = MakeCoarseHarmonics(model, degree);
      const SphericalHarmonicModel cut = model.WithDegree(degree);
      EXPECT_EQ(coarse.Model.Degree(), degree);
      double most = 0.0;
      for (int trial = 0; trial < 4000; ++trial)
      {
        const Vector3 u = test::RandomDirection(random);
        most = std::max(most, model.Radius(u) - cut.Radius(u));
        // Rounding of radii of some 30 mm.
        ASSERT_GE(coarse.Model.Radius(u), model.Radius(u) - 1e-12);
        ASSERT_NEAR(coarse.Model.Radius(u), cut.Radius(u) + coarse.RaisedBy, 1e-12);
      }
      // A hundredth of the mean radius, and what random directions miss of a peak.
      EXPECT_LE(coarse.RaisedBy, 1.05 * most + 0.01 * model.Coefficients()[0]);
    }
  }
}
} // namespace
} // namespace palpate
