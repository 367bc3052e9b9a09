// A simulated hand that turns: a capsule that is pressed, stroked and twisted gives out no more
// energy than it took in, and comes to rest, up to the stiffness that StiffnessAdvice calls stable.
#include "ContactCases.h"
#include "FieldContactCases.h"
#include "MeshCases.h"
#include "SimulatedTouch.h"
#include "StiffnessAdvice.h"

#include <algorithm>
#include <memory>
#include <string>

namespace palpate::turning_passivity_test
{
namespace
{
constexpr double Rate = 1000.0;     // Hz
constexpr double ToolRadius = 2.0;  // mm
constexpr double TurnLength = 25.0; // mm, of the device
constexpr double Damping = 0.002;   // N s/mm, of the mechanism
constexpr double Unnoticed = 0.01;  // N mm
constexpr int RestingTicks = 3000;

// What is pressed, and the place (world) at which a tool's ball begins to touch it from above.
struct Thing
{
  std::shared_ptr<const ContactModel> Model;
  Vector3 TopWorld = Vector3::Zero();
  Vector3 OutWorld = Vector3::UnitZ();
};

Thing Organ()
{
  test::Random random(65);
  const RadialModel organ = test::RandomOrgan(random, 6);
  return {test::RadialContact(organ), organ.PointWorld(Vector3::UnitZ()), Vector3::UnitZ()};
}

// An edge of a box.
Thing Wedge()
{
  return {test::FacetContact(test::BoxMesh({30.0, 20.0, 20.0})),
          {0.0, 20.0, 20.0},
          Vector3(0.0, 1.0, 1.0).normalized()};
}

Thing Voxels()
{
  const FieldGrid grid({96, 96, 96}, Vector3::Constant(-23.75), Vector3::Constant(0.5),
                       Matrix3::Identity());
  return {test::FieldContact(
              test::SampledField(grid, test::SphereField{Vector3::Constant(47.5), 30.0})),
          {0.0, 0.0, 15.0},
          Vector3::UnitZ()};
}

TouchScene SceneOf(const Thing& thing, double toolLength, double stiffness)
{
  TouchScene scene;
  scene.Tool = ToolShape::Capsule(ToolRadius, toolLength, 200);
  scene.Structures.push_back({"thing", thing.Model, {stiffness, 0.0}, {}});
  const auto turn = Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), thing.OutWorld);
  scene.Frame =
      DeviceFrame(turn.toRotationMatrix(), 1.0, thing.TopWorld + ToolRadius * thing.OutWorld);
  return scene;
}

// Presses 3 mm deep twice a second and strokes, while the tool lies across and is tilted, rolled
// and swung at three other, seeded rates; after `end` (s) it holds what it has then.
SimulatedSettings HandOf(unsigned seed, double end)
{
  test::Random random(seed);
  std::uniform_real_distribution<double> rate(0.5, 3.0);
  const Vector3 rates(rate(random), rate(random), rate(random));
  SimulatedSettings device;
  device.Path = [=](double t) { return test::PressingPath(3.0, 2.0)(std::min(t, end)); };
  device.TurnPath = [=](double t)
  {
    const Vector3 phase = 2.0 * M_PI * std::min(t, end) * rates;
    const Vector3 turn(0.4 * std::sin(phase[0]), 0.4 * std::sin(phase[1]), std::sin(phase[2]));
    const Eigen::Quaterniond across(Eigen::AngleAxisd(0.5 * M_PI, Vector3::UnitX()));
    return Eigen::AngleAxisd(turn.norm(), turn.normalized()) * across;
  };
  // Only the bounds under test: no friction, no quantisation, no saturation.
  device.Resolution = 0.0;
  device.Hand.Damping = Damping;
  device.Hand.Friction = 0.0;
  device.Wrist.Damping = TurnLength * TurnLength * Damping;
  device.Wrist.Friction = 0.0;
  device.MaximumStiffness = 0.0;
  device.MaximumForce = 1000.0;
  device.MaximumTorque = TurnLength * device.MaximumForce;
  device.MaximumDamping = 0.0;
  return device;
}

struct Session
{
  double LeastEnergy = 0.0; // N mm, taken in since the contact of a tick began, over all ticks
  double MostTorque = 0.0;  // N mm
  // While the hand holds still, in the last second: mm, rad and N mm.
  double Shift = 0.0;
  double Turn = 0.0;
  double Given = 0.0;
};

// `share` of the advised stiffness.
Session Touch(const Thing& thing, double toolLength, double share, int ticks, unsigned seed)
{
  const SimulatedSettings device = HandOf(seed, (ticks - RestingTicks) / Rate + 0.25);
  ServoSettings settings;
  settings.Rate = Rate;
  settings.RampDuration = 0.0;
  settings.MaximumSlew = 1e9;
  ManualClock clock;
  const double stiffness =
      share * StiffestStable(SimulatedDevice(clock, device).Capabilities(), Rate, 0.0).Largest;
  test::SimulatedTouch touch(SceneOf(thing, toolLength, stiffness), device, settings);
  const SimulatedDevice& hand = touch.Device;
  const auto takenIn = [&]
  { return hand.Hand().Energy().TakenIn() + hand.Wrist().Energy().TakenIn(); };
  const auto given = [&]
  { return hand.Hand().Energy().MotorWork + hand.Wrist().Energy().MotorWork; };
  Session session;
  double begun = 0.0;
  double before = 0.0;
  for (int n = 0; n < ticks; ++n)
  {
    const TouchState& state = touch.Tick();
    EXPECT_EQ(state.Safety.Fault, SafetyFault::None);
    session.MostTorque = std::max(session.MostTorque, Vector3(state.TorqueDevice).norm());
    begun = state.Structure < 0 ? takenIn() : begun;
    session.LeastEnergy = std::min(session.LeastEnergy, takenIn() - begun);
    if (n == ticks - 1000)
    {
      before = given();
    }
    else if (n > ticks - 1000)
    {
      session.Shift = std::max(session.Shift, hand.Hand().Velocity().norm() / Rate);
      session.Turn = std::max(session.Turn, hand.Wrist().Velocity().norm() / Rate);
      session.Given = std::max(session.Given, given() - before);
    }
  }
  return session;
}

void ExpectPassive(const Thing& thing, double toolLength, int ticks)
{
  const Session session = Touch(thing, toolLength, 0.99, ticks, 65);
  EXPECT_GE(session.LeastEnergy, -Unnoticed) << toolLength;
  EXPECT_GT(session.MostTorque, 5.0) << toolLength << ": it was twisted";
  EXPECT_LT(session.Shift, 1e-3) << toolLength;
  EXPECT_LT(session.Turn, 1e-4) << toolLength;
  EXPECT_LE(session.Given, Unnoticed) << toolLength;
}

// Of the longer tool the device's stiffness of turns is the limit, of the other one its own length.
void ExpectPassive(const Thing& thing)
{
  ExpectPassive(thing, 120.0, 100'000);
  ExpectPassive(thing, 20.0, 10'000);
}

TEST(TurningPassivity, CapsuleOnAModel)
{
  ExpectPassive(Organ());
}

TEST(TurningPassivity, CapsuleAcrossAnEdgeOfFacets)
{
  ExpectPassive(Wedge());
}

TEST(TurningPassivity, CapsuleOnVoxels)
{
  ExpectPassive(Voxels());
}

TEST(TurningPassivity, StifferThanAdvisedIsActive)
{
  EXPECT_LT(Touch(Organ(), 120.0, 6.0, 8000, 65).LeastEnergy, -0.1);
}
} // namespace
} // namespace palpate::turning_passivity_test
