#include "ContactCases.h"
#include "NearestByBruteForce.h"
#include "WorstCase.h"

namespace palpate
{
namespace
{
using test::At;
using test::HarmonicContact;
using test::Random;
using test::TrackerOf;
using test::WorstCase;

std::shared_ptr<const ContactModel> InFloat(const SphericalHarmonicModel& model,
                                            HarmonicContactMode mode = HarmonicContactMode::Nearest)
{
  return HarmonicContact(model, mode, EvaluationPrecision::Float);
}

class HarmonicPrecisionOfDegree : public testing::TestWithParam<int>
{
};

TEST_P(HarmonicPrecisionOfDegree, ProxiesInFloatAreThoseInDoubleButForRounding)
{
  Random random(static_cast<unsigned>(4500 + GetParam()));
  const SphericalHarmonicModel organ = test::RandomOrgan(random, GetParam());
  const auto exact = HarmonicContact(organ);
  const auto rounded = InFloat(organ);
  for (const double toolRadius : {0.0, 1.0, 6.0})
  {
    const auto one = TrackerOf(*exact, ToolShape::Sphere(toolRadius));
    const auto other = TrackerOf(*rounded, ToolShape::Sphere(toolRadius));
    test::WanderingDirection wandering(random);
    WorstCase difference;
    for (int tick = 0; tick < 1000; ++tick)
    {
      const Vector3 u = wandering.Turn(0.0025);
      const double height = toolRadius + 0.5 * std::sin(0.02 * tick);
      const Vector3 probe = organ.PointWorld(u) + height * organ.Normal(u);
      const Contact& here = one->Follow(At(probe));
      const Contact& there = other->Follow(At(probe));
      ASSERT_TRUE(there.IsValid);
      difference.Add((here.ProxyWorld - there.ProxyWorld).norm());
    }
    // Radii are off by 1e-5 mm, slopes by as much for each rad; a proxy slides by up to ten times
    // that where the bend of the surface is near the probe, and a tool's radius adds its share.
    EXPECT_GT(difference.Value(), 0.0);
    EXPECT_LE(difference.Value(), 3e-4 * (1.0 + toolRadius)) << toolRadius;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, HarmonicPrecisionOfDegree, testing::Values(4, 12, 20, 33));

TEST(HarmonicPrecision, InFloatNothingIsPassedThroughHoweverFast)
{
  Random random(4510);
  const auto model = InFloat(test::Ellipsoid({4.0, 4.0, 0.5}, Matrix3::Identity(), 24));
  for (const double toolRadius : {0.0, 0.2, 3.0})
  {
    for (const double step : {0.1, 1.0, 10.0, 100.0}) // mm a tick
    {
      const auto tracker = TrackerOf(*model, ToolShape::Sphere(toolRadius));
      const Vector3 across = 0.5 * test::RandomDirection(random);
      const Vector3 above = Vector3(0.0, 0.0, 57.0) + across;
      const Vector3 beyond = Vector3(0.0, 0.0, -0.6 - toolRadius) - across;
      tracker->Follow(At(above));
      Contact last;
      test::MoveStraight(*tracker, above, beyond, step,
                         [&](const Vector3&, const Contact& contact) { last = contact; });
      // The search leaves what exceeds its budget to the following ticks.
      for (int tick = 0; tick < 5; ++tick)
      {
        last = tracker->Follow(At(beyond));
      }
      ASSERT_TRUE(last.IsTouching) << toolRadius << " " << step;
      EXPECT_GT(last.ProxyWorld[2], 0.0) << toolRadius << " " << step;
    }
  }
}

TEST(HarmonicPrecision, InFloatPlacesThatAreSpecialAreOrdinary)
{
  Random random(4511);
  const SphericalHarmonicModel organ = test::RandomOrgan(random, 12);
  const Vector3& center = organ.CenterWorld();
  std::vector<Vector3> places{center, center + Vector3::Constant(1e-300),
                              center + Vector3(1e4, 0.0, 0.0), center + Vector3::Constant(1e90)};
  for (const Vector3& u : {Vector3(0, 0, 1), Vector3(0, 0, -1), Vector3(1, 0, 0)})
  {
    places.push_back(organ.PointWorld(u));
    places.push_back(organ.PointWorld(u) * (1.0 + 1e-16));
    places.push_back(0.5 * (organ.PointWorld(u) + center));
  }
  for (const auto mode : {HarmonicContactMode::Nearest, HarmonicContactMode::Radial})
  {
    const auto tracker = TrackerOf(*InFloat(organ, mode), ToolShape::Sphere(8.0));
    for (int tick = 0; tick < 2000; ++tick)
    {
      const Contact& contact = tracker->Follow(At(places[random() % places.size()]));
      ASSERT_TRUE(contact.IsValid);
      ASSERT_TRUE(contact.ProxyWorld.allFinite());
      ASSERT_NEAR(contact.NormalWorld.norm(), 1.0, 1e-12); // made in double: rounding
      ASSERT_TRUE(std::isfinite(contact.Depth));
      if (random() % 4 == 0)
      {
        tracker->Release();
      }
    }
  }
}

TEST(HarmonicPrecision, ABallThatFitsEverywhereInDoubleDoesInFloat)
{
  const SphericalHarmonicModel sphere = test::Sphere(20.0);
  for (const double toolRadius : {1.0, 100.0})
  {
    const ToolShape tool = ToolShape::Sphere(toolRadius);
    EXPECT_EQ(TrackerOf(*InFloat(sphere), tool)->Bytes(),
              TrackerOf(*HarmonicContact(sphere), tool)->Bytes());
  }
}
} // namespace
} // namespace palpate
