#include "ContactForce.h"

#include "SafetyCases.h"

#include <gtest/gtest.h>

namespace palpate::contact_force_test
{
namespace
{
ContactOffset RandomContact(test::Random& random)
{
  std::uniform_real_distribution<double> depth(0.0, 3.0);
  ContactOffset contact;
  contact.IsTouching = true;
  contact.Normal = test::RandomDirection(random);
  const Vector3 along = contact.Normal.cross(test::RandomDirection(random));
  contact.Offset = depth(random) * contact.Normal + 0.3 * along; // as with friction
  contact.Velocity = 100.0 * test::RandomDirection(random);
  return contact;
}

TEST(ContactForce, IsThePublishedSpringWithoutDamping)
{
  test::Random random(61);
  for (int n = 0; n < 1000; ++n)
  {
    const ContactOffset contact = RandomContact(random);
    const Vector3 force = ContactForce({1.5, 0.0}, contact);
    EXPECT_NEAR((force - 1.5 * contact.Offset).norm(), 0.0, 1e-14); // roundings of 5 N
  }
}

TEST(ContactForce, NeverPullsInwards)
{
  test::Random random(62);
  for (int n = 0; n < 10'000; ++n)
  {
    const ContactOffset contact = RandomContact(random);
    EXPECT_GE(ContactForce({1.0, 0.1}, contact).dot(contact.Normal), -1e-13); // of 10 N
  }
}

TEST(ContactForce, DampsAlongTheNormalOnly)
{
  ContactOffset contact;
  contact.IsTouching = true;
  contact.Offset = {0.0, 0.0, 2.0};
  contact.Velocity = {50.0, 60.0, 10.0};
  EXPECT_NEAR((ContactForce({1.0, 0.02}, contact) - Vector3(0.0, 0.0, 2.2)).norm(), 0.0, 1e-15);
}

TEST(ContactForce, IsZeroWithoutContact)
{
  ContactOffset contact;
  contact.Offset = Vector3::Ones();
  contact.Velocity = Vector3::Ones();
  EXPECT_EQ(ContactForce({1.0, 1.0}, contact), Vector3::Zero());
}

// Kelvin and Voigt: the push plus the relaxation time times its slope times the depth's rate.
TEST(ContactForce, TissueResistsTheRateOfItsDepth)
{
  ContactOffset contact;
  contact.IsTouching = true;
  contact.IsElastic = true;
  contact.Push = Vector3(0.1, 0.0, 0.5);
  contact.Slope = 0.2;
  contact.Velocity = Vector3(40.0, 0.0, 30.0); // mm/s, into the structure and along it
  const double resistance = 0.001 + 0.01 * 0.2;
  const Vector3 wanted(0.1, 0.0, 0.5 + resistance * 30.0);
  EXPECT_NEAR((ContactForce({7.0, 0.001, 0.01}, contact) - wanted).norm(), 0.0, 1e-15);
  contact.Velocity = Vector3(0.0, 0.0, -1e4);
  EXPECT_EQ(ContactForce({7.0, 0.001, 0.01}, contact).z(), 0.0) << "it does not stick";
}

TEST(ContactForce, RelaxationIsOfTissueOnly)
{
  ContactOffset contact;
  contact.IsTouching = true;
  contact.Offset = Vector3(0.0, 0.0, 1.0);
  contact.Slope = 0.2;
  contact.Velocity = Vector3(0.0, 0.0, 30.0);
  EXPECT_EQ(ContactForce({1.0, 0.0, 0.01}, contact), Vector3(0.0, 0.0, 1.0));
}
} // namespace
} // namespace palpate::contact_force_test
