// At any place, speed, shape and stiffness, contacts and forces are finite and bounded.
#include "ExtremeCases.h"
#include "ServoRun.h"
#include "WorstCase.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::touch_extremes_test
{
namespace
{
using test::At;
using test::ExtremeCenter;
using test::ExtremeShape;
using test::Random;
using test::Representation;
using test::WorstCase;

const char* const RepresentationNames[] = {"RadialNearest", "RadialByRadius", "Facets",
                                           "FieldProxy", "FieldShell"};
const char* const ShapeNames[] = {"Ball", "ThinWall", "Needle", "Cleft", "OneVoxel"};

class TouchExtremes : public ::testing::TestWithParam<std::tuple<Representation, ExtremeShape>>
{
protected:
  // Tools that this representation supports.
  std::vector<double> ToolRadii() const
  {
    const bool needsShell = std::get<0>(GetParam()) == Representation::FieldShell;
    return needsShell ? std::vector<double>{1.0} : std::vector<double>{0.0, 1.0};
  }
  std::unique_ptr<ContactTracker> TrackerFor(double toolRadius) const
  {
    return test::TrackerOf(*this->Case.Model, ToolShape::Sphere(toolRadius));
  }
  void ExpectBounded(const Vector3& probe, const Contact& contact, double toolRadius) const;

  const test::ExtremeCase Case =
      test::MakeExtremeCase(std::get<0>(GetParam()), std::get<1>(GetParam()));
};

// In contact the proxy is next to the structure; otherwise it is the probe itself.
void TouchExtremes::ExpectBounded(const Vector3& probe, const Contact& contact,
                                  double toolRadius) const
{
  ASSERT_TRUE(contact.IsValid);
  ASSERT_TRUE(contact.ProxyWorld.allFinite()) << probe.transpose();
  ASSERT_NEAR(contact.NormalWorld.norm(), 1.0, 1e-12) << probe.transpose(); // rounding
  if (!contact.IsTouching)
  {
    ASSERT_EQ(contact.ProxyWorld, probe);
    ASSERT_EQ(contact.Depth, 0.0);
    return;
  }
  // The skin between facets and tool is 1e-6 of their size.
  const double reach = toolRadius + 1e-4;
  ASSERT_LE(this->Case.Model->BoundsWorld().exteriorDistance(contact.ProxyWorld), reach)
      << probe.transpose();
  const double depth = (contact.ProxyWorld - probe).norm();
  ASSERT_NEAR(contact.Depth, depth, 1e-9 * (1.0 + depth)); // rounding
}

std::vector<Vector3> SpecialPlaces()
{
  std::vector<Vector3> places{ExtremeCenter};
  for (const Vector3& u : test::ProbingDirections())
  {
    for (const double distance :
         {1e-300, 1e-15, 1e-6, 0.25, 1.0, 8.999, 9.0, 10.0, 30.0, 1e4, 1e90})
    {
      places.push_back(ExtremeCenter + distance * u);
    }
  }
  return places;
}

// The centre, the axis, the poles, ten metres away and farther, from one to the other at once.
TEST_P(TouchExtremes, ToolStaysOutsideAtAnyPlaceInAnyOrder)
{
  const std::vector<Vector3> places = SpecialPlaces();
  for (const double toolRadius : this->ToolRadii())
  {
    Random random(8202);
    const auto tracker = this->TrackerFor(toolRadius);
    for (int tick = 0; tick < 1000; ++tick)
    {
      const Vector3& probe = places[random() % places.size()];
      const Contact& contact = tracker->Follow(At(probe));
      ASSERT_NO_FATAL_FAILURE(this->ExpectBounded(probe, contact, toolRadius)) << tick;
      if (random() % 8 == 0)
      {
        tracker->Release();
      }
    }
  }
}

TEST_P(TouchExtremes, NoContactTenMetresAway)
{
  for (const double toolRadius : this->ToolRadii())
  {
    const auto tracker = this->TrackerFor(toolRadius);
    for (const Vector3& u : test::ProbingDirections())
    {
      tracker->Follow(At(ExtremeCenter));
      tracker->Release();
      EXPECT_FALSE(tracker->Follow(At(ExtremeCenter + 1e4 * u)).IsTouching);
      EXPECT_FALSE(tracker->Follow(At(ExtremeCenter + 1e4 * u + u)).IsTouching);
    }
  }
}

TEST_P(TouchExtremes, DepthAtTheSurfaceIsWithinRounding)
{
  if (this->ToolRadii().front() > 0.0)
  {
    GTEST_SKIP() << "this method has no point tool";
  }
  const auto tracker = this->TrackerFor(0.0);
  WorstCase depth;
  for (const Vector3& point : this->Case.SurfacePoints)
  {
    const Vector3 outward = (point - ExtremeCenter).normalized();
    for (const double side : {1e300, -1e300})
    {
      Vector3 nearby = point;
      for (int axis = 0; axis < 3; ++axis)
      {
        nearby[axis] = std::nextafter(point[axis], std::copysign(side, side * outward[axis]));
      }
      tracker->Release();
      for (const Vector3& probe : {nearby, point, nearby})
      {
        const Contact& contact = tracker->Follow(At(probe));
        ASSERT_NO_FATAL_FAILURE(this->ExpectBounded(probe, contact, 0.0));
        depth.Add(contact.Depth);
      }
    }
  }
  // A twentieth of a voxel is required of fields; the others are far below.
  const bool isField = std::get<0>(GetParam()) == Representation::FieldProxy;
  EXPECT_LE(depth.Value(), isField ? 0.05 * 0.5 : 1e-4);
}

// Through the centre, along every direction. The tool may be held back on the side it came from.
TEST_P(TouchExtremes, ToolStaysOutsideAtAnySpeed)
{
  for (const double toolRadius : this->ToolRadii())
  {
    for (const double step : {1.0, 100.0}) // mm per tick: 1 m/s, 100 m/s
    {
      const auto check = [&](const Vector3& probe, const Contact& contact)
      { ASSERT_NO_FATAL_FAILURE(this->ExpectBounded(probe, contact, toolRadius)) << step; };
      for (const Vector3& u : test::ProbingDirections())
      {
        const auto tracker = this->TrackerFor(toolRadius);
        const Vector3 start = ExtremeCenter + 60.0 * u;
        const Vector3 end = ExtremeCenter - 50.0 * u;
        tracker->Follow(At(start));
        test::MoveStraight(*tracker, start, end, step, check);
        test::MoveStraight(*tracker, end, start, step, check);
      }
    }
  }
}

TEST_P(TouchExtremes, ToolLeavesOnItsSideAtAnySpeed)
{
  // The tip of one voxel slips in between the points of a shell, and may be held there until the
  // structure is out of reach, where the servo releases it.
  const bool isTrap =
      GetParam() == std::make_tuple(Representation::FieldProxy, ExtremeShape::OneVoxel);
  const auto ignore = [](const Vector3&, const Contact&) {};
  for (const double toolRadius : isTrap ? std::vector<double>{0.0} : this->ToolRadii())
  {
    for (const double step : {1.0, 100.0}) // mm per tick: 1 m/s, 100 m/s
    {
      for (const Vector3& place : this->Case.SurfacePoints)
      {
        const Vector3 u = (place - ExtremeCenter).normalized();
        const Vector3 start = place + (toolRadius + 60.0) * u;
        const Vector3 end = place + (toolRadius - 0.2) * u;
        const auto tracker = this->TrackerFor(toolRadius);
        tracker->Follow(At(start));
        test::MoveStraight(*tracker, start, end, step, ignore);
        test::MoveStraight(*tracker, end, start, step, ignore);
        for (int tick = 0; tick < 100; ++tick) // work left over from a tick
        {
          tracker->Follow(At(start));
        }
        EXPECT_FALSE(tracker->Follow(At(start)).IsTouching)
            << step << " " << toolRadius << " " << u.transpose();
      }
    }
  }
}

TEST_P(TouchExtremes, ForceIsFiniteAndWithinTheDevicesLimitForAnyStiffness)
{
  for (const double stiffness : {0.0, 0.5, 1e4}) // N/mm
  {
    for (const double toolRadius : this->ToolRadii())
    {
      TouchScene scene;
      scene.Tool = ToolShape::Sphere(toolRadius);
      scene.Structures.push_back({"extreme", this->Case.Model, {stiffness, 0.0}, {}});
      test::ServoRun run(scene);
      const double most = run.Device.Abilities.MaximumForce;
      // The farthest along x: not where a cleft closes, and nothing can be pressed.
      const auto& places = this->Case.SurfacePoints;
      const Vector3 surface =
          *std::max_element(places.begin(), places.end(),
                            [](const Vector3& a, const Vector3& b) { return a[0] < b[0]; });
      const Vector3 outward = (surface - ExtremeCenter).normalized();
      // From the side: what surrounds a tool at the start is silent.
      run.MoveAndRest(surface + 20.0 * Vector3::UnitX(), surface + (2.7 + toolRadius) * outward);
      double largest = 0.0;
      for (int tick = 0; tick < 1500; ++tick)
      {
        // In and out again at 50 mm/s and less, after the ramp.
        const double height = 1.2 + 1.5 * std::cos(2e-2 * tick);
        const Vector3 force = run.TickAt(surface + (height + toolRadius) * outward);
        ASSERT_TRUE(force.allFinite()) << tick;
        ASSERT_LE(force.norm(), most * (1.0 + 1e-12)) << tick; // rounding
        largest = std::max(largest, force.norm());
      }
      EXPECT_EQ(run.Loop.Latest().Safety.Fault, SafetyFault::None);
      EXPECT_EQ(largest > 0.0, stiffness > 0.0) << stiffness << " " << toolRadius;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, TouchExtremes,
    ::testing::Combine(::testing::Values(Representation::RadialNearest,
                                         Representation::RadialByRadius, Representation::Facets,
                                         Representation::FieldProxy, Representation::FieldShell),
                       ::testing::Values(ExtremeShape::Sphere, ExtremeShape::ThinWall,
                                         ExtremeShape::Needle, ExtremeShape::Cleft,
                                         ExtremeShape::OneVoxel)),
    [](const auto& each)
    {
      return std::string(RepresentationNames[static_cast<int>(std::get<0>(each.param))]) +
             ShapeNames[static_cast<int>(std::get<1>(each.param))];
    });
} // namespace
} // namespace palpate::touch_extremes_test
