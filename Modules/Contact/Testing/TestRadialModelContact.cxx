#include "ContactCases.h"
#include "WorstCase.h"

#include <limits>

namespace palpate::radial_model_contact_test
{
namespace
{
using test::At;
using test::RadialContact;
using test::Random;
using test::TrackerOf;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
// Of coordinates of some 100 mm.
constexpr double Rounding = 1e-12;

TEST(RadialModelContact, BoundsContainTheSurfaceTightly)
{
  Random random(4301);
  const RadialModel organ = test::RandomOrgan(random, 12);
  const Eigen::AlignedBox3d bounds = RadialContact(organ)->BoundsWorld();
  double largest = 0.0;
  for (const Vector3& u : test::RandomDirections(random, 10000))
  {
    EXPECT_TRUE(bounds.contains(organ.PointWorld(u)));
    largest = std::max(largest, organ.Radius(u));
  }
  EXPECT_LE((bounds.max() - organ.CenterWorld()).maxCoeff(), 1.01 * largest);
}

TEST(RadialModelContact, RejectsInvalidModels)
{
  const double mean = 20.0 * std::sqrt(4.0 * M_PI);
  const std::vector<RadialModel> bad{
      {1, {mean, 0.0, 60.0, 0.0}, Vector3::Zero()}, // radii from -9 to 49 mm
      {0, {0.0}, Vector3::Zero()},
      {0, {-mean}, Vector3::Zero()},
      {0, {NotANumber}, Vector3::Zero()},
      {0, {mean}, {0.0, NotANumber, 0.0}}};
  for (const RadialModel& model : bad)
  {
    std::shared_ptr<const ContactModel> contact;
    const Status status =
        MakeOrganContact(test::Shared(model), RadialContactMode::Nearest, contact);
    EXPECT_FALSE(status.IsOk());
    EXPECT_EQ(contact, nullptr);
  }
}

TEST(RadialModelContact, SupportsSpheresOnly)
{
  for (const auto mode : {RadialContactMode::Nearest, RadialContactMode::Radial})
  {
    const auto model = RadialContact(test::Sphere(20.0), mode);
    std::unique_ptr<ContactTracker> tracker;
    EXPECT_FALSE(model->MakeTracker(ToolShape::Capsule(1.0, 3.0, 50), {}, tracker).IsOk());
    EXPECT_FALSE(model->MakeTracker(ToolShape::Sphere(-1.0), {}, tracker).IsOk());
    EXPECT_EQ(tracker, nullptr);
    EXPECT_TRUE(model->MakeTracker(ToolShape::SpherePoints(1.0, 26), {}, tracker).IsOk());
  }
}

TEST(RadialModelContact, TrackersOutliveTheirModel)
{
  auto model = RadialContact(test::Sphere(20.0));
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(0.0));
  model.reset();
  EXPECT_TRUE(tracker->Follow(At({0.0, 0.0, 19.0})).IsTouching);
}

TEST(RadialTracker, EqualsThePublishedMethod)
{
  Random random(4302);
  const RadialModel organ = test::RandomOrgan(random, 12);
  const auto model = RadialContact(organ, RadialContactMode::Radial);
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(0.0));
  std::uniform_real_distribution<double> ratio(0.1,
                                               2.0); // closer to the centre, directions are rounded
  for (int tick = 0; tick < 5000; ++tick)
  {
    const Vector3 u = test::RandomDirection(random);
    const Vector3 proxy = organ.PointWorld(u);
    const Vector3 probe = organ.CenterWorld() + ratio(random) * (proxy - organ.CenterWorld());
    const Contact& contact = tracker->Follow(At(probe));
    const double depth =
        (proxy - organ.CenterWorld()).norm() - (probe - organ.CenterWorld()).norm();
    ASSERT_TRUE(contact.IsValid);
    ASSERT_EQ(contact.IsTouching, depth > 0.0);
    const Vector3 expected = contact.IsTouching ? proxy : probe;
    EXPECT_LE((contact.ProxyWorld - expected).norm(), Rounding);
    EXPECT_NEAR(contact.Depth, std::max(0.0, depth), Rounding);
    if (contact.IsTouching)
    {
      EXPECT_LE((contact.NormalWorld - organ.Normal(u)).norm(), Rounding);
    }
  }
}

TEST(RadialTracker, KeepsTheLastDirectionAtTheCentre)
{
  const auto model = RadialContact(test::Sphere(20.0), RadialContactMode::Radial);
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(1.0));
  tracker->Follow(At({0.0, -3.0, 0.0}));
  const Contact& contact = tracker->Follow(At(Vector3::Zero()));
  EXPECT_LE((contact.ProxyWorld - Vector3(0.0, -21.0, 0.0)).norm(), Rounding);
  EXPECT_NEAR(contact.Depth, 21.0, Rounding);
  tracker->Release();
  EXPECT_LE((tracker->Follow(At(Vector3::Zero())).ProxyWorld - Vector3(0.0, 0.0, 21.0)).norm(),
            Rounding);
}

TEST(RadialTracker, InvalidPoseHasNoContact)
{
  const auto model = RadialContact(test::Sphere(20.0), RadialContactMode::Radial);
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(0.0));
  for (const double bad : {NotANumber, std::numeric_limits<double>::infinity(), 1e200})
  {
    const Contact& contact = tracker->Follow(At({0.0, bad, 1.0}));
    EXPECT_FALSE(contact.IsValid);
    EXPECT_FALSE(contact.IsTouching);
  }
}

TEST(RadialTracker, HasNoFriction)
{
  const auto model = RadialContact(test::Sphere(20.0), RadialContactMode::Radial);
  std::unique_ptr<ContactTracker> tracker;
  EXPECT_FALSE(model->MakeTracker(ToolShape::Sphere(0.0), {0.3, 0.2}, tracker).IsOk());
}
} // namespace
} // namespace palpate::radial_model_contact_test
