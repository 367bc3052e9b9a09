#include "ContactCases.h"
#include "IcosahedronDirections.h"
#include "OrganContact.h"
#include "SimplePhantoms.h"
#include "SurfaceModelPath.h"
#include "SurfacePhantoms.h"
#include "SurfaceTouchTruth.h"
#include "WanderingHand.h"
#include "WedgePlaces.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace palpate::parametric_paths_test
{
namespace
{
using test::At;
using test::Random;
using test::TrackerOf;

std::shared_ptr<const ContactModel> PathContact(const SurfaceModel& surface)
{
  std::shared_ptr<const ContactModel> contact;
  const Status status = MakeOrganContact(surface, contact);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return contact;
}

std::shared_ptr<const TouchableSurfaceModel> PathSurfaceOf(const SurfaceModel& surface)
{
  std::shared_ptr<const TouchableSurfaceModel> touch;
  const Status status = TouchableSurfaceModel::Make(surface, touch);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return touch;
}

// Of 10^5 paths over phantoms and patients' zones by Testing/Benchmarks/SurfaceTouch.
TEST(SurfaceModelPaths, PathsAgreeWithSearchesOfTheWholeSurface)
{
  std::vector<test::NamedPhantom> phantoms = test::SimplePhantoms();
  phantoms.push_back({"CleftBlob", test::CleftBlob()});
  for (const auto& [name, surface] : phantoms)
  {
    const auto touch = PathSurfaceOf(surface);
    const auto model = PathContact(surface);
    for (const double toolRadius : {0.0, 1.0, 4.0})
    {
      Random random(9112);
      const auto tracker = TrackerOf(*model, ToolShape::Sphere(toolRadius));
      test::SurfaceTouchTruth truth(touch, toolRadius);
      test::SurfaceTouchTruth::Counts counts;
      for (int path = 0; path < 40; ++path)
      {
        tracker->Release();
        int tick = 0;
        bool isFree = false;
        test::FollowSurfacePath(surface, toolRadius, random,
                                [&](const Vector3& probe)
                                {
                                  const Contact& contact = tracker->Follow(At(probe));
                                  isFree = tick++ == 0 ? truth.Begin(probe) : isFree;
                                  if (isFree)
                                  {
                                    truth.Judge(probe, contact, counts);
                                  }
                                });
      }
      EXPECT_GT(counts.Unique, 38 * 20) << name << " " << toolRadius;
      EXPECT_EQ(counts.Inexact, 0) << name << " " << toolRadius << " " << counts.Error.Value();
      EXPECT_EQ(counts.Late, 0) << name << " " << toolRadius << " " << counts.LateDepth.Value();
      EXPECT_EQ(counts.Early, 0) << name << " " << toolRadius;
      // What an unknown wall may overlap, and more where the next proof found it.
      EXPECT_LE(counts.Overlap.Value(), 5e-3 * touch->SmallestRadius())
          << name << " " << toolRadius;
    }
  }
}

// Shortly above the centre of curvature of an ellipsoid's tip a place still has one nearest point,
// which moves many times faster than the place.
TEST(SurfaceModelPaths, AMinimumThatIsAboutToEndIsFollowed)
{
  const SurfaceModel surface = test::EllipsoidPhantom({5.0, 7.0, 20.0});
  const auto touch = PathSurfaceOf(surface);
  const auto model = PathContact(surface);
  const Vector3 tip(12.0, -7.0, 60.0);
  constexpr double Curvature = 5.0 * 5.0 / 20.0; // radius, mm
  for (const auto& [above, step] : {std::pair(0.01, 0.03), {1e-3, 1e-3}, {1e-4, 1e-3}}) // mm
  {
    const auto tracker = TrackerOf(*model, ToolShape::Sphere(0.0));
    test::WorstCase error;
    for (int tick = 0; tick < 40; ++tick)
    {
      const double depth = std::min(Curvature - above, 0.1 * tick - 0.23);
      const Vector3 probe =
          tip - depth * Vector3::UnitZ() + step * std::max(0, tick - 20) * Vector3::UnitX();
      const Contact& contact = tracker->Follow(At(probe));
      if (contact.IsTouching)
      {
        error.Add((contact.ProxyWorld - touch->Search().Nearest(probe, 20000).PointWorld).norm());
      }
    }
    EXPECT_LE(error.Value(), 2e-9) << above; // mm: 1e-9 N
  }
}

// All minima are about equal there, so that no proof ends.
TEST(SurfaceModelPaths, ContactBeginsInAHollowAsRoundAsTheTool)
{
  const SurfaceModel surface = test::Bowl();
  const auto touch = PathSurfaceOf(surface);
  const auto model = PathContact(surface);
  const Vector3 centre(-25.0, 0.0, 10.0); // of the hollow, 16 mm
  for (const double gap : {0.05, 0.1, 0.2, 0.4})
  {
    const double toolRadius = touch->Search().Nearest(centre).SignedDistance - gap;
    const auto tracker = TrackerOf(*model, ToolShape::Sphere(toolRadius));
    Random random(9113);
    int late = 0;
    int longest = 0;
    for (int path = 0; path < 25; ++path)
    {
      tracker->Release();
      const Vector3 along = test::RandomDirection(random);
      const double upwards = std::max(0.0, -along.z());
      for (double length = 0.0; length < gap + 1.0; length += 0.05)
      {
        const Vector3 probe = centre + length * (along + 2.0 * upwards * Vector3::UnitZ());
        const Contact& contact = tracker->Follow(At(probe));
        const double depth = toolRadius - touch->Search().Nearest(probe, 5000).SignedDistance;
        late = depth > 0.01 && !contact.IsTouching ? late + 1 : 0;
        longest = std::max(longest, late);
      }
    }
    EXPECT_LE(longest, 2) << gap; // ticks
  }
}
// Moves a parameter by about `length` (mm).
Vector3 MovedAlong(const SurfaceModel& surface, const Vector3& parameter, const Vector3& axis,
                   double length)
{
  constexpr double Angle = 1e-3;
  const Vector3 near = Eigen::AngleAxisd(Angle, axis) * parameter;
  const double moved = (surface.Point(near) - surface.Point(parameter)).norm();
  return (Eigen::AngleAxisd(Angle * length / moved, axis) * parameter).normalized();
}

// Next to a crossing a point moves by steps shorter than the margin, of which a tick takes several.
TEST(SurfaceModelPaths, APointNextToACrossingKeepsUpWithTheHand)
{
  constexpr double Speed = 0.2; // mm a tick
  constexpr int Ticks = 25;
  const SurfaceModel surface = test::CrossingRing();
  const auto touch = PathSurfaceOf(surface);
  const auto tracker = TrackerOf(*PathContact(surface), ToolShape::Sphere(0.0));
  const WedgePlaces places(*touch, 0.0, 0.0);
  const double room = 1.2 * touch->Margin();
  const auto isFree = [&](const Vector3& parameter)
  {
    const Vector3 above = surface.Point(parameter) + room * surface.Normal(parameter);
    const auto nearest = touch->SeenFrom(above, touch->Search().Nearest(above));
    return nearest.SignedDistance > 0.99 * room;
  };
  Random random(9114);
  test::WorstCase lag;
  int strokes = 0;
  for (int trial = 0; trial < 2000; ++trial)
  {
    Vector3 parameter = test::RandomDirection(random);
    const Vector3 axis = parameter.cross(test::RandomDirection(random)).normalized();
    tracker->Release();
    tracker->Follow(At(surface.Point(parameter) + 0.5 * surface.Normal(parameter)));
    int ticks = 0;
    while (ticks < Ticks && places.Contains(parameter) && isFree(parameter))
    {
      tracker->Follow(At(surface.Point(parameter) - 0.3 * surface.Normal(parameter)));
      parameter = MovedAlong(surface, parameter, axis, Speed);
      ++ticks;
    }
    if (ticks == Ticks)
    {
      const Vector3 probe = surface.Point(parameter) - 0.3 * surface.Normal(parameter);
      lag.Add((tracker->Follow(At(probe)).ProxyWorld - surface.Point(parameter)).norm());
      ++strokes;
    }
  }
  EXPECT_GT(strokes, 20);
  EXPECT_LE(lag.Value(), 0.5); // mm
}
// An ellipsoid with relief of every degree, that crosses itself in many places.
SurfaceModel CrossingRelief()
{
  constexpr double Relief = 3.0; // mm
  Random random(3);
  const SurfaceModel smooth = test::EllipsoidPhantom({25.0, 18.0, 9.0}, 16);
  std::array<std::vector<double>, 3> coefficients;
  for (int coordinate = 0; coordinate < 3; ++coordinate)
  {
    std::vector<double>& values = coefficients[static_cast<std::size_t>(coordinate)];
    values = smooth.Coefficients(coordinate);
    const std::vector<double> relief = test::RandomCoefficients(random, 16, 1.0);
    for (std::size_t i = 4; i < values.size(); ++i)
    {
      values[i] += Relief * relief[i];
    }
  }
  return {16, coefficients};
}

// A point is followed by its nearest point alone elsewhere.
TEST(SurfaceModelPaths, MostPlacesWithoutRoomForTheMarginAreKnownAtCrossings)
{
  const auto touch = PathSurfaceOf(CrossingRelief());
  const WedgePlaces places(*touch, 0.0, 0.25 * touch->SmallestRadius());
  const double margin = touch->Margin();
  int narrow = 0;
  int missed = 0;
  const IcosahedronDirections sphere(30);
  for (const Vector3& parameter : sphere.Directions())
  {
    const auto place = touch->PlaceAt(parameter);
    const auto nearest = touch->Search().Nearest(place.PointWorld + margin * place.Normal);
    const bool isNarrow = std::abs(nearest.SignedDistance) < 0.99 * margin;
    narrow += isNarrow ? 1 : 0;
    missed += isNarrow && !places.Contains(parameter) ? 1 : 0;
  }
  EXPECT_GT(narrow, 100);
  EXPECT_LT(missed, 0.1 * narrow);
}

// Next to where a surface crosses itself proofs hardly ever end. A tool that cannot go on is in
// contact; one that waited would be pressed in without a force.
TEST(SurfaceModelPaths, NoToolIsPressedInWithoutAForceNextToACrossing)
{
  const SurfaceModel surface = CrossingRelief();
  const auto touch = PathSurfaceOf(surface);
  ASSERT_TRUE(touch->CrossesItself());
  const auto tracker = TrackerOf(*PathContact(surface), ToolShape::Sphere(0.0));
  Random random(9202);
  test::WanderingHand hand(surface, 0.0, random);
  int pressed = 0;
  int longest = 0;
  for (int tick = 0; tick < 15000; ++tick)
  {
    const Vector3 probe = hand.Next();
    const bool isTouching = tracker->Follow(At(probe)).IsTouching;
    const auto depth = [&]
    { return -touch->SeenFrom(probe, touch->Search().Nearest(probe, 5000)).SignedDistance; };
    pressed = !isTouching && depth() > 0.5 ? pressed + 1 : 0;
    longest = std::max(longest, pressed);
  }
  EXPECT_LE(longest, 3); // ticks
}

// A tool that starts inside is moved out of one sheet, and must not get through the other one: it
// would be free inside, and held by walls from their inner sides.
TEST(SurfaceModelPaths, NoToolThatStartsNextToACrossingIsFreeInside)
{
  const SurfaceModel surface = CrossingRelief();
  const auto touch = PathSurfaceOf(surface);
  const auto depthOf = [&](const Vector3& place)
  { return -touch->SeenFrom(place, touch->Search().Nearest(place, 5000)).SignedDistance; };
  const auto tracker = TrackerOf(*PathContact(surface), ToolShape::Sphere(0.0));
  const std::vector<Vector3>& crossings = touch->CrossingsWorld();
  Random random(9203);
  int starts = 0;
  int freeInside = 0;
  for (int trial = 0; trial < 600; ++trial)
  {
    Vector3 probe = crossings[random() % crossings.size()] + test::RandomDirection(random);
    const Vector3 step = 0.04 * test::RandomDirection(random); // mm
    tracker->Release();
    starts += depthOf(probe) > 0.2 ? 1 : 0;
    for (int tick = 0; tick < 25 && depthOf(probe) > 0.2; ++tick)
    {
      freeInside += tracker->Follow(At(probe)).IsTouching ? 0 : 1;
      probe += step;
    }
  }
  EXPECT_GT(starts, 100);
  EXPECT_EQ(freeInside, 0);
}
} // namespace
} // namespace palpate::parametric_paths_test
