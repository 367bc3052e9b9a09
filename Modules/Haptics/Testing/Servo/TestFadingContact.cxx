#include "FadingContact.h"

#include <gtest/gtest.h>

namespace palpate::fading_contact_test
{
namespace
{
const Vector3 Push(0.3, 0.0, 2.0); // N, against a floor with friction
const Vector3 Hand(1.0, 2.0, -4.0);

TEST(FadingContact, FadesFromFullForceToZero)
{
  FadingContact contact(Push, Vector3::UnitZ(), 0.5, Hand);
  EXPECT_LT((contact.Advance(Hand, 0.001) - Push).norm(), 1e-15);
  double last = Push.norm();
  int ticks = 0;
  for (; !contact.IsOver(); ++ticks)
  {
    const double force = contact.Advance(Hand, 0.001).norm();
    EXPECT_LT(force, last);
    EXPECT_NEAR(last - force, Push.norm() / 100.0, 1e-12);
    last = force;
  }
  EXPECT_NEAR(ticks, 100, 1); // the rounding of a sum decides the last one
  EXPECT_EQ(last, 0.0);
}

TEST(FadingContact, FollowsTheHandAsASpring)
{
  FadingContact contact(Push, Vector3::UnitZ(), 0.5, Hand);
  const Vector3 deeper = contact.Advance(Hand - Vector3(0.0, 0.0, 1.0), 0.001);
  EXPECT_NEAR(deeper[2], 2.5, 1e-12);
  EXPECT_NEAR(deeper[0] / deeper[2], Push[0] / Push[2], 1e-12);
  EXPECT_NEAR(contact.Advance(Hand + Vector3(9.0, 9.0, 0.0), 0.0)[2], 2.0, 1e-12);
}

TEST(FadingContact, EndsForGoodWhenTheHandLeaves)
{
  FadingContact contact(Push, Vector3::UnitZ(), 0.5, Hand);
  EXPECT_GT(contact.Advance(Hand + Vector3(0.0, 0.0, 3.9), 0.001)[2], 0.0);
  EXPECT_EQ(contact.Advance(Hand + Vector3(0.0, 0.0, 4.1), 0.001), Vector3::Zero());
  EXPECT_TRUE(contact.IsOver());
  EXPECT_EQ(contact.Advance(Hand, 0.001), Vector3::Zero());
}

TEST(FadingContact, JoinedContactsGiveTheSumAndFadeAgain)
{
  FadingContact one(Push, Vector3::UnitZ(), 0.5, Hand);
  FadingContact other({1.0, 0.0, 0.0}, Vector3::UnitX(), 0.25, Hand);
  for (int n = 0; n < 50; ++n)
  {
    one.Advance(Hand, 0.001);
    other.Advance(Hand, n < 10 ? 0.001 : 0.0);
  }
  const Vector3 sum = one.Force() + other.Force();
  FadingContact joined = FadingContact::Joined(one, other);
  EXPECT_LT((joined.Force() - sum).norm(), 1e-12);
  joined.Advance(Hand, 0.001);
  EXPECT_LT((joined.Advance(Hand, 0.05) - 0.5 * sum).norm(), 1e-12);
  EXPECT_EQ(FadingContact::Joined(one, FadingContact()).Force(), one.Force());
  EXPECT_TRUE(FadingContact::Joined(FadingContact(), FadingContact()).IsOver());
  // Opposite forces cancel and have no direction.
  const FadingContact opposite(-Push, -Vector3::UnitZ(), 0.5, Hand);
  EXPECT_TRUE(
      FadingContact::Joined(FadingContact(Push, Vector3::UnitZ(), 0.5, Hand), opposite).IsOver());
}

TEST(FadingContact, ForceThatDoesNotPushIsNoContact)
{
  EXPECT_TRUE(FadingContact().IsOver());
  EXPECT_EQ(FadingContact().Advance(Hand, 0.001), Vector3::Zero());
  EXPECT_TRUE(FadingContact(-Push, Vector3::UnitZ(), 0.5, Hand).IsOver());
  EXPECT_TRUE(FadingContact(Vector3::Zero(), Vector3::UnitZ(), 0.5, Hand).IsOver());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(FadingContact(Vector3::Constant(nan), Vector3::UnitZ(), 0.5, Hand).IsOver());
}
} // namespace
} // namespace palpate::fading_contact_test
