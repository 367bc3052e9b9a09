#include "FieldContactCases.h"
#include "FieldProxyTracker.h"
#include "OnDemandContactModel.h"
#include "WorstCase.h"

#include <atomic>
#include <thread>

namespace palpate
{
namespace
{
using test::At;
using test::FieldContact;
using test::FineGrid;
using test::Random;
using test::SampledField;
using test::TrackerOf;

constexpr double Tick = 0.001; // s

// A field, whole and on demand, felt by the same tool.
class OnDemandCase
{
public:
  OnDemandCase(std::shared_ptr<const ScalarField> field, const ToolShape& tool, double poolPart,
               const SurfaceFriction& friction = {})
      : Whole(std::move(field)), Survey(std::make_shared<const FieldSurvey>(*Whole))
  {
    const double voxel = this->Whole->Grid().Spacing().minCoeff();
    const ToolShape shell = FieldContactModel::ShellFor(tool, voxel);
    OnDemandField::Settings settings;
    settings.AskedReach = FieldProxyTracker::AskedReachOf(shell, voxel);
    const Status status =
        OnDemandField::Make(*this->Whole, 0, this->Survey,
                            std::make_unique<RecordsInMemory>(*this->Whole), settings, this->Field);
    EXPECT_TRUE(status.IsOk()) << status.Message();
    const auto all = static_cast<double>(this->Field->LargestPool());
    EXPECT_TRUE(this->Field->GivePool(static_cast<std::size_t>(poolPart * all)).IsOk());
    this->Expected = TrackerOf(*FieldContact(this->Whole), tool, friction);
    this->Tracker = TrackerOf(OnDemandContactModel(this->Field), tool, friction);
  }

  // As a thread does that looks every 5 ms, and is ready as fast as it may be slow.
  void Look(int tick, const Vector3& place)
  {
    if (tick % 5 == 0)
    {
      this->Field->Look({Tick * tick, place}, [tick] { return Tick * tick + 0.01; });
    }
  }
  bool IsInside(const Vector3& place) const
  {
    return FieldSampler(this->Whole).IsInsideWorld(0, place);
  }

  std::shared_ptr<const ScalarField> Whole;
  std::shared_ptr<const FieldSurvey> Survey;
  std::shared_ptr<OnDemandField> Field;
  std::unique_ptr<ContactTracker> Expected;
  std::unique_ptr<ContactTracker> Tracker;
};

bool SameBits(const Contact& a, const Contact& b)
{
  return a.IsTouching == b.IsTouching && a.IsValid == b.IsValid && a.Material == b.Material &&
         a.ProxyWorld == b.ProxyWorld && a.NormalWorld == b.NormalWorld && a.Depth == b.Depth;
}

std::shared_ptr<const ScalarField> Gyroid(FieldInterpolation method)
{
  return SampledField(FineGrid(161), test::GyroidField{24.0}, method);
}

// From a place in the void of a gyroid, wandering in the grid at this speed (mm/s).
class Wanderer
{
public:
  Wanderer(const ScalarField& field, double speed, std::uint64_t seed)
      : Grid(field.Grid()), Step(speed * Tick), Turn(seed), Place(Start(field))
  {
  }
  const Vector3& Next()
  {
    if (this->Count++ % 150 == 0)
    {
      const Vector3 middle = this->Grid.PointWorld(Vector3::Constant(80.0));
      const Vector3 aim = middle + 26.0 * test::RandomDirection(this->Turn);
      this->Way = (aim - this->Place).normalized();
    }
    this->Place += this->Step * this->Way;
    return this->Place;
  }
  const Vector3& Here() const { return this->Place; }

private:
  static Vector3 Start(const ScalarField& field)
  {
    const FieldSampler sampler(
        std::shared_ptr<const ScalarField>(std::shared_ptr<const ScalarField>(), &field));
    const Vector3 middle = field.Grid().PointWorld(Vector3::Constant(80.0));
    Random random(6200);
    Vector3 farthest = middle;
    for (int trial = 0; trial < 1000; ++trial)
    {
      const Vector3 place = middle + 10.0 * test::RandomDirection(random);
      const bool isFarther =
          sampler.ValueWorld(0, place).Value < sampler.ValueWorld(0, farthest).Value;
      farthest = isFarther ? place : farthest;
    }
    return farthest;
  }

  const FieldGrid& Grid;
  double Step;
  Random Turn;
  Vector3 Place;
  Vector3 Way = Vector3::Zero();
  int Count = 0;
};

TEST(OnDemandTracker, FeelsTheBitsOfTheWholeFieldAsFastAsPromised)
{
  for (const auto method : {FieldInterpolation::Trilinear, FieldInterpolation::TricubicBSpline})
  {
    for (const SurfaceFriction& friction : {SurfaceFriction{}, SurfaceFriction{0.4, 0.3}})
    {
      OnDemandCase with(Gyroid(method), ToolShape::Sphere(1.0), 0.35, friction);
      Wanderer hand(*with.Whole, 100.0, 6201);
      with.Look(0, hand.Here());
      with.Expected->Follow(At(hand.Here()));
      with.Tracker->Follow(At(hand.Here()));
      int touching = 0;
      for (int tick = 1; tick < 3000; ++tick)
      {
        const Vector3& place = hand.Next();
        const Contact& expected = with.Expected->Follow(At(place));
        const Contact& felt = with.Tracker->Follow(At(place));
        ASSERT_TRUE(SameBits(felt, expected)) << tick;
        touching += felt.IsTouching ? 1 : 0;
        with.Look(tick, place);
      }
      const OnDemandCounts counts = with.Field->Counts();
      EXPECT_EQ(counts.CoarseTicks, 0u);
      EXPECT_EQ(counts.Problem, "");
      EXPECT_GE(counts.KeptSpeed, 100.0);
      EXPECT_GT(counts.Versions, 10u);
      EXPECT_LT(counts.BricksResident, with.Survey->RecordCount());
      EXPECT_GT(touching, 500);
    }
  }
}

// A wall of some voxels across the grid: the proxy of a tool on one side of it never gets to the
// other, however fast the probe is and wherever bricks are missing.
TEST(OnDemandTracker, LetsNoToolThroughWhateverIsMissing)
{
  struct Wall
  {
    double Thickness;
    double Value(const Vector3& p) const
    {
      return 0.5 * this->Thickness - std::abs(p[2] - 60.0 - 6.0 * std::sin(0.12 * p[0]));
    }
  };
  Random random(6202);
  std::uint64_t coarse = 0;
  int touching = 0;
  for (const double thickness : {1.0, 2.0, 6.0})
  {
    OnDemandCase with(SampledField(FineGrid(121), Wall{thickness}), ToolShape::Sphere(1.0), 0.3);
    const FieldGrid& grid = with.Whole->Grid();
    for (int run = 0; run < 30; ++run)
    {
      with.Tracker->Release();
      // Above the wall; then up and down at up to 5 m/s, with looks now and then.
      Vector3 index(60.0 + 20.0 * test::RandomDirection(random)[0], 60.0, 90.0);
      Vector3 place = grid.PointWorld(index);
      with.Tracker->Follow(At(place));
      for (int tick = 1; tick < 150; ++tick)
      {
        const double speed = run % 3 == 0 ? 5.0 : run % 3 == 1 ? 0.5 : 0.1; // mm a tick
        Vector3 way = test::RandomDirection(random);
        way[2] = tick % 50 < 30 ? -std::abs(way[2]) : std::abs(way[2]);
        place += speed * way;
        const Contact& felt = with.Tracker->Follow(At(place));
        const Vector3 proxy = grid.PointIndex(felt.ProxyWorld);
        touching += felt.IsTouching ? 1 : 0;
        const bool isOverGrid =
            proxy[0] > 4.0 && proxy[0] < 116.0 && proxy[1] > 4.0 && proxy[1] < 116.0;
        if (!isOverGrid)
        {
          break; // round the wall
        }
        ASSERT_GT(proxy[2], 60.0 + 6.0 * std::sin(0.12 * proxy[0])) << run << ' ' << tick;
        if (random() % 20 == 0)
        {
          with.Field->Look({10.0 * run + Tick * tick, place},
                           [&] { return 10.0 * run + Tick * tick + 0.01; });
        }
      }
    }
    coarse += with.Field->Counts().CoarseTicks;
  }
  EXPECT_GT(coarse, 1000u);
  EXPECT_GT(touching, 1000);
}

// A tool that rests finds itself on the fine surface again once its bricks are there.
TEST(OnDemandTracker, GoesBackToTheFineFieldWhenItsBricksAreThere)
{
  const test::SphereField ball{{80.0, 80.0, 80.0}, 40.0};
  OnDemandCase with(SampledField(FineGrid(161), ball), ToolShape::Sphere(1.0), 0.3);
  const FieldGrid& grid = with.Whole->Grid();
  const Vector3 middle = grid.PointWorld(ball.Center);
  const Vector3 out = Vector3(1.0, 2.0, 2.0) / 3.0;
  Vector3 probe = middle + 30.0 * out; // the ball has 20 mm
  with.Tracker->Follow(At(probe));
  const Contact* felt = nullptr;
  for (int tick = 1; tick <= 100; ++tick)
  {
    probe = middle + (30.0 - 0.12 * tick) * out;
    felt = &with.Tracker->Follow(At(probe));
  }
  ASSERT_TRUE(felt->IsTouching);
  EXPECT_GT(with.Field->Counts().CoarseTicks, 50u);
  const double reach = std::sqrt(3.0) * 3.0 * 0.5;
  const double coarse = (felt->ProxyWorld - middle).norm() - 21.0;
  EXPECT_GT(coarse, -0.01);
  EXPECT_LT(coarse, reach) << "the coarse field's own bound";
  const std::uint64_t before = with.Field->Counts().CoarseTicks;
  with.Look(105, probe);
  for (int tick = 0; tick < 50; ++tick)
  {
    felt = &with.Tracker->Follow(At(probe));
  }
  EXPECT_EQ(with.Field->Counts().CoarseTicks, before);
  ASSERT_TRUE(felt->IsTouching);
  EXPECT_NEAR((felt->ProxyWorld - middle).norm(), 21.0, 0.02) << "linear between voxels of 0.5 mm";
}

TEST(OnDemandTracker, WhatItGivesIsFiniteForAnyPose)
{
  OnDemandCase with(Gyroid(FieldInterpolation::Trilinear), ToolShape::Sphere(1.0), 0.3);
  Random random(6203);
  const Vector3 middle = with.Whole->Grid().PointWorld(Vector3::Constant(80.0));
  for (int tick = 0; tick < 2000; ++tick)
  {
    Vector3 place = middle + 60.0 * test::RandomDirection(random);
    place *= random() % 50 == 0 ? std::nan("") : random() % 50 == 0 ? 1e60 : 1.0;
    const Contact& felt = with.Tracker->Follow(At(place));
    ASSERT_EQ(felt.IsValid, place.allFinite());
    ASSERT_TRUE(!felt.IsValid || (felt.ProxyWorld.allFinite() && std::isfinite(felt.Depth)));
    with.Look(tick, place);
  }
}

// Looks beside ticks, as a worker does: with the bits of the whole field, as long as ticks wait
// where the worker is late.
TEST(OnDemandTracker, FeelsTheSameBitsWhileAnotherThreadLooks)
{
  OnDemandCase with(Gyroid(FieldInterpolation::Trilinear), ToolShape::Sphere(1.0), 0.35);
  Wanderer hand(*with.Whole, 100.0, 6204);
  std::atomic<int> ticks{0};
  std::atomic<int> looked{-1};
  std::vector<Vector3> places{hand.Here()};
  for (int tick = 1; tick < 1500; ++tick)
  {
    places.push_back(hand.Next());
  }
  std::thread worker(
      [&]
      {
        int last = -1;
        while (last + 1 < static_cast<int>(places.size()))
        {
          const int tick = ticks.load(std::memory_order_acquire);
          if (tick == last)
          {
            std::this_thread::yield();
            continue;
          }
          last = tick;
          with.Field->Look({Tick * tick, places[static_cast<std::size_t>(tick)]},
                           [tick] { return Tick * tick + 0.01; });
          looked.store(tick, std::memory_order_release);
        }
      });
  constexpr int Behind = 12; // ticks that the worker may be late
  int different = 0;
  for (int tick = 0; tick < static_cast<int>(places.size()); ++tick)
  {
    while (looked.load(std::memory_order_acquire) < std::max(0, tick - Behind))
    {
      std::this_thread::yield();
    }
    const Vector3& place = places[static_cast<std::size_t>(tick)];
    const Contact& expected = with.Expected->Follow(At(place));
    different += SameBits(with.Tracker->Follow(At(place)), expected) ? 0 : 1;
    ticks.store(tick, std::memory_order_release);
  }
  worker.join();
  EXPECT_EQ(different, 0);
  EXPECT_EQ(with.Field->Counts().CoarseTicks, 0u);
}

TEST(OnDemandField, TellsWhatItTakes)
{
  OnDemandCase with(Gyroid(FieldInterpolation::TricubicBSpline), ToolShape::Sphere(1.0), 0.1);
  const OnDemandContactModel model(with.Field);
  const std::size_t records = with.Survey->RecordCount() * with.Survey->Records().Bytes();
  EXPECT_GE(model.Bytes(), records / 10);
  // Here its source is in memory too, which a file is not.
  EXPECT_LT(model.Bytes(), records + records / 2);
  EXPECT_EQ(model.BoundsWorld().min(), FieldContact(with.Whole)->BoundsWorld().min());
  EXPECT_EQ(model.BoundsWorld().max(), FieldContact(with.Whole)->BoundsWorld().max());
}
} // namespace
} // namespace palpate
