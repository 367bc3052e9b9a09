#include "ForceInterpolation.h"

#include "SafetyCases.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace palpate::force_interpolation_test
{
namespace
{
constexpr double Period = 0.001; // s, of the device
constexpr int Interval = 4;      // device ticks in one of the model

// The contact of a point with a sphere around the origin.
Contact TouchSphere(double radius, const Vector3& probe)
{
  Contact contact;
  contact.IsValid = true;
  contact.IsTouching = probe.norm() < radius;
  contact.NormalWorld = probe.normalized();
  contact.ProxyWorld = contact.IsTouching ? Vector3(radius * contact.NormalWorld) : probe;
  contact.Depth = (contact.ProxyWorld - probe).norm();
  return contact;
}

// A probe that slides along a sphere of 20 mm, 1.5 mm deep, at 50 mm/s.
Vector3 Sliding(int tick)
{
  const double angle = 50.0 * tick * Period / 20.0;
  return 18.5 * Vector3(std::cos(angle), std::sin(angle), 0.0);
}

struct Slide
{
  double LargestStep = 0.0;  // mm, of the offset from one tick to the next
  double LargestError = 0.0; // mm, relative to the model queried at every tick
};

// Offsets along a slide, as `offset` gives them tick by tick.
template <typename OffsetAt>
Slide SlideBy(OffsetAt offsetAt)
{
  Slide slide;
  Vector3 last = Vector3::Zero();
  for (int tick = 0; tick < 400; ++tick)
  {
    const Vector3 offset = offsetAt(tick);
    const Contact exact = TouchSphere(20.0, Sliding(tick));
    if (tick > 2 * Interval)
    {
      slide.LargestStep = std::max(slide.LargestStep, (offset - last).norm());
      slide.LargestError =
          std::max(slide.LargestError, (offset - (exact.ProxyWorld - Sliding(tick))).norm());
    }
    last = offset;
  }
  return slide;
}

TEST(ForceInterpolation, IsExactOnAFlatWall)
{
  Contact wall;
  wall.IsTouching = true;
  wall.IsValid = true;
  wall.ProxyWorld = Vector3(3.0, 4.0, 0.0);
  const Vector3 modelProbe(3.0, 4.0, -1.0);
  ForceInterpolation felt;
  felt.Renew(wall, modelProbe, modelProbe, Interval * Period);
  static_cast<void>(felt.Advance(modelProbe, Interval * Period));
  for (const double z : {-3.0, -0.5, 0.0, 0.5})
  {
    const ContactOffset contact = felt.Advance({9.0, -2.0, z}, Period);
    EXPECT_NEAR((contact.Offset - Vector3(0.0, 0.0, std::max(0.0, -z))).norm(), 0.0, 1e-15) << z;
    EXPECT_EQ(contact.IsTouching, z < 0.0);
  }
}

TEST(ForceInterpolation, IsSmootherAndMoreAccurateThanHolding)
{
  ForceInterpolation felt;
  const Slide interpolated = SlideBy(
      [&](int tick)
      {
        Vector3 offset = felt.Advance(Sliding(tick), Period).Offset;
        if (tick % Interval == 0)
        {
          felt.Renew(TouchSphere(20.0, Sliding(tick)), Sliding(tick), Sliding(tick),
                     Interval * Period);
          offset = felt.Advance(Sliding(tick), 0.0).Offset;
        }
        return offset;
      });
  const Slide held = SlideBy(
      [&](int tick)
      {
        const Vector3 probe = Sliding(tick - tick % Interval);
        return Vector3(TouchSphere(20.0, probe).ProxyWorld - probe);
      });
  // Direction turns by 2.5 mrad per tick, four at once if the result is held.
  EXPECT_GT(held.LargestStep, 0.99 * Interval * 1.5 * 0.0025);
  EXPECT_LT(interpolated.LargestStep, 0.5 * held.LargestStep);
  EXPECT_LT(interpolated.LargestError, 1.5 * held.LargestError);
}

TEST(ForceInterpolation, NewResultCausesNoStep)
{
  test::Random random(71);
  ForceInterpolation felt;
  Vector3 probe = 18.0 * Vector3::UnitX();
  for (int n = 0; n < 1000; ++n)
  {
    const double radius =
        20.0 + test::RandomDirection(random)[0]; // a model with inconsistent results
    const Vector3 before = felt.Advance(probe, 0.0).Offset;
    felt.Renew(TouchSphere(radius, probe), probe, probe, Interval * Period);
    const Vector3 after = felt.Advance(probe, 0.0).Offset;
    ASSERT_NEAR((after - before).norm(), 0.0, 1e-13); // roundings of 20 mm
    probe = 18.0 * (probe + 0.1 * test::RandomDirection(random)).normalized();
    static_cast<void>(felt.Advance(probe, 0.7 * Interval * Period));
  }
}

TEST(ForceInterpolation, EndedContactFadesOutInOneModelPeriod)
{
  ForceInterpolation felt;
  const Vector3 inside(18.0, 0.0, 0.0);
  felt.Renew(TouchSphere(20.0, inside), inside, inside, Period);
  static_cast<void>(felt.Advance(inside, Period));
  felt.Renew(TouchSphere(17.0, inside), inside, inside, 4.0 * Period);
  EXPECT_NEAR(felt.Advance(inside, 0.0).Offset[0], 2.0, 1e-13);
  EXPECT_NEAR(felt.Advance(inside, 2.0 * Period).Offset[0], 1.0, 1e-13);
  const ContactOffset end = felt.Advance(inside, 2.0 * Period);
  EXPECT_EQ(end.Offset, Vector3::Zero());
  EXPECT_FALSE(end.IsTouching);
}
} // namespace
} // namespace palpate::force_interpolation_test
