#include "VolumeViscosity.h"

#include "SafetyCases.h"
#include "ServoRun.h"

#include <gtest/gtest.h>

namespace palpate::volume_viscosity_test
{
namespace
{
ContactOffset RandomContact(test::Random& random)
{
  std::uniform_real_distribution<double> depth(0.0, 5.0);
  ContactOffset contact;
  contact.IsTouching = true;
  contact.Normal = test::RandomDirection(random);
  contact.Offset = depth(random) * contact.Normal;
  return contact;
}

TEST(VolumeViscosity, OpposesTheHandInsideAndIsZeroElsewhere)
{
  constexpr double Viscosity = 0.004; // N s/mm
  constexpr double Radius = 2.0;      // mm
  test::Random random(84);
  int within = 0;
  for (int n = 0; n < 10'000; ++n)
  {
    const ContactOffset contact = RandomContact(random);
    const Vector3 velocity = test::VectorOfAnyLength(random);
    EffectTouch touch;
    touch.Contact = contact;
    touch.CenterDepth = Radius;
    touch.HandVelocity = velocity;
    const Vector3 force = VolumeViscosity(Viscosity).Force(touch);
    const bool isWithin = contact.Offset.norm() > Radius;
    EXPECT_EQ(force, isWithin ? Vector3(-Viscosity * velocity) : Vector3::Zero());
    EXPECT_LE(force.dot(velocity), 0.0); // it absorbs power
    within += isWithin ? 1 : 0;
  }
  EXPECT_GT(within, 5000);
}

TEST(VolumeViscosity, IsZeroWithoutContact)
{
  EffectTouch touch;
  touch.Contact.Offset = {0.0, 0.0, 5.0};
  touch.CenterDepth = 2.0;
  touch.HandVelocity = Vector3::Ones();
  EXPECT_EQ(VolumeViscosity(1.0).Force(touch), Vector3::Zero());
}

TEST(VolumeViscosity, RejectsWhatDrivesTheHand)
{
  EXPECT_TRUE(VolumeViscosity(0.0).Check().IsOk());
  EXPECT_FALSE(VolumeViscosity(-1e-6).Check().IsOk());
  EXPECT_FALSE(VolumeViscosity(test::Infinite).Check().IsOk());
  EXPECT_FALSE(VolumeViscosity(test::NotANumber).Check().IsOk());
}

// A soft wall, with a scale of 1.5 from hand to world: the sphere's centre is 2 / 1.5 mm of the
// hand deep when it enters.
TEST(VolumeViscosity, StartsWhereTheToolsCentreEnters)
{
  TouchScene scene = test::WallScene(0.0, {0.0, 0.0});
  scene.Tool = ToolShape::Sphere(2.0);
  scene.Frame = DeviceFrame(Matrix3::Identity(), 1.5, Vector3::Zero());
  scene.Structures[0].Effects = {std::make_shared<const VolumeViscosity>(0.01)};
  test::ServoRun run(scene);
  for (const double height : {0.1, -0.1})
  {
    run.RestAt({0.0, 0.0, height});
    Vector3 force = Vector3::Zero();
    for (int n = 1; n <= 100; ++n)
    {
      force = run.TickAt({0.02 * n, 0.0, height}); // 20 mm/s
    }
    // The filter of velocities has 33 of its time constants to settle.
    const Vector3 expected = height < 0.0 ? Vector3(-0.2, 0.0, 0.0) : Vector3::Zero();
    EXPECT_NEAR((force - expected).norm(), 0.0, 1e-12);
  }
}
} // namespace
} // namespace palpate::volume_viscosity_test
