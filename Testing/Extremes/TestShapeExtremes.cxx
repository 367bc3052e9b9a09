// The nearest point and touch on shapes that are flat, thin, tiny, huge and far away.
#include "ClosestPointSearch.h"
#include "ContactCases.h"
#include "SlenderBodies.h"
#include "WorstCase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace palpate::shape_extremes_test
{
namespace
{
using test::At;
using test::Random;
using test::SlenderBody;
using test::WorstCase;

// Documented bounds for a body, mm.
struct SlenderCase
{
  std::string Name;
  SlenderBody Body;
  double Unproven; ///< left open by the search at an ordinary place
  double Overlap;  ///< of a sphere that is too large for the hollows
};

void PrintTo(const SlenderCase& c, std::ostream* stream)
{
  *stream << c.Name;
}

// For bodies of 10 mm. Ten to one at degree 12 is proven except for parts in 10,000, where the
// evaluation limit is reached before the proof is complete; for forty to one at degree 40 one per
// cent is left open. The same holds where whole circles of a body are equally near.
constexpr double Rounding = 1e-9;
constexpr double TouchingGap = 1e-6; // of the tracker: 1e-6 of the smallest radius
constexpr double PartIn10000 = 1e-3;
constexpr double OnePerCent = 0.1;
const SlenderCase SlenderCases[] = {
    {"NeedleTenToOne", {true, 12, 10.0, 1.0}, PartIn10000, OnePerCent},
    {"DiscTenToOne", {false, 12, 10.0, 1.0}, PartIn10000, TouchingGap},
    {"NeedleFortyToOne", {true, 40, 10.0, 0.25}, OnePerCent, OnePerCent},
    {"DiscFortyToOne", {false, 40, 10.0, 0.25}, OnePerCent, OnePerCent}};

class SlenderShapes : public ::testing::TestWithParam<SlenderCase>
{
protected:
  const RadialModel Model = GetParam().Body.Model({3.0, -7.0, 11.0});
};

// Near the surface and around the body.
std::vector<Vector3> OrdinaryPlaces(const RadialModel& model)
{
  Random random(8810);
  std::vector<Vector3> places;
  std::uniform_real_distribution<double> height(-0.2, 3.0);
  for (int n = 0; n < 40; ++n)
  {
    const Vector3 u = test::RandomDirection(random);
    places.push_back(model.PointWorld(u) + height(random) * model.Normal(u));
    places.push_back(model.CenterWorld() + 12.0 * test::RandomDirection(random));
  }
  return places;
}

// At a tip and at the rim, on the axis, and at the centre.
std::vector<Vector3> SpecialPlaces(const RadialModel& model)
{
  std::vector<Vector3> places;
  for (const Vector3& u : {Vector3(0, 0, 1), Vector3(1, 0, 0), Vector3(0, -1, 0)})
  {
    for (const double distance : {0.0, 1e-9, 0.25, 5.0, 9.999999, 10.000001, 15.0})
    {
      places.push_back(model.CenterWorld() + distance * u);
    }
  }
  return places;
}

void ExpectAsNearAsItSays(const RadialModel& model, const std::vector<Vector3>& places,
                          double unproven)
{
  const ClosestPointSearch search(test::Shared(model));
  for (const Vector3& place : places)
  {
    const ClosestPoint found = search.Nearest(place);
    ASSERT_NE(found.State, ClosestPoint::Outcome::BadInput);
    const double excess = std::abs(found.SignedDistance) - test::DistanceInMeridian(model, place);
    // Both by minimisation in double, whose squares are accurate to 1e-14 of 100 mm^2.
    EXPECT_GE(excess, -Rounding) << place.transpose();
    EXPECT_LE(excess, found.DistanceError + Rounding) << place.transpose();
    EXPECT_LE(found.DistanceError, unproven) << place.transpose();
  }
}

TEST_P(SlenderShapes, NearestPointIsWithinItsErrorBound)
{
  ExpectAsNearAsItSays(this->Model, OrdinaryPlaces(this->Model), GetParam().Unproven);
  ExpectAsNearAsItSays(this->Model, SpecialPlaces(this->Model), OnePerCent);
}

TEST_P(SlenderShapes, PointLiesOnTheSurfaceAndSphereHardlyOverlaps)
{
  Random random(8811);
  const auto contact = test::RadialContact(this->Model);
  for (const double radius : {0.0, 0.2, 1.0})
  {
    const auto tracker = test::TrackerOf(*contact, ToolShape::Sphere(radius));
    WorstCase overlap;
    int touches = 0;
    for (int n = 0; n < 10; ++n)
    {
      const Vector3 u = test::RandomDirection(random);
      const Vector3 normal = this->Model.Normal(u);
      const auto place = [&](double height)
      { return Vector3(this->Model.PointWorld(u) + (radius + height) * normal); };
      tracker->Release();
      tracker->Follow(At(place(4.0)));
      const auto check = [&](const Vector3&, const Contact& felt)
      {
        ASSERT_TRUE(felt.IsValid);
        touches += felt.IsTouching ? 1 : 0;
        const double distance = test::DistanceInMeridian(this->Model, felt.ProxyWorld);
        overlap.Add(std::max(0.0, radius - distance));
      };
      test::MoveStraight(*tracker, place(4.0), place(0.1), 0.2, [](const auto&, const auto&) {});
      test::MoveStraight(*tracker, place(0.1), place(-0.1), 0.05, check);
    }
    EXPECT_GE(touches, 15) << radius;
    EXPECT_LE(overlap.Value(), radius > 0.0 ? GetParam().Overlap : TouchingGap) << radius;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, SlenderShapes, ::testing::ValuesIn(SlenderCases),
                         [](const auto& each) { return each.param.Name; });

// A place that moves in and out of an organ of 20 mm along its surface.
Vector3 PlaceOnThePath(int tick)
{
  return (20.0 + 3.0 * std::sin(0.05 * tick)) *
         Vector3(std::cos(0.01 * tick), std::sin(0.01 * tick), 0.3).normalized();
}

// An organ multiplied by `scale` around `centerWorld`, with a sphere of as many mm.
struct TouchedOrgan
{
  TouchedOrgan(double scale, const Vector3& centerWorld) : Model(Scaled(scale, centerWorld))
  {
    this->Tracker = test::TrackerOf(*test::RadialContact(this->Model), ToolShape::Sphere(scale));
  }

  static RadialModel Scaled(double scale, const Vector3& centerWorld)
  {
    Random random(8812);
    std::vector<double> coefficients = test::RandomOrgan(random, 12).Coefficients();
    for (double& c : coefficients)
    {
      c *= scale;
    }
    return {12, coefficients, centerWorld};
  }

  RadialModel Model;
  std::unique_ptr<ContactTracker> Tracker;
};

// By powers of two, so that nothing is rounded and all digits must be the same.
TEST(ShapeExtremes, TouchHasTheSameDigitsFromANanometreToAKilometre)
{
  for (const int exponent : {-24, 16}) // 20 mm become 1e-6 mm and 1e6 mm
  {
    const double scale = std::ldexp(1.0, exponent);
    const TouchedOrgan organ(1.0, Vector3::Zero());
    const TouchedOrgan other(scale, Vector3::Zero());
    const ClosestPointSearch search(test::Shared(organ.Model));
    const ClosestPointSearch otherSearch(test::Shared(other.Model));
    int touches = 0;
    for (int tick = 0; tick < 400; ++tick)
    {
      const Vector3 place = PlaceOnThePath(tick);
      EXPECT_EQ(otherSearch.Nearest(scale * place).SignedDistance,
                scale * search.Nearest(place).SignedDistance);
      const Contact& expected = organ.Tracker->Follow(At(place));
      const Contact& felt = other.Tracker->Follow(At(scale * place));
      ASSERT_EQ(felt.IsTouching, expected.IsTouching) << tick << ' ' << exponent;
      EXPECT_EQ(felt.ProxyWorld, scale * expected.ProxyWorld) << tick << ' ' << exponent;
      touches += felt.IsTouching ? 1 : 0;
    }
    EXPECT_GT(touches, 100);
  }
}

TEST(ShapeExtremes, TouchTenMetresAwayIsEqualUpToRounding)
{
  const Vector3 far(1e4, -1e4, 1e4);
  const TouchedOrgan here(1.0, Vector3::Zero());
  const TouchedOrgan there(1.0, far);
  WorstCase off;
  WorstCase depth;
  for (int tick = 0; tick < 2000; ++tick)
  {
    const Vector3 place = PlaceOnThePath(tick);
    const Contact& expected = here.Tracker->Follow(At(place));
    const Contact& felt = there.Tracker->Follow(At(far + place));
    ASSERT_EQ(felt.IsTouching, expected.IsTouching) << tick;
    off.Add((felt.ProxyWorld - far - expected.ProxyWorld).norm());
    depth.Add(felt.Depth - expected.Depth);
  }
  // A tracked point may be off by an angle of 1e-7; its distance then by the square of that, and by
  // some roundings of 10 m.
  EXPECT_LE(off.Value(), 1e-7 * 30.0);
  EXPECT_LE(depth.Value(), 1e-10);
}
} // namespace
} // namespace palpate::shape_extremes_test
