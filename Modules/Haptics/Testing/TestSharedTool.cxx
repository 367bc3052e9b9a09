#include "ContactCases.h"
#include "ElasticContactModel.h"
#include "ServoRun.h"
#include "ServoScene.h"
#include "SomeMaps.h"

namespace palpate::shared_tool_test
{
namespace
{
constexpr double BodyRadius = 15.0; // mm
constexpr double ToolRadius = 2.0;  // mm
constexpr double Stiffness = 0.8;   // N/mm

TouchStructure StructureOf(const RadialModel& model, int id)
{
  TouchStructure structure;
  structure.Name = "body";
  structure.Model = test::RadialContact(model);
  structure.Law.Stiffness = Stiffness;
  structure.Law.Damping = 0.001;
  structure.Id = id;
  return structure;
}

TouchScene SceneOf(const RadialModel& model, const ToolShape& tool)
{
  TouchScene scene;
  scene.Structures.push_back(StructureOf(model, 1));
  scene.Tool = tool;
  return scene;
}

const RadialModel& Ball()
{
  static const RadialModel ball = test::Sphere(BodyRadius);
  return ball;
}

// A scene without a servo, whose hand also turns.
class Feeling
{
public:
  explicit Feeling(const TouchScene& scene, double turnLength = 0.0)
  {
    const Status status =
        ServoScene::Make(std::make_shared<const TouchScene>(scene), 0.003, this->Scene, turnLength);
    EXPECT_TRUE(status.IsOk()) << status.Message();
  }
  ServoScene::Feeling At(const ToolPose& hand)
  {
    this->Step.IsPlaced = this->IsFirst;
    this->IsFirst = false;
    this->Step.Last = this->Step.IsPlaced ? hand : this->Step.Now;
    this->Step.Now = hand;
    this->Step.Hand = this->Scene->Scene().Frame.LengthDevice(hand.PositionWorld);
    this->Step.Passed = 0.001;
    return this->Scene->Follow(this->Step);
  }
  // Until the tool and all filters rest.
  ServoScene::Feeling RestAt(const ToolPose& hand)
  {
    ServoScene::Feeling felt;
    for (int tick = 0; tick < 600; ++tick)
    {
      felt = this->At(hand);
    }
    return felt;
  }

private:
  std::unique_ptr<ServoScene> Scene;
  FollowStep Step;
  bool IsFirst = true;
};

const Eigen::Quaterniond Lying(Eigen::AngleAxisd(0.5 * EIGEN_PI, Vector3::UnitY()));

TEST(SharedTool, OneBallFeelsWhatASphereFeels)
{
  test::Random random(31);
  const RadialModel organ = test::RandomOrgan(random, 8);
  TouchScene sphere = SceneOf(organ, ToolShape::Sphere(ToolRadius));
  sphere.Structures[0].Friction = {0.0, 0.0};
  TouchScene ball = SceneOf(organ, ToolShape::Capsule(ToolRadius, 0.0, 26));
  Feeling bySphere(sphere);
  Feeling byBall(ball);
  test::WanderingDirection direction(random);
  double most = 0.0;
  for (int tick = 0; tick < 3000; ++tick)
  {
    const Vector3 u = direction.Next(0.003);
    const double depth = 1.5 * std::sin(0.01 * tick) - 0.3;
    const ToolPose hand = test::At(organ.PointWorld(u) + (ToolRadius - depth) * u);
    const Vector3 force = bySphere.At(hand).Force;
    most = std::max(most, force.norm());
    // Both are within 1e-4 mm of the same place, of which damping sees 1000 a second.
    ASSERT_LE((byBall.At(hand).Force - force).norm(), 1e-3) << tick;
  }
  EXPECT_GT(most, 0.8) << "it was touched";
}

TEST(SharedTool, ToolThatIsFoundInsideIsNotPushedOut)
{
  Feeling feeling(SceneOf(Ball(), ToolShape::Capsule(ToolRadius, 8.0, 200)));
  const ServoScene::Feeling buried = feeling.RestAt(test::At({1.0, 0.0, 0.0}));
  EXPECT_TRUE(buried.IsBuried);
  EXPECT_EQ(buried.Force.norm(), 0.0);
  EXPECT_EQ(feeling.RestAt(test::At({40.0, 0.0, 0.0})).Force.norm(), 0.0);
  // From outside it is held: a millimetre deep, with its end towards the ball.
  const ToolPose pressed{{BodyRadius + ToolRadius + 4.0 - 1.0, 0.0, 0.0}, Lying};
  feeling.RestAt({{40.0, 0.0, 0.0}, Lying});
  EXPECT_NEAR(feeling.RestAt(pressed).Force.x(), Stiffness, 1e-4);
}

TEST(SharedTool, TorqueTurnsTheHandTowardsTheProxy)
{
  TouchScene scene = SceneOf(Ball(), ToolShape::Capsule(ToolRadius, 20.0, 200));
  // Lying across the ball, pressed beside the middle, so that it has to tip.
  const ToolPose hand{{4.0, 0.0, BodyRadius + ToolRadius - 1.0}, Lying};
  const ToolPose above{{4.0, 0.0, BodyRadius + ToolRadius + 5.0}, Lying};
  Feeling feeling(scene);
  feeling.RestAt(above);
  const ServoScene::Feeling felt = feeling.RestAt(hand);
  const double length = scene.Tool.Skeleton()->Gyration();
  const Eigen::AngleAxisd turn(felt.ProxyOrientation * hand.Orientation.conjugate());
  EXPECT_GT(std::abs(turn.angle()), 0.01);
  EXPECT_LE((felt.Torque - Stiffness * length * length * turn.angle() * turn.axis()).norm(),
            1e-3 * felt.Torque.norm());
  EXPECT_LE((felt.Force - Stiffness * (felt.Deepest.ProxyWorld - hand.PositionWorld)).norm(),
            1e-3 * felt.Force.norm());
  // In a world that is magnified twice, the tool at the hand is half as long.
  scene.Frame = DeviceFrame(Matrix3::Identity(), 2.0, Vector3::Zero());
  Feeling magnified(scene);
  magnified.RestAt(above);
  const ServoScene::Feeling small = magnified.RestAt(hand);
  EXPECT_LE((4.0 * small.Torque - felt.Torque).norm(), 1e-6 * felt.Torque.norm());
  EXPECT_LE((2.0 * small.Force - felt.Force).norm(), 1e-6 * felt.Force.norm());
}

TEST(SharedTool, TurnsAreNoStifferThanTheDeviceAllows)
{
  constexpr double TurnLength = 3.0; // mm; the tool's own is twice that, and less at the hand
  TouchScene scene = SceneOf(Ball(), ToolShape::Capsule(ToolRadius, 20.0, 200));
  for (const double scale : {1.0, 4.0})
  {
    scene.Frame = DeviceFrame(Matrix3::Identity(), scale, Vector3::Zero());
    Feeling feeling(scene, TurnLength);
    feeling.RestAt({{4.0, 0.0, BodyRadius + ToolRadius + 5.0}, Lying});
    const ToolPose hand{{4.0, 0.0, BodyRadius + ToolRadius - 1.0}, Lying};
    const ServoScene::Feeling felt = feeling.RestAt(hand);
    const Eigen::AngleAxisd turn(felt.ProxyOrientation * hand.Orientation.conjugate());
    const double most = std::min(TurnLength, scene.Tool.Skeleton()->Gyration() / scale);
    EXPECT_GT(turn.angle(), 0.01);
    EXPECT_NEAR(felt.Torque.norm(), Stiffness * most * most * turn.angle(),
                1e-3 * felt.Torque.norm());
  }
}

// On the body's surface, beside the capsule's middle, however long it is.
TEST(SharedTool, TickSaysWhereTheToolTouches)
{
  constexpr double Length = 10.0; // mm
  constexpr double Close = 1e-3;  // mm, of the relaxed proxy
  test::ServoRun capsule(SceneOf(Ball(), ToolShape::Capsule(ToolRadius, Length, 26)));
  const Vector3 pressed(BodyRadius + ToolRadius - 1.0, 0.0, 0.0);
  capsule.RestAt(2.0 * pressed);
  EXPECT_FALSE(capsule.Loop.Latest().HasFoot);
  capsule.MoveAndRest(2.0 * pressed, pressed);
  const TouchState& state = capsule.Loop.Latest();
  ASSERT_EQ(state.Structure, 0);
  ASSERT_TRUE(state.HasFoot);
  EXPECT_LT((Vector3(state.FootWorld) - Vector3(BodyRadius, 0.0, 0.0)).norm(), Close);
  test::ServoRun sphere(SceneOf(Ball(), ToolShape::Sphere(ToolRadius)));
  sphere.MoveAndRest(2.0 * pressed, pressed);
  EXPECT_EQ(sphere.Loop.Latest().Structure, 0);
  EXPECT_FALSE(sphere.Loop.Latest().HasFoot);
}

TEST(SharedTool, BytesGrowWithItsBalls)
{
  const auto bytes = [](double length)
  {
    std::unique_ptr<ServoScene> made;
    const auto scene = std::make_shared<const TouchScene>(
        SceneOf(Ball(), ToolShape::Capsule(ToolRadius, length, 26)));
    EXPECT_TRUE(ServoScene::Make(scene, 0.005, made).IsOk());
    return made->Bytes();
  };
  constexpr std::size_t OfBall = 500; // at least: the closest points that it tracks
  EXPECT_GT(bytes(40.0), bytes(0.0) + 40 * OfBall);
}

TEST(SharedTool, NextSceneCarriesOn)
{
  const auto scene =
      std::make_shared<const TouchScene>(SceneOf(Ball(), ToolShape::Capsule(ToolRadius, 8.0, 200)));
  test::ScriptedDevice device;
  Servo servo(device, ServoSettings());
  ASSERT_TRUE(servo.Publish(scene).IsOk());
  std::uint64_t tick = 0;
  const auto tickAt = [&](double height)
  {
    const TickObservation now = test::HealthyTick(tick++, {0.0, 0.0, height});
    device.Next.Position = now.Sample.Position;
    device.Next.Time = now.Sample.Time;
    servo.Tick(now.Tick);
    return device.Applied;
  };
  const double touching = BodyRadius + ToolRadius + 4.0;
  for (double height = touching + 5.0; height > touching - 1.0; height -= 0.01)
  {
    tickAt(height);
  }
  Vector3 before = Vector3::Zero();
  for (int n = 0; n < 600; ++n)
  {
    before = tickAt(touching - 1.0);
  }
  EXPECT_NEAR(before.z(), Stiffness, 1e-3);
  ASSERT_TRUE(servo.Publish(scene, SceneEntry::Continuing).IsOk());
  for (int n = 0; n < 600; ++n)
  {
    EXPECT_LE((tickAt(touching - 1.0) - before).norm(), 1e-3) << n;
  }
}

TEST(SharedTool, StructureThatYieldsRefusesItWithAReason)
{
  TouchScene scene = SceneOf(Ball(), ToolShape::Capsule(ToolRadius, 8.0, 200));
  ASSERT_TRUE(
      ElasticContactModel::Make(test::Shared(Ball()), test::SomeMaps(), scene.Structures[0].Model)
          .IsOk());
  std::unique_ptr<ServoScene> servo;
  const Status status = ServoScene::Make(std::make_shared<const TouchScene>(scene), 0.003, servo);
  EXPECT_EQ(status.Message(), "The structure body cannot be touched: it is touched by spheres and "
                              "points only.");
}
} // namespace
} // namespace palpate::shared_tool_test
