// The torque of a hand that rests in a scene when a program replaces it, as TestServoHandover has
// the force.
#include "ContactCases.h"
#include "ServoRun.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace palpate::torque_handover_test
{
namespace
{
constexpr double Radius = 15.0; // mm, of the body
constexpr double ToolRadius = 2.0;
// N mm; the solver ends within 1e-6 mm of its place, and a hundredth of this is below any hand's
// resolution of torque.
constexpr double Unnoticed = 0.05;
const Eigen::Quaterniond Lying(Eigen::AngleAxisd(0.5 * EIGEN_PI, Vector3::UnitY()));
// Across the ball, pressed beside the middle, so that it tips.
const Vector3 Pressed(4.0, 0.0, Radius + ToolRadius - 1.0);
const Vector3 Outside(4.0, 0.0, Radius + ToolRadius + 5.0);

std::shared_ptr<const ContactModel> Ball(double radius)
{
  return test::RadialContact({0, {radius * std::sqrt(4.0 * M_PI)}, Vector3::Zero()});
}

TouchScene SceneOf(double stiffness = 0.5)
{
  TouchScene scene;
  scene.Tool = ToolShape::Capsule(ToolRadius, 20.0, 200);
  scene.Structures.push_back({"ball", Ball(Radius), {stiffness, 0.0}, {}});
  scene.Structures[0].Id = 7;
  return scene;
}

DeviceCapabilities Twisting()
{
  DeviceCapabilities device = test::ScriptedDevice().Abilities;
  device.MaximumTorque = 200.0;
  return device;
}

class HeldTool : public test::ServoRun
{
public:
  explicit HeldTool(const TouchScene& scene) : ServoRun(scene, ServoSettings(), Twisting())
  {
    this->TurnTo(Lying);
  }
  void TurnTo(const Eigen::Quaterniond& orientation)
  {
    Eigen::Map<Eigen::Vector4d>(this->Device.Next.Orientation.data()) = orientation.coeffs();
  }
  Vector3 TorqueAt(const Vector3& place)
  {
    this->TickAt(place);
    return this->Device.AppliedTorque;
  }
  void Continue(const TouchScene& scene)
  {
    ASSERT_TRUE(
        this->Loop.Publish(std::make_shared<TouchScene>(scene), SceneEntry::Continuing).IsOk());
  }
  double Twisted()
  {
    this->MoveAndRest(Outside, Pressed);
    return this->Device.AppliedTorque.norm();
  }
};

// What a program may change of a scene while the hand is in it.
const std::vector<std::pair<std::string, std::function<void(TouchScene&)>>> Changes = {
    {"stiffer", [](TouchScene& scene) { scene.Structures[0].Law.Stiffness *= 2.5; }},
    {"larger shape", [](TouchScene& scene) { scene.Structures[0].Model = Ball(Radius + 1.0); }},
    {"much larger shape",
     [](TouchScene& scene) { scene.Structures[0].Model = Ball(Radius + 6.0); }},
    {"longer tool",
     [](TouchScene& scene) { scene.Tool = ToolShape::Capsule(ToolRadius, 60.0, 200); }},
    {"thicker tool",
     [](TouchScene& scene) { scene.Tool = ToolShape::Capsule(ToolRadius + 1.5, 20.0, 200); }},
    {"sphere", [](TouchScene& scene)
     { scene.Tool = ToolShape::SpherePoints(ToolRadius, ToolShape::NeighbourCount); }},
    {"smaller scale about the hand",
     [](TouchScene& scene) { scene.Frame = DeviceFrame(Matrix3::Identity(), 0.4, 0.6 * Pressed); }},
    {"turned about the hand",
     [](TouchScene& scene)
     {
       const Matrix3 turn = Eigen::AngleAxisd(0.4, Vector3::UnitY()).toRotationMatrix();
       scene.Frame = DeviceFrame(turn, 1.0, Pressed - turn * Pressed);
     }},
    {"second structure",
     [](TouchScene& scene)
     {
       scene.Structures.push_back({"other", Ball(Radius + 0.5), {2.0, 0.0}, {}});
       scene.Structures.back().Id = 20 + static_cast<int>(scene.Structures.size());
     }},
    {"other id", [](TouchScene& scene) { scene.Structures[0].Id = 11; }}};

TEST(TorqueHandover, NoPairOfChangesTwistsARestingHandHarder)
{
  for (const auto& [first, change] : Changes)
  {
    for (const auto& [second, next] : Changes)
    {
      TouchScene scene = SceneOf();
      HeldTool run(scene);
      double most = run.Twisted();
      ASSERT_GT(most, 1.0) << "it is twisted";
      for (const auto& apply : {change, next})
      {
        apply(scene);
        run.Continue(scene);
        for (int tick = 0; tick < 250; ++tick)
        {
          ASSERT_LE(run.TorqueAt(Pressed).norm(), most + Unnoticed)
              << first << ", " << second << ", tick " << tick;
        }
        most = run.TorqueAt(Pressed).norm();
      }
    }
  }
}

TEST(TorqueHandover, RepublishedSceneKeepsTheTorqueWithoutADip)
{
  HeldTool run(SceneOf());
  run.Twisted();
  const Vector3 before = run.Device.AppliedTorque;
  run.Continue(SceneOf());
  for (int tick = 0; tick < 600; ++tick)
  {
    EXPECT_LE((run.TorqueAt(Pressed) - before).norm(), Unnoticed) << tick;
  }
}

TEST(TorqueHandover, RemovedStructureFadesOutInSmallSteps)
{
  HeldTool run(SceneOf());
  Vector3 last = Vector3::Zero();
  const double first = run.Twisted();
  last = run.Device.AppliedTorque;
  TouchScene empty = SceneOf();
  empty.Structures.clear();
  run.Continue(empty);
  for (int tick = 0; tick < 150; ++tick)
  {
    const Vector3 now = run.TorqueAt(Pressed);
    EXPECT_LE((now - last).norm(), 1.01 * first / 100.0) << "a hundredth a tick, " << tick;
    last = now;
  }
  EXPECT_EQ(last, Vector3::Zero());
}

TEST(TorqueHandover, StifferSceneIsFeltByTheHandsTurns)
{
  HeldTool run(SceneOf());
  const double first = run.Twisted();
  run.Continue(SceneOf(1.0));
  run.RestAt(Pressed);
  EXPECT_NEAR(run.Device.AppliedTorque.norm(), first, Unnoticed);
  // On: against the torque, which turns the tool towards its proxy. Back: the same path.
  const Vector3 axis = -run.Device.AppliedTorque.normalized();
  const auto turn = [&](int from, int to)
  {
    for (int tick = from; tick != to; tick += to > from ? 1 : -1)
    {
      run.TurnTo(Eigen::AngleAxisd(0.0002 * tick, axis) * Lying);
      run.TorqueAt(Pressed);
    }
    run.RestAt(Pressed);
    return run.Device.AppliedTorque.norm();
  };
  const double length = SceneOf().Tool.Skeleton()->Gyration();
  EXPECT_NEAR(turn(0, 100), first + 1.0 * length * length * 0.02, Unnoticed);
  EXPECT_NEAR(turn(100, 0), first, Unnoticed);
}
} // namespace
} // namespace palpate::torque_handover_test
