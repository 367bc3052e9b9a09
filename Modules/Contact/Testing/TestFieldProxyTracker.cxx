#include "FieldContactCases.h"
#include "RandomOrientation.h"
#include "WorstCase.h"

#include <algorithm>
#include <limits>

namespace palpate::field_proxy_tracker_test
{
namespace
{
using test::At;
using test::FieldContact;
using test::FineGrid;
using test::Random;
using test::SampledField;
using test::TrackerOf;
using test::WorstCase;

constexpr double VoxelSize = 0.5; // mm
// Convergence tolerance: steps of a thousandth of a voxel.
constexpr double SolvingError = 2e-3 * VoxelSize;

// A wedge-shaped cleft along y, open to +z, whose walls stand at 45 degrees; index coordinates.
struct CleftField
{
  Vector3 Bottom = Vector3::Constant(24.0);

  double Value(const Vector3& p) const
  {
    return (std::abs(p[0] - this->Bottom[0]) - (p[2] - this->Bottom[2])) / std::sqrt(2.0);
  }
};

// A plate of this thickness across z.
struct PlateField
{
  double Center = 24.0;
  double Thickness = 1.0;

  double Value(const Vector3& p) const
  {
    return 0.5 * this->Thickness - std::abs(p[2] - this->Center);
  }
};

// A box with half axes in index coordinates.
struct BoxField
{
  Vector3 Center;
  Vector3 HalfSize;

  double Value(const Vector3& p) const
  {
    return (this->HalfSize - (p - this->Center).cwiseAbs()).minCoeff();
  }
};

TEST(FieldProxyTracker, DeepestSpherePointLiesOnTheFieldsSurface)
{
  Random random(5301);
  const FieldGrid grid = FineGrid(48);
  const ToolShape dense = ToolShape::SpherePoints(1.0, 2000);
  for (const auto method : {FieldInterpolation::Trilinear, FieldInterpolation::TricubicBSpline})
  {
    const auto field = SampledField(grid, test::GyroidField{24.0}, method);
    const FieldSampler sampler(field);
    const auto model = FieldContact(field);
    for (const double radius : {0.0, 0.6, 1.0})
    {
      const auto tracker = TrackerOf(*model, ToolShape::Sphere(radius));
      WorstCase inside;
      WorstCase apart;
      int touching = 0;
      for (int path = 0; path < 10; ++path)
      {
        Vector3 probe = grid.PointWorld(Vector3(24, 24, 24) + 8.0 * test::RandomDirection(random));
        const Vector3 velocity = 0.05 * test::RandomDirection(random);
        Vector3 before = probe;
        tracker->Release();
        for (int tick = 0; tick < 150; ++tick)
        {
          probe += velocity;
          const Contact& contact = tracker->Follow(At(probe));
          // After a start inside, or the loss of its minimum, the proxy moves for some ticks; and a
          // deep one must not reach the far side.
          const bool isMoving = tick < 20 || (contact.ProxyWorld - before).norm() > 0.5;
          before = contact.ProxyWorld;
          if (isMoving || !contact.IsTouching || contact.Depth > 2.0)
          {
            continue;
          }
          double nearest = std::numeric_limits<double>::infinity();
          for (const Vector3& point : dense.Points())
          {
            const Vector3 place = contact.ProxyWorld + radius * point;
            nearest = std::min(nearest, test::FieldDistance(sampler, place));
          }
          inside.Add(std::min(0.0, nearest) / VoxelSize);
          apart.Add(std::max(0.0, nearest) / VoxelSize);
          ++touching;
        }
      }
      EXPECT_GT(touching, 200);
      EXPECT_LE(inside.Value(), 0.05) << radius; // the required accuracy, in voxels
      EXPECT_LE(apart.Value(), 0.05) << radius;
    }
  }
}

// Also far from all of its points: 26 of them leave up to 0.23 mm of a sphere of 2 mm undetected.
TEST(FieldProxyTracker, SparseSphereTouchesWhereTheSphereDoes)
{
  constexpr double Radius = 2.0; // mm
  constexpr double Step = 0.01;  // mm per tick
  Random random(5309);
  const FieldGrid grid = FineGrid(48);
  for (int n = 0; n < 50; ++n)
  {
    const Vector3 outward = test::RandomDirection(random);
    // A plane through the centre of the grid.
    const test::PlaneField plane{-outward, -outward.dot(Vector3::Constant(24.0))};
    const auto model = FieldContact(SampledField(grid, plane));
    const auto tracker = TrackerOf(*model, ToolShape::SpherePoints(Radius, 26));
    const Vector3 middle = grid.PointWorld(Vector3::Constant(24.0));
    double height = Radius + 0.3;
    while (!tracker->Follow(At(middle + height * outward)).IsTouching && height > 0.0)
    {
      height -= Step;
    }
    EXPECT_LE(height, Radius + SolvingError) << outward.transpose();
    EXPECT_GE(height, Radius - Step - SolvingError) << outward.transpose();
  }
}

TEST(FieldProxyTracker, PointProxyIsNearestOnASphereToFourthOrder)
{
  Random random(5302);
  const FieldGrid grid = FineGrid(64);
  const Vector3 middle(31.3, 32.1, 30.7);
  const auto field =
      SampledField(grid, test::SphereField{middle, 24.0}, FieldInterpolation::TricubicBSpline);
  const auto model = FieldContact(field);
  for (const double radius : {0.0, 1.0, 4.0})
  {
    const auto tracker = TrackerOf(*model, ToolShape::SpherePoints(radius, 26));
    test::WanderingDirection wandering(random);
    WorstCase error;
    for (int tick = 0; tick < 400; ++tick)
    {
      const Vector3 u = wandering.Next(0.004);
      const Vector3 surface = grid.PointWorld(middle) + (12.0 + radius) * u;
      const Contact& contact = tracker->Follow(At(surface - 1.5 * u));
      if (tick >= 10) // it starts inside
      {
        ASSERT_TRUE(contact.IsTouching);
        error.Add((contact.ProxyWorld - surface).norm());
      }
    }
    // Contact points move once per tick, so a tool's normal lags by one: 0.048 mm per tick bend a
    // proxy 4 mm away by up to a few um more than the solver's tolerance.
    EXPECT_LE(error.Value(), SolvingError + 1e-3 * radius) << radius;
  }
}

TEST(FieldProxyTracker, RestsOnBothWallsOfACleft)
{
  const FieldGrid grid = FineGrid(48);
  const auto model = FieldContact(SampledField(grid, CleftField()));
  for (const double radius : {0.5, 1.0, 2.0})
  {
    for (const double aside : {0.0, 0.1, -0.3}) // mm
    {
      const auto tracker = TrackerOf(*model, ToolShape::Sphere(radius));
      const Vector3 bottom = grid.PointWorld(Vector3::Constant(24.0));
      const Vector3 rest = bottom + Vector3(0.0, 0.0, radius * std::sqrt(2.0));
      const Vector3 probe = bottom + Vector3(aside, 0.2, radius * std::sqrt(2.0) - 1.0);
      tracker->Follow(At(rest + Vector3(aside, 0.0, 1.5)));
      Contact last;
      test::MoveStraight(*tracker, rest + Vector3(aside, 0.0, 1.5), probe, 0.05,
                         [&](const Vector3&, const Contact& contact) { last = contact; });
      ASSERT_TRUE(last.IsTouching);
      // The crease is interpolated within one voxel, which no contact point of these reaches.
      EXPECT_NEAR(last.ProxyWorld[0], rest[0], SolvingError) << radius;
      EXPECT_NEAR(last.ProxyWorld[1], probe[1], SolvingError) << radius;
      EXPECT_NEAR(last.ProxyWorld[2], rest[2], SolvingError) << radius;
      EXPECT_NEAR(last.Depth, std::hypot(1.0, aside), 2.0 * SolvingError) << radius;
    }
  }
}

TEST(FieldProxyTracker, DoesNotEnterANarrowSlot)
{
  // A slot 1.5 mm wide, and a sphere of 2 mm. Its edges are interpolated, so the lowest place of
  // the sphere is found by trial.
  struct SlotField
  {
    double Value(const Vector3& p) const
    {
      return std::min(std::abs(p[0] - 24.0) - 1.5, 24.0 - p[2]);
    }
  };
  const FieldGrid grid = FineGrid(48);
  const auto field = SampledField(grid, SlotField());
  const FieldSampler sampler(field);
  const ToolShape dense = ToolShape::SpherePoints(1.0, 4000);
  const Vector3 mouth = grid.PointWorld(Vector3::Constant(24.0));
  Vector3 lowest = mouth + Vector3(0.0, 0.0, 2.0);
  const auto isFree = [&](const Vector3& place)
  {
    return std::none_of(dense.Points().begin(), dense.Points().end(),
                        [&](const Vector3& point)
                        { return sampler.IsInsideWorld(0, place + point); });
  };
  while (isFree(lowest))
  {
    lowest[2] -= 1e-3;
  }
  const auto tracker = TrackerOf(*FieldContact(field), ToolShape::Sphere(1.0));
  const Vector3 above = mouth + Vector3(0.0, 0.0, 3.0);
  const Vector3 below = mouth - Vector3(0.0, 0.0, 2.0);
  tracker->Follow(At(above));
  Contact last;
  test::MoveStraight(*tracker, above, below, 0.05,
                     [&](const Vector3&, const Contact& contact) { last = contact; });
  ASSERT_TRUE(last.IsTouching);
  EXPECT_NEAR(last.ProxyWorld[2], lowest[2], 0.05 * VoxelSize); // the required accuracy
  EXPECT_NEAR(last.ProxyWorld[0], mouth[0], 0.05 * VoxelSize);
}

TEST(FieldProxyTracker, OneVoxelWallStopsToolsAtAnySpeed)
{
  Random random(5303);
  const FieldGrid grid = FineGrid(48);
  const auto model = FieldContact(SampledField(grid, PlateField()));
  const double wall = grid.PointWorld(Vector3::Constant(24.0))[2];
  for (const double radius : {0.0, 0.5, 2.0})
  {
    for (const double step : {0.02, 0.1, 1.0, 10.0, 100.0}) // mm per tick: up to 100 m/s at 1 kHz
    {
      const auto tracker = TrackerOf(*model, ToolShape::Sphere(radius));
      const Vector3 aside = 2.0 * test::RandomDirection(random);
      const Vector3 place = grid.PointWorld(Vector3::Constant(24.0)) + aside;
      const Vector3 above(place[0], place[1], wall + radius + 5.0);
      const Vector3 beyond(place[0] + 1.0, place[1], wall - radius - 3.0);
      tracker->Follow(At(above));
      Contact last;
      test::MoveStraight(*tracker, above, beyond, step,
                         [&](const Vector3&, const Contact& contact) { last = contact; });
      for (int tick = 0; tick < 20; ++tick) // work left over from a tick
      {
        last = tracker->Follow(At(beyond));
      }
      ASSERT_TRUE(last.IsTouching) << radius << " " << step;
      EXPECT_NEAR(last.ProxyWorld[2], wall + radius + 0.25, SolvingError) << radius << " " << step;
      EXPECT_NEAR(last.ProxyWorld[0], beyond[0], SolvingError) << radius << " " << step;
    }
  }
}

TEST(FieldProxyTracker, TouchesAOneVoxelStructure)
{
  const FieldGrid grid = FineGrid(9);
  std::vector<float> samples(grid.NodeCount(), -1.0f);
  samples[samples.size() / 2] = 1.0f; // an octahedron-like body, half a voxel wide
  const auto field = test::MakeField(grid, samples, 0.0);
  const FieldSampler sampler(field);
  const auto model = FieldContact(field);
  const Vector3 voxel = grid.PointWorld(Vector3::Constant(4.0));
  for (const double radius : {0.0, 0.3, 2.0})
  {
    // So small an object slips between 400 points of the largest one.
    const auto tracker = TrackerOf(*model, ToolShape::SpherePoints(radius, 4000));
    const Vector3 above = voxel + Vector3(0.0, 0.0, radius + 1.0);
    const Vector3 pressed = voxel + Vector3(0.0, 0.0, radius + 0.1);
    tracker->Follow(At(above));
    Contact last;
    test::MoveStraight(*tracker, above, pressed, 0.02,
                       [&](const Vector3&, const Contact& contact) { last = contact; });
    ASSERT_TRUE(last.IsTouching) << radius;
    EXPECT_GT(last.Depth, 0.05) << radius;
    EXPECT_GT(last.ProxyWorld[2], voxel[2]) << radius;
    if (radius == 0.0)
    {
      EXPECT_LE(std::abs(test::FieldDistance(sampler, last.ProxyWorld)), 0.05 * VoxelSize);
    }
  }
}

TEST(FieldProxyTracker, CapsuleTurnedIntoTheSurfaceIsPushedOut)
{
  const FieldGrid grid = FineGrid(48);
  const auto model = FieldContact(SampledField(grid, test::PlaneField{-Vector3::UnitZ(), -24.0}));
  const double top = grid.PointWorld(Vector3::Constant(24.0))[2];
  const double radius = 0.5;
  const double length = 4.0;
  const auto tracker = TrackerOf(*model, ToolShape::Capsule(radius, length, 200));
  ToolPose pose = At(grid.PointWorld({24.0, 24.0, 24.0}) + Vector3(0.0, 0.0, 1.0));
  const Eigen::Quaterniond lying(Eigen::AngleAxisd(0.5 * M_PI, Vector3::UnitX()));
  pose.Orientation = lying;
  EXPECT_FALSE(tracker->Follow(pose).IsTouching);
  for (double angle = 0.5 * M_PI; angle > 0.0; angle -= 0.01)
  {
    pose.Orientation = Eigen::AngleAxisd(angle, Vector3::UnitX());
    const Contact& contact = tracker->Follow(pose);
    const double reach = radius + 0.5 * length * std::cos(angle);
    // 200 points are 0.28 mm apart, so none may be nearer to the lowest place of an end than
    // 0.2 mm: there the end rises by 0.2^2 / 2 radius.
    EXPECT_NEAR(contact.ProxyWorld[2], std::max(pose.PositionWorld[2], top + reach), 0.04) << angle;
  }
}

TEST(FieldProxyTracker, SolidEndsAtTheGridBorder)
{
  const FieldGrid grid = FineGrid(24);
  // The material continues beyond the grid at z = 0.
  const auto model = FieldContact(SampledField(grid, test::PlaneField{-Vector3::UnitZ(), -12.0}));
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(0.5));
  const Vector3 bottom = grid.PointWorld({12.0, 12.0, 0.0});
  tracker->Follow(At(bottom - Vector3(0.0, 0.0, 2.0)));
  Contact last;
  test::MoveStraight(*tracker, bottom - Vector3(0.0, 0.0, 2.0), bottom + Vector3(0.0, 0.0, 0.5),
                     0.05, [&](const Vector3&, const Contact& contact) { last = contact; });
  ASSERT_TRUE(last.IsTouching);
  EXPECT_NEAR(last.ProxyWorld[2], bottom[2] - 0.5, SolvingError);
  EXPECT_NEAR(last.NormalWorld[2], -1.0, 1e-6); // of one plane, except for rounding
}

TEST(FieldProxyTracker, GridBorderWithoutMaterialIsNoWall)
{
  // A sphere close to the side of its grid, and a tool that extends beyond that.
  const FieldGrid grid = FineGrid(24);
  const Vector3 middle(5.5, 12.0, 12.0);
  const auto model = FieldContact(
      SampledField(grid, test::SphereField{middle, 4.0}, FieldInterpolation::TricubicBSpline));
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(2.0));
  const Vector3 place = grid.PointWorld(middle);
  tracker->Follow(At(place - Vector3(5.0, 0.0, 0.0)));
  WorstCase error;
  for (int tick = 0; tick <= 300; ++tick)
  {
    const double angle = 0.005 * tick;
    const Vector3 u(-std::cos(angle), std::sin(angle), 0.0);
    const Contact& contact = tracker->Follow(At(place + 3.5 * u)); // 0.5 mm deep
    ASSERT_TRUE(contact.IsTouching);
    error.Add((contact.ProxyWorld - place - 4.0 * u).norm());
  }
  // Error of the cubic for a sphere of four voxels.
  EXPECT_LE(error.Value(), 0.03);
}

TEST(FieldProxyTracker, BothConditionsOfAMaterialAreWalls)
{
  const FieldGrid grid = FineGrid(32);
  const auto first =
      test::SampleAtIndices<float>(grid.Size(), test::PlaneField{-Vector3::UnitZ(), -16.0});
  const auto second =
      test::SampleAtIndices<float>(grid.Size(), test::PlaneField{-Vector3::UnitX(), -16.0});
  FieldBuilder builder(grid);
  const int one = builder.AddChannel(SamplesOfGrid(first.data(), grid));
  const int other = builder.AddChannel(SamplesOfGrid(second.data(), grid));
  builder.AddMaterial({one, 0.0, FieldSense::AtLeast}, {other, 0.0, FieldSense::AtLeast});
  std::shared_ptr<const ScalarField> field;
  ASSERT_TRUE(builder.Build(field).IsOk());
  const auto model = FieldContact(field);
  const Vector3 edge = grid.PointWorld({16.0, 16.0, 16.0});
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(0.0));
  for (const Vector3& out : {Vector3(0.0, 0.0, 1.0), Vector3(1.0, 0.0, 0.0)})
  {
    const Vector3 surface = edge - 3.0 * (Vector3(1.0, 0.0, 1.0) - out);
    tracker->Release();
    tracker->Follow(At(surface + out));
    Contact last;
    test::MoveStraight(*tracker, surface + out, surface - out, 0.05,
                       [&](const Vector3&, const Contact& contact) { last = contact; });
    EXPECT_LE((last.ProxyWorld - surface).norm(), SolvingError);
    EXPECT_LE((last.NormalWorld - out).norm(), 1e-6); // of one plane, except for rounding
  }
}

TEST(FieldProxyTracker, SticksWithinTheFrictionConeAndSlipsToIt)
{
  const FieldGrid grid = FineGrid(48);
  const auto model = FieldContact(SampledField(grid, test::PlaneField{-Vector3::UnitZ(), -24.0}));
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(0.5), {0.5, 0.3});
  const Vector3 rest = grid.PointWorld({24.0, 24.0, 24.0}) + Vector3(0.0, 0.0, 0.5);
  tracker->Follow(At(rest + Vector3(0.0, 0.0, 0.5)));
  test::MoveStraight(*tracker, rest + Vector3(0.0, 0.0, 0.5), rest - Vector3(0.0, 0.0, 1.0), 0.05,
                     [](const Vector3&, const Contact&) {});
  const Vector3 held = tracker->Follow(At(rest - Vector3(0.0, 0.0, 1.0))).ProxyWorld;
  EXPECT_LE((held - rest).norm(), SolvingError);
  const Vector3 within = tracker->Follow(At(rest + Vector3(0.49, 0.0, -1.0))).ProxyWorld;
  EXPECT_EQ(within, held);
  const Vector3 slipped = tracker->Follow(At(rest + Vector3(0.6, 0.0, -1.0))).ProxyWorld;
  EXPECT_NEAR(slipped[0], rest[0] + 0.3, 2.0 * SolvingError);
}

TEST(FieldProxyTracker, IsIndependentOfTheUnitOfLength)
{
  for (const double scale : {0x1p-10, 1.0, 0x1p10}) // powers of two change no digit
  {
    Random random(5304);
    const FieldGrid grid = FineGrid(48);
    const FieldGrid other(grid.Size(), scale * grid.OriginWorld(), scale * grid.Spacing(),
                          Matrix3::Identity());
    const auto here = TrackerOf(*FieldContact(SampledField(grid, test::GyroidField{24.0})),
                                ToolShape::Sphere(1.0));
    const auto there = TrackerOf(*FieldContact(SampledField(other, test::GyroidField{24.0})),
                                 ToolShape::Sphere(scale));
    Vector3 probe = grid.PointWorld(Vector3::Constant(24.0));
    for (int tick = 0; tick < 500; ++tick)
    {
      probe += 0.3 * test::RandomDirection(random);
      const Contact& one = here->Follow(At(probe));
      const Contact& two = there->Follow(At(scale * probe));
      ASSERT_EQ(one.IsTouching, two.IsTouching) << tick;
      ASSERT_LE((one.ProxyWorld - two.ProxyWorld / scale).norm(), 1e-9) << tick; // rounding
    }
  }
}

TEST(FieldProxyTracker, ResultsAreFiniteForAnyPose)
{
  Random random(5305);
  const FieldGrid grid = FineGrid(32);
  const auto field = SampledField(grid, BoxField{Vector3::Constant(15.5), {9.0, 5.0, 12.0}});
  const auto model = FieldContact(field);
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  const Vector3 middle = grid.PointWorld(Vector3::Constant(15.5));
  for (const ToolShape& tool :
       {ToolShape::Sphere(0.0), ToolShape::Sphere(1.0), ToolShape::Ellipsoid({0.5, 1.0, 2.0}, 60)})
  {
    const auto tracker = TrackerOf(*model, tool);
    for (int tick = 0; tick < 1500; ++tick)
    {
      const double far = std::pow(10.0, static_cast<double>(random() % 6) - 1.0);
      ToolPose pose = At(middle + far * test::RandomDirection(random));
      pose.Orientation = test::RandomOrientation(random);
      const bool isBad = random() % 50 == 0;
      pose.PositionWorld[1] = isBad ? notANumber : pose.PositionWorld[1];
      const Contact& contact = tracker->Follow(pose);
      ASSERT_EQ(contact.IsValid, !isBad);
      ASSERT_TRUE(contact.ProxyWorld.allFinite());
      ASSERT_NEAR(contact.NormalWorld.norm(), 1.0, 1e-12); // rounding
      ASSERT_FALSE(isBad && contact.IsTouching);
      if (random() % 20 == 0)
      {
        tracker->Release();
      }
    }
  }
}

TEST(FieldProxyTracker, StartingDeepInsideFindsAnExit)
{
  const FieldGrid grid = FineGrid(64);
  const auto model = FieldContact(SampledField(
      grid, test::SphereField{Vector3::Constant(32.0), 25.0}, FieldInterpolation::TricubicBSpline));
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(1.0));
  const Vector3 middle = grid.PointWorld(Vector3::Constant(32.0));
  Contact last;
  for (int tick = 0; tick < 50; ++tick)
  {
    last = tracker->Follow(At(middle + Vector3(0.0, 2.0, 0.0)));
  }
  ASSERT_TRUE(last.IsTouching);
  EXPECT_NEAR((last.ProxyWorld - middle).norm(), 13.5,
              0.02); // solving ends at steps, which depth enlarges sixfold
  EXPECT_NEAR((last.ProxyWorld - middle)[1], 13.5, 0.02);
}

TEST(FieldSolid, GridBorderIsAWallOnlyNextToMaterial)
{
  const FieldGrid grid = FineGrid(24);
  std::shared_ptr<const FieldSolid> solid;
  ASSERT_TRUE(
      FieldSolid::Make(SampledField(grid, test::PlaneField{-Vector3::UnitZ(), -12.0}), 0, solid)
          .IsOk());
  const FieldSolid::Wall next =
      solid->WallNear(grid.PointWorld({-0.5, 12.0, 6.0}), Vector3::UnitX());
  EXPECT_TRUE(next.IsKnown);
  EXPECT_NEAR(next.Distance, 0.5 * VoxelSize, 1e-12); // rounding
  EXPECT_EQ(next.Normal, Vector3(-Vector3::UnitX()));
  EXPECT_FALSE(solid->WallNear(grid.PointWorld({-0.5, 12.0, 18.0}), Vector3::UnitX()).IsKnown);
}

TEST(FieldContactModel, ShellsMatchVoxelsAndUnknownMaterialIsRejected)
{
  EXPECT_EQ(FieldContactModel::PointCountFor(0.0, 0.5), 6);
  EXPECT_EQ(FieldContactModel::PointCountFor(1.0, 1.0), 80);
  EXPECT_EQ(FieldContactModel::PointCountFor(100.0, 0.5), 400);
  const FieldGrid grid = FineGrid(24);
  const auto field = SampledField(grid, test::SphereField{Vector3::Constant(12.0), 5.0});
  for (const int material : {-1, 1})
  {
    std::shared_ptr<const ContactModel> model;
    EXPECT_FALSE(FieldContactModel::Make(field, material, model).IsOk());
  }
  const Eigen::AlignedBox3d bounds = FieldContact(field)->BoundsWorld();
  EXPECT_TRUE(bounds.contains(grid.PointWorld(Vector3(7.0, 7.0, 7.0))));
  EXPECT_TRUE(bounds.contains(grid.PointWorld(Vector3(17.0, 17.0, 17.0))));
  EXPECT_TRUE(bounds.max().isApprox(grid.PointWorld(Vector3::Constant(23.0))));
}
} // namespace
} // namespace palpate::field_proxy_tracker_test
