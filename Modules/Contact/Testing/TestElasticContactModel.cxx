#include "ContactCases.h"
#include "ElasticCases.h"
#include "ElasticContactModel.h"
#include "ElasticForce.h"
#include "ElasticHold.h"
#include "NearestPointTracker.h"
#include "StiffnessAdvice.h"
#include "StructureFollower.h"

#include <gtest/gtest.h>

#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace palpate::elastic_contact_model_test
{
namespace
{
// A bumpy organ with a lesion of five times the modulus beside its surface.
struct Organ
{
  Organ()
  {
    std::mt19937_64 random(51);
    this->Case.Model = test::RandomModel(random, 4, 0.015);
    this->Lesion = test::RandomDirection(random);
    this->Case.Solid.Tissue.AddInclusion(
        test::BallFraction(this->Case.Model.PointWorld(this->Lesion) - 9.0 * this->Lesion, 6.0),
        0.1);
    this->Case.Build(8, 8);
    ComplianceMaps maps;
    Status status = ComplianceMaps::Fit(this->Case.Model, this->Case.Solid, this->Case.Reduced,
                                        {16, 0.0}, {}, maps);
    EXPECT_TRUE(status.IsOk()) << status.Message();
    this->Atlas = std::make_shared<const ComplianceAtlas>(maps);
    status = ElasticContactModel::Make(test::Shared(this->Case.Model), maps, this->Model);
    EXPECT_TRUE(status.IsOk()) << status.Message();
  }
  Vector3 Above(const Vector3& direction, double height) const
  {
    return this->Case.Model.PointWorld(direction) + height * this->Case.Model.Normal(direction);
  }

  test::ElasticCase Case;
  Vector3 Lesion;
  std::shared_ptr<const ComplianceAtlas> Atlas;
  std::shared_ptr<const ContactModel> Model;
};

const Organ& TheOrgan()
{
  static const Organ organ;
  return organ;
}

constexpr double Ball = 5.0; // mm

std::unique_ptr<ContactTracker> Tracker(const SurfaceFriction& friction = {})
{
  return test::TrackerOf(*TheOrgan().Model, ToolShape::Sphere(Ball), friction);
}

TEST(ElasticContactModel, ForceIsThatAtTheNearestPoint)
{
  std::mt19937_64 random(53);
  const auto tracker = Tracker();
  const ClosestPointSearch search(test::Shared(TheOrgan().Case.Model));
  for (int i = 0; i < 50; ++i)
  {
    const Vector3 direction = test::RandomDirection(random);
    tracker->Release();
    tracker->Follow(test::At(TheOrgan().Above(direction, Ball + 1.0)));
    const Vector3 probe = TheOrgan().Above(direction, Ball - 0.05 * i);
    const Contact& contact = tracker->Follow(test::At(probe));
    const ClosestPoint foot = search.Nearest(probe);
    const ElasticForce wanted = ElasticForce::Of(*TheOrgan().Atlas, TheOrgan().Case.Model,
                                                 foot.Direction, Ball - foot.SignedDistance, Ball);
    EXPECT_TRUE(contact.Elastic != nullptr);
    EXPECT_LE((contact.Elastic->ForceWorld - wanted.ForceWorld).norm(),
              1e-6 * (wanted.ForceWorld.norm() + 1e-6))
        << i;
    EXPECT_EQ(contact.Elastic->IsValid, wanted.IsValid);
  }
}

// Semi-implicit Euler at 1 kHz, without friction and damping. The bound is the aim of the module;
// without the lateral force the same throws give and take some percent.
TEST(ElasticContactModel, BallBouncesWithoutLossOrGain)
{
  constexpr double Period = 1e-3; // s
  constexpr double Mass = 1e-4;   // N s^2/mm: 0.1 kg
  std::mt19937_64 random(57);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  const auto tracker = Tracker();
  for (int i = 0; i < 40; ++i)
  {
    const Vector3 direction =
        (TheOrgan().Lesion + 0.35 * test::RandomDirection(random)).normalized();
    const Vector3 normal = TheOrgan().Case.Model.Normal(direction);
    const Vector3 aside = normal.unitOrthogonal();
    Vector3 probe = TheOrgan().Above(direction, Ball + 0.5);
    // Tens of mm/s, at a slant.
    Vector3 velocity = -(60.0 + 20.0 * part(random)) * normal +
                       40.0 * (part(random) * aside + part(random) * normal.cross(aside));
    const double before = velocity.squaredNorm();
    tracker->Release();
    bool hasTouched = false;
    bool isTouching = false;
    for (int tick = 0; tick < 2000 && (isTouching || !hasTouched); ++tick)
    {
      const Contact& contact = tracker->Follow(test::At(probe));
      isTouching = contact.IsTouching;
      hasTouched = hasTouched || isTouching;
      velocity += Period / Mass * contact.Elastic->ForceWorld;
      probe += Period * velocity;
    }
    EXPECT_TRUE(hasTouched);
    EXPECT_NEAR(velocity.squaredNorm() / before, 1.0, 1e-3) << i;
  }
}

TEST(ElasticContactModel, FrictionHoldsThenSlips)
{
  const SurfaceFriction friction{0.5, 0.3};
  const auto tracker = Tracker(friction);
  const Vector3 direction = -TheOrgan().Lesion;
  const Vector3 start = TheOrgan().Above(direction, Ball - 1.5);
  tracker->Follow(test::At(TheOrgan().Above(direction, Ball + 1.0)));
  const Contact pressed = tracker->Follow(test::At(start));
  const Vector3 aside = pressed.NormalWorld.unitOrthogonal();
  double most = 0.0;
  double last = 0.0;
  for (int tick = 1; tick <= 300; ++tick)
  {
    const Contact& contact = tracker->Follow(test::At(start + 0.01 * tick * aside));
    const double push = contact.Elastic->ForceWorld.dot(contact.NormalWorld);
    last = -contact.Elastic->ForceWorld.dot(aside) / push;
    most = std::max(most, last);
  }
  // The surface's own slope adds a part.
  EXPECT_GT(most, 0.35);
  EXPECT_LT(most, 0.7);
  EXPECT_LT(last, most - 0.05);
}

// Friction alone: the force of a tracker with friction without that of one without.
TEST(ElasticContactModel, FrictionIsASpringAlongTheSurfaceUntilItSlipsAtItsDynamicCoefficient)
{
  const auto rubbing = Tracker({0.5, 0.3});
  const auto sliding = Tracker();
  const auto follow = [&](const Vector3& place)
  {
    const Vector3 rubbed = rubbing->Follow(test::At(place)).Elastic->ForceWorld;
    return Vector3(rubbed - sliding->Follow(test::At(place)).Elastic->ForceWorld);
  };
  const Vector3 direction = -TheOrgan().Lesion;
  const Vector3 start = TheOrgan().Above(direction, Ball - 1.5);
  follow(TheOrgan().Above(direction, Ball + 1.0));
  EXPECT_EQ(follow(start), Vector3::Zero()) << "nothing has moved along the surface";
  const Vector3 normal = sliding->Follow(test::At(start)).NormalWorld;
  const Vector3 aside = normal.unitOrthogonal();
  constexpr double Step = 1e-3; // mm, aside and deeper
  const Vector3 held = follow(start + Step * (aside - normal));
  const Contact pressed = sliding->Follow(test::At(start + Step * (aside - normal)));
  const double nu = TheOrgan().Atlas->PoissonRatio();
  const double stiffness = pressed.Elastic->Slope * 2.0 * (1.0 - nu) / (2.0 - nu); // Mindlin
  EXPECT_NEAR(held.dot(aside), -stiffness * Step, 1e-3 * stiffness * Step);
  EXPECT_NEAR(held.dot(pressed.NormalWorld), 0.0, 1e-9 * stiffness);
  for (int tick = 1; tick <= 300; ++tick)
  {
    const double friction = follow(start + 0.01 * tick * aside).norm();
    const Contact contact = sliding->Follow(test::At(start + 0.01 * tick * aside));
    const double push = contact.Elastic->ForceWorld.dot(contact.NormalWorld);
    EXPECT_LE(friction, (0.5 + 1e-9) * push);
    if (tick > 250)
    {
      EXPECT_NEAR(friction, 0.3 * push, 1e-9 * push) << tick;
    }
  }
}

TEST(ElasticContactModel, ContactThatEndsLeavesNoFriction)
{
  const auto used = Tracker({0.5, 0.3});
  const auto fresh = Tracker({0.5, 0.3});
  const auto at = [](double depth, double aside)
  {
    const Vector3 normal = TheOrgan().Case.Model.Normal(TheOrgan().Lesion);
    return test::At(TheOrgan().Above(TheOrgan().Lesion, Ball - depth) +
                    aside * normal.unitOrthogonal());
  };
  used->Follow(at(-1.0, 0.0));
  used->Follow(at(1.0, 0.0));
  used->Follow(at(1.0, 0.1));
  for (const auto& [depth, aside] : {std::pair(-1.0, 0.0), {1.0, 0.0}, {1.0, 0.01}})
  {
    const Vector3 force = used->Follow(at(depth, aside)).Elastic->ForceWorld;
    EXPECT_LE((force - fresh->Follow(at(depth, aside)).Elastic->ForceWorld).norm(), 1e-9);
  }
}

TEST(ElasticContactModel, RubbingTakesEnergyOnly)
{
  const auto tracker = Tracker({0.4, 0.3});
  const Vector3 direction = TheOrgan().Lesion;
  const Vector3 first = TheOrgan().Case.Model.Normal(direction).unitOrthogonal();
  tracker->Follow(test::At(TheOrgan().Above(direction, Ball + 1.0)));
  double work = 0.0; // of the force on the hand
  Vector3 lastPlace = Vector3::Zero();
  Vector3 lastForce = Vector3::Zero();
  for (int tick = 0; tick <= 4000; ++tick)
  {
    const double angle = 2.0 * Pi * (tick % 1000) / 1000.0;
    const Vector3 place =
        TheOrgan().Above((direction + 0.05 * std::sin(angle) * first).normalized(),
                         Ball - 1.5 - 0.8 * std::sin(2.0 * angle + 1.0));
    const Vector3 force = tracker->Follow(test::At(place)).Elastic->ForceWorld;
    if (tick > 0)
    {
      work += 0.5 * (force + lastForce).dot(place - lastPlace);
    }
    if (tick > 0 && tick % 1000 == 0)
    {
      EXPECT_LT(work, 0.0) << tick;
    }
    lastPlace = place;
    lastForce = force;
  }
}

// Pushed aside where the patch is stiff, and back where it is soft.
TEST(ElasticContactModel, FrictionOfAPatchThatIsUnloadedGivesNoEnergyOut)
{
  const auto tracker = Tracker({2.0, 2.0});
  const Vector3 normal = TheOrgan().Case.Model.Normal(TheOrgan().Lesion);
  const Vector3 aside = 0.2 * normal.unitOrthogonal();
  const auto at = [&](double depth) { return TheOrgan().Above(TheOrgan().Lesion, Ball - depth); };
  const Vector3 corners[] = {at(2.0), at(2.0) + aside, at(0.8) + aside, at(0.8), at(2.0)};
  tracker->Follow(test::At(at(-1.0)));
  Vector3 lastForce = tracker->Follow(test::At(corners[0])).Elastic->ForceWorld;
  double work = 0.0; // of the force on the hand
  for (std::size_t side = 0; side + 1 < std::size(corners); ++side)
  {
    Vector3 last = corners[side];
    test::MoveStraight(*tracker, corners[side], corners[side + 1], 0.01,
                       [&](const Vector3& place, const Contact& contact)
                       {
                         const Vector3 force = contact.Elastic->ForceWorld;
                         work += 0.5 * (force + lastForce).dot(place - last);
                         last = place;
                         lastForce = force;
                       });
  }
  EXPECT_LT(work, 0.0);
}

TEST(ElasticContactModel, NeedsABall)
{
  std::unique_ptr<ContactTracker> tracker;
  EXPECT_FALSE(TheOrgan().Model->MakeTracker(ToolShape::Sphere(0.0), {}, tracker).IsOk());
  EXPECT_EQ(tracker, nullptr);
}

TEST(ElasticContactModel, InvalidPosesTouchNothing)
{
  const auto tracker = Tracker();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(tracker->Follow(test::At(Vector3(nan, 0.0, 0.0))).IsValid);
}

TEST(ElasticContactModel, StatesItsStiffness)
{
  const double stiffness = TheOrgan().Model->OwnStiffness(ToolShape::Sphere(Ball));
  const auto tracker = Tracker();
  tracker->Follow(test::At(TheOrgan().Above(TheOrgan().Lesion, Ball + 1.0)));
  const Contact& contact =
      tracker->Follow(test::At(TheOrgan().Above(TheOrgan().Lesion, 0.5 * Ball)));
  EXPECT_LE(contact.Elastic->Slope, 1.05 * stiffness); // between the directions that were asked
  EXPECT_GE(contact.Elastic->Slope, 0.3 * stiffness);
}

// What the hand feels: N in the world, turned to the device; the scene's stiffness does not count.
TEST(ElasticContactModel, FollowerGivesTheForceToTheHand)
{
  TouchScene scene;
  scene.Tool = ToolShape::Sphere(Ball);
  scene.Structures.push_back({"organ", TheOrgan().Model, {123.0, 0.0}, {}});
  std::vector<StructureFollower> followers;
  ASSERT_TRUE(StructureFollower::Make(scene.Structures[0], scene, 0.0, followers).IsOk());
  const auto tracker = Tracker();
  FollowStep step;
  step.Last = test::At(TheOrgan().Above(TheOrgan().Lesion, Ball + 1.0));
  for (const double height : {Ball + 1.0, Ball + 0.2, Ball - 0.5, Ball - 2.0})
  {
    step.Now = test::At(TheOrgan().Above(TheOrgan().Lesion, height));
    step.Passed = 1e-3;
    const Vector3 force = followers[0].Follow(step);
    const Vector3 wanted = tracker->Follow(step.Now).Elastic->ForceWorld;
    EXPECT_LE((scene.Frame.TurnedToWorld(force) - wanted).norm(), 1e-9) << height;
    EXPECT_EQ(force.norm() > 0.0, height < Ball);
    step.Last = step.Now;
  }
}

TEST(ElasticContactModel, RelaxingTissueResistsTheMotionIntoIt)
{
  const auto forceWith = [](double relaxation)
  {
    TouchScene scene;
    scene.Tool = ToolShape::Sphere(Ball);
    scene.Structures.push_back({"organ", TheOrgan().Model, {0.0, 0.0, relaxation}, {}});
    std::vector<StructureFollower> followers;
    EXPECT_TRUE(StructureFollower::Make(scene.Structures[0], scene, 0.0, followers).IsOk());
    Vector3 force = Vector3::Zero();
    FollowStep step;
    step.Last = test::At(TheOrgan().Above(TheOrgan().Lesion, Ball + 1.0));
    step.Passed = 1e-3;
    for (int tick = 0; tick < 100; ++tick) // 20 mm/s
    {
      step.Now = test::At(TheOrgan().Above(TheOrgan().Lesion, Ball - 0.02 * tick));
      force = followers[0].Follow(step);
      step.Last = step.Now;
    }
    return scene.Frame.TurnedToWorld(force).dot(TheOrgan().Case.Model.Normal(TheOrgan().Lesion));
  };
  const auto tracker = Tracker();
  tracker->Follow(test::At(TheOrgan().Above(TheOrgan().Lesion, Ball + 1.0)));
  const Contact& contact =
      tracker->Follow(test::At(TheOrgan().Above(TheOrgan().Lesion, Ball - 0.02 * 99)));
  const double resistance = 0.02 * contact.Elastic->Slope * 20.0;
  EXPECT_NEAR(forceWith(0.02) - forceWith(0.0), resistance, 0.02 * resistance);
}

TEST(ElasticContactModel, AdviceCountsRelaxationAsDamping)
{
  TouchScene scene;
  scene.Tool = ToolShape::Sphere(Ball);
  scene.Structures.push_back({"organ", TheOrgan().Model, {0.0, 0.0, 0.0}, {}});
  DeviceCapabilities device;
  device.Name = "example";
  device.Damping = 0.01;
  EXPECT_TRUE(StiffnessWarnings(scene, device, 1000.0).empty());
  const double stiffness = TheOrgan().Model->OwnStiffness(scene.Tool);
  scene.Structures[0].Law.Relaxation = 1.1 * device.Damping / stiffness;
  EXPECT_EQ(StiffnessWarnings(scene, device, 1000.0).size(), 1U);
}

// Into which a ball of 8 mm does not fit, at the top of an organ of 24 mm.
class HollowOrgan
{
public:
  explicit HollowOrgan(const RadialModel& model)
  {
    this->Case.Model = model;
    this->Case.Build(8, 8);
    ComplianceMaps maps;
    Status status = ComplianceMaps::Fit(this->Case.Model, this->Case.Solid, this->Case.Reduced,
                                        {14, 0.0}, {}, maps);
    EXPECT_TRUE(status.IsOk()) << status.Message();
    status = ElasticContactModel::Make(test::Shared(this->Case.Model), maps, this->Model);
    EXPECT_TRUE(status.IsOk()) << status.Message();
  }

  // Of a ball's centre: height over the organ's, and aside across a groove.
  Vector3 Place(double height, double aside, double along = 0.0) const
  {
    const Vector3 across = test::HollowDirection().unitOrthogonal();
    return this->Case.Model.CenterWorld() + height * test::HollowDirection() + aside * across +
           along * test::HollowDirection().cross(across);
  }
  std::unique_ptr<ContactTracker> Tracker() const
  {
    return test::TrackerOf(*this->Model, ToolShape::Sphere(8.0), {});
  }
  // Largest change (N) of the force from tick to tick of 0.01 mm, on a way across.
  double LargestChange(double height, double along) const
  {
    const auto tracker = this->Tracker();
    for (double h = 40.0; h > height; h -= 0.1)
    {
      tracker->Follow(test::At(this->Place(h, -9.0, along)));
    }
    Vector3 last = Vector3::Zero();
    double most = 0.0;
    for (int tick = 0; tick <= 1800; ++tick)
    {
      const Contact& contact =
          tracker->Follow(test::At(this->Place(height, -9.0 + 0.01 * tick, along)));
      most = tick > 0 ? std::max(most, (contact.Elastic->ForceWorld - last).norm()) : most;
      last = contact.Elastic->ForceWorld;
    }
    EXPECT_GT(last.norm(), 0.0);
    return most;
  }
  // Work of the force on a loop, as a part of the energy's span.
  double WorkOfLoop(double height) const
  {
    const auto tracker = this->Tracker();
    double work = 0.0;
    double least = 1e9;
    double most = 0.0;
    Vector3 lastPlace = Vector3::Zero();
    Vector3 lastForce = Vector3::Zero();
    constexpr int Loop = 2000;
    for (int tick = -800; tick <= Loop; ++tick)
    {
      const double angle = 2.0 * Pi * std::max(tick, 0) / Loop;
      const double down = tick < 0 ? -0.02 * tick : 0.0;
      const Vector3 place = this->Place(height + down + 0.8 * std::sin(angle),
                                        0.8 * (1.0 - std::cos(angle)), 0.5 * std::sin(angle));
      const ElasticForce& force = *tracker->Follow(test::At(place)).Elastic;
      if (tick > 0)
      {
        work += 0.5 * (force.ForceWorld + lastForce).dot(place - lastPlace);
        least = std::min(least, force.Energy);
        most = std::max(most, force.Energy);
      }
      lastPlace = place;
      lastForce = force.ForceWorld;
    }
    EXPECT_GT(most - least, 0.05);
    return std::abs(work) / (most - least);
  }

  test::ElasticCase Case;
  std::shared_ptr<const ContactModel> Model;
};

const HollowOrgan& RoundHollow()
{
  static const HollowOrgan organ(test::HollowModel());
  return organ;
}

// Across the top; the larger the number, the narrower.
RadialModel GrooveModel(double narrowness)
{
  const auto radius = [narrowness](const Vector3& d)
  {
    const double aside = d.dot(test::HollowDirection().unitOrthogonal());
    const double top = std::exp(6.0 * (d.dot(test::HollowDirection()) - 1.0));
    return 24.0 - 9.0 * top * std::exp(-narrowness * aside * aside);
  };
  return {20, ProjectOnHarmonics(20, 46, radius), Vector3(1.0, 2.0, 3.0)};
}

// With walls of about 40 degrees.
const HollowOrgan& Groove()
{
  static const HollowOrgan organ(GrooveModel(12.0));
  return organ;
}

// A rigid ball in the groove, and where it is held beside the proxy.
struct HeldBall
{
  explicit HeldBall(double height)
  {
    EXPECT_TRUE(
        TouchableRadialModel::Make(test::Shared(Groove().Case.Model), this->Surface).IsOk());
    NearestPointTracker rigid(this->Surface, Radius, {}, 0.5 * Radius);
    for (double h = 40.0; h > height; h -= 0.1)
    {
      rigid.Follow(test::At(Groove().Place(h, 0.3)));
    }
    this->Probe = Groove().Place(height, 0.3);
    this->Proxy = rigid.Follow(test::At(this->Probe)).ProxyWorld;
    this->Walls.assign(rigid.Walls(), rigid.Walls() + rigid.WallCount());
    EXPECT_GE(this->Walls.size(), 2U);
  }
  ElasticHold At(const Vector3& place) const
  {
    return {*this->Surface, Radius, this->Walls.data(), this->Walls.size(), place, this->Proxy};
  }

  static constexpr double Radius = 8.0; // mm
  std::shared_ptr<const TouchableRadialModel> Surface;
  std::vector<ClosestPoint> Walls;
  Vector3 Probe;
  Vector3 Proxy;
};

// By differences of the place itself, whose tolerance is 1e-6 mm.
TEST(ElasticHold, MotionIsTheSlopeOfThePlaceByTheProbe)
{
  const HeldBall ball(23.0);
  const Eigen::Matrix3d motion = ball.At(ball.Probe).Motion();
  EXPECT_GT(motion.norm(), 0.1);
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector3 step = 1e-2 * Vector3::Unit(axis);
    const Vector3 moved =
        ball.At(ball.Probe + step).CenterWorld() - ball.At(ball.Probe - step).CenterWorld();
    EXPECT_NEAR((moved / 2e-2 - motion * Vector3::Unit(axis)).norm(), 0.0, 2e-3) << axis;
  }
}

TEST(ElasticHold, PlaceDoesNotJumpHoweverDeepTheProbeIs)
{
  const HeldBall ball(24.0);
  Vector3 last = ball.At(ball.Probe).CenterWorld();
  for (int step = 1; step <= 200; ++step)
  {
    const Vector3 place = ball.At(ball.Probe - 0.02 * step * test::HollowDirection()).CenterWorld();
    EXPECT_LT((place - last).norm(), 0.04) << step;
    last = place;
  }
}

TEST(ElasticHold, EqualWallsAreOne)
{
  const HeldBall ball(23.0);
  HeldBall doubled = ball;
  doubled.Walls.insert(doubled.Walls.begin() + 1, ball.Walls.front());
  EXPECT_EQ(doubled.At(ball.Probe).WallCount(), ball.At(ball.Probe).WallCount());
  EXPECT_EQ(doubled.At(ball.Probe).CenterWorld(), ball.At(ball.Probe).CenterWorld());
}

TEST(ElasticContactModel, WallsPushABallOutOfAHollow)
{
  for (const HollowOrgan* organ : {&RoundHollow(), &Groove()})
  {
    const auto tracker = organ->Tracker();
    tracker->Follow(test::At(organ->Place(40.0, 0.0)));
    double last = 0.0;
    for (double height = 30.0; height > 21.5; height -= 0.05)
    {
      const Contact& contact = tracker->Follow(test::At(organ->Place(height, 0.0)));
      const double push = contact.Elastic->ForceWorld.dot(test::HollowDirection());
      EXPECT_GE(push, last - 1e-3) << height;
      last = push;
    }
    EXPECT_GT(last, 0.3);
  }
}

// About what a hand notices, which is 0.035 N, at two millimetres of depth: the wall of a groove is
// known once a rigid ball touches it, when one that yields is already pressed into it. Where the
// ball touches a round hollow all round the force is an estimate.
TEST(ElasticContactModel, ForceDoesNotJumpInAHollow)
{
  for (const double along : {0.0, 0.7, 2.0})
  {
    EXPECT_LT(RoundHollow().LargestChange(23.0, along), 0.035) << along;
    EXPECT_LT(Groove().LargestChange(24.0, along), 0.05) << along;
  }
}

// Away from the middle of a wide groove, one round hollow parts into two walls.
TEST(ElasticContactModel, ForceDoesNotJumpWhereAHollowBecomesANotch)
{
  const HollowOrgan wide(GrooveModel(3.0));
  EXPECT_LT(wide.LargestChange(24.0, 3.5), 0.002);
  EXPECT_LT(wide.LargestChange(24.0, 4.0), 0.007);
}

TEST(ElasticContactModel, LoopsInAHollowTakeLittleWork)
{
  EXPECT_LT(RoundHollow().WorkOfLoop(22.5), 0.08);
  EXPECT_LT(Groove().WorkOfLoop(22.0), 0.02);
}
} // namespace
} // namespace palpate::elastic_contact_model_test
