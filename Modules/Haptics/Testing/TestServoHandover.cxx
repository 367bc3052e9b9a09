#include "FieldContactCases.h"
#include "MeshCases.h"
#include "RandomOrientation.h"
#include "ServoRun.h"

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace palpate::servo_handover_test
{
namespace
{
using ModelMaker = std::function<std::shared_ptr<const ContactModel>(double)>;

constexpr double Radius = 20.0; // mm, of spheres around the origin
const Vector3 Pressed(0.3, 0.2,
                      19.0); // 2 mm below first contact of a tool of 1 mm with such a sphere
const Vector3 Outside(0.3, 0.2, 25.0);
constexpr double TicksOfHandover = 100.0; // 0.1 s at 1 kHz
// N, by which the force of a resting hand may rise: trackers of fields and facets end within 0.0005
// mm of the others.
constexpr double Rise = 0.002;

FieldGrid CenteredGrid(int size)
{
  return {{size, size, size},
          Vector3::Constant(-0.25 * (size - 1)),
          Vector3::Constant(0.5),
          Matrix3::Identity()};
}

std::shared_ptr<const ContactModel> RadialSphere(double radius)
{
  return test::RadialContact({0, {radius * std::sqrt(4.0 * M_PI)}, Vector3::Zero()});
}

std::shared_ptr<const ContactModel> VoxelSphere(double radius)
{
  return test::FieldContact(test::SampledField(
      CenteredGrid(96), test::SphereField{Vector3::Constant(47.5), 2.0 * radius}));
}

std::shared_ptr<const ContactModel> SphereOfFacets(double radius)
{
  const RadialModel sphere(0, {radius * std::sqrt(4.0 * M_PI)}, Vector3::Zero());
  return test::FacetContact(test::MeshOf(sphere, 12));
}

const std::vector<ModelMaker> Spheres = {RadialSphere, VoxelSphere, SphereOfFacets};

// Plates with their top at z = 0.5, so thin that a tool placed below it would stay there.
std::vector<std::shared_ptr<const ContactModel>> Plates()
{
  struct Slab
  {
    double Value(const Vector3& index) const { return 1.0 - std::abs(index[2] - 31.5); }
  };
  return {test::FacetContact(test::BoxMesh({15.0, 15.0, 0.5})),
          test::FieldContact(test::SampledField(CenteredGrid(64), Slab()))};
}

TouchScene SceneOf(std::shared_ptr<const ContactModel> model, double stiffness = 0.5)
{
  TouchScene scene;
  scene.Tool = ToolShape::SpherePoints(1.0, ToolShape::NeighbourCount);
  scene.Structures.push_back({"structure", std::move(model), {stiffness, 0.0}, {}});
  scene.Structures[0].Id = 7;
  return scene;
}

void Continue(test::ServoRun& run, const TouchScene& scene)
{
  ASSERT_TRUE(run.Loop.Publish(std::make_shared<TouchScene>(scene), SceneEntry::Continuing).IsOk());
}

// A hand that pressed into a scene rests there while `after` takes over. The force never steps by
// more than its whole change in HandoverDuration, and is never larger than before. Returns the
// force after a long time.
double ForceAfter(const TouchScene& before, const TouchScene& after)
{
  test::ServoRun run(before);
  const Vector3 first = run.MoveAndRest(Outside, Pressed);
  Continue(run, after);
  const double step = 2.002 * first.norm() / TicksOfHandover + Rise;
  Vector3 last = first;
  for (int n = 0; n < 600; ++n)
  {
    const Vector3 force = run.TickAt(Pressed);
    EXPECT_LE((force - last).norm(), step) << "tick " << n;
    EXPECT_LE(force.norm(), first.norm() + Rise) << "tick " << n;
    EXPECT_FALSE(run.Loop.Latest().Safety.IsRamping);
    EXPECT_EQ(run.Loop.Latest().WasContinued, n == 0);
    last = force;
  }
  return last.norm();
}

// The force of a hand that pressed into a scene from outside.
double ForceIn(const TouchScene& scene)
{
  test::ServoRun run(scene);
  return run.MoveAndRest(Outside, Pressed).norm();
}

TEST(ServoHandover, RepublishedSceneGivesTheSameForces)
{
  for (const ModelMaker& sphere : Spheres)
  {
    const TouchScene scene = SceneOf(sphere(Radius));
    EXPECT_NEAR(ForceAfter(scene, scene), ForceIn(scene), Rise);
  }
}

TEST(ServoHandover, LowerStiffnessLowersTheForceAndHigherOneKeepsIt)
{
  for (const ModelMaker& sphere : Spheres)
  {
    const TouchScene soft = SceneOf(sphere(Radius));
    const TouchScene stiff = SceneOf(sphere(Radius), 1.1);
    EXPECT_NEAR(ForceAfter(soft, stiff), ForceIn(soft), Rise);
    EXPECT_NEAR(ForceAfter(stiff, soft), ForceIn(soft), Rise);
  }
}

TEST(ServoHandover, ShrinkingShapeLowersTheForceAndGrowingOneKeepsIt)
{
  for (const ModelMaker& sphere : Spheres)
  {
    const TouchScene before = SceneOf(sphere(Radius));
    EXPECT_NEAR(ForceAfter(before, SceneOf(sphere(Radius - 1.0))),
                ForceIn(SceneOf(sphere(Radius - 1.0))), Rise);
    EXPECT_EQ(ForceAfter(before, SceneOf(sphere(Radius - 3.0))), 0.0);
    EXPECT_NEAR(ForceAfter(before, SceneOf(sphere(Radius + 1.0))), ForceIn(before), Rise);
    // Too far above the old proxy: no force until the hand has left.
    EXPECT_EQ(ForceAfter(before, SceneOf(sphere(Radius + 2.5))), 0.0);
  }
}

TEST(ServoHandover, NewRepresentationKeepsTheForce)
{
  for (const ModelMaker& before : Spheres)
  {
    for (const ModelMaker& after : Spheres)
    {
      // If several facets are nearest, the proxy's path decides, on edges of 2 mm.
      const double first = ForceIn(SceneOf(before(Radius)));
      EXPECT_NEAR(ForceAfter(SceneOf(before(Radius)), SceneOf(after(Radius))), first, 0.1);
    }
  }
}

TEST(ServoHandover, LargerToolKeepsTheForce)
{
  for (const ModelMaker& sphere : Spheres)
  {
    TouchScene larger = SceneOf(sphere(Radius));
    larger.Tool = ToolShape::SpherePoints(2.0, ToolShape::NeighbourCount);
    EXPECT_NEAR(ForceAfter(SceneOf(sphere(Radius)), larger), ForceIn(SceneOf(sphere(Radius))),
                Rise);
  }
}

TEST(ServoHandover, NewStructureAroundTheHandIsSilentUntilItHasLeft)
{
  for (const ModelMaker& sphere : Spheres)
  {
    TouchScene empty = SceneOf(sphere(Radius));
    empty.Structures.clear();
    EXPECT_EQ(ForceAfter(empty, SceneOf(sphere(Radius))), 0.0);
    TouchScene other = SceneOf(sphere(Radius));
    other.Structures[0].Id = 8;
    EXPECT_EQ(ForceAfter(SceneOf(sphere(5.0)), other), 0.0);
    test::ServoRun run(empty);
    run.RestAt(Pressed);
    Continue(run, SceneOf(sphere(Radius)));
    EXPECT_EQ(run.MoveAndRest(Pressed, Outside), Vector3::Zero());
    EXPECT_NEAR(run.MoveAndRest(Outside, Pressed).norm(), ForceIn(SceneOf(sphere(Radius))), Rise);
  }
}

TEST(ServoHandover, SceneThatStartsAroundTheHandIsSilentUntilItHasLeft)
{
  for (const ModelMaker& sphere : Spheres)
  {
    test::ServoRun run(SceneOf(sphere(Radius)));
    EXPECT_EQ(run.RestAt(Pressed), Vector3::Zero());
    run.MoveAndRest(Pressed, Outside);
    const double force = run.MoveAndRest(Outside, Pressed).norm();
    EXPECT_NEAR(force, ForceIn(SceneOf(sphere(Radius))), Rise);
    // After a person has switched forces on again, too.
    run.Loop.Rearm();
    EXPECT_EQ(run.RestAt(Pressed), Vector3::Zero());
  }
}

// N, mm: pushing on raises the force as the new scene does, and retreating lowers it as much.
TEST(ServoHandover, StifferSceneIsFeltByTheHandsMotion)
{
  for (const ModelMaker& sphere : Spheres)
  {
    test::ServoRun run(SceneOf(sphere(Radius)));
    const double first = run.MoveAndRest(Outside, Pressed).norm();
    Continue(run, SceneOf(sphere(Radius), 1.0));
    run.RestAt(Pressed);
    const Vector3 deeper = Pressed - Vector3(0.0, 0.0, 0.5);
    EXPECT_NEAR(run.MoveAndRest(Pressed, deeper).norm(), first + 0.5, 0.02); // the normals' angle
    EXPECT_NEAR(run.MoveAndRest(deeper, Pressed).norm(), first, 0.02);
    run.MoveAndRest(Pressed, Outside);
    EXPECT_NEAR(run.MoveAndRest(Outside, Pressed).norm(), 2.0 * first, 0.02);
  }
}

TEST(ServoHandover, SmallerScaleInContactIsSilentUntilTheHandHasLeft)
{
  for (const ModelMaker& sphere : Spheres)
  {
    TouchScene magnified = SceneOf(sphere(Radius));
    magnified.Frame = DeviceFrame(Matrix3::Identity(), 2.0, Vector3::Zero());
    TouchScene reduced = magnified;
    reduced.Frame = DeviceFrame(Matrix3::Identity(), 0.5, Vector3::Zero());
    test::ServoRun run(magnified);
    const Vector3 light(0.0, 0.0, 10.4);
    const Vector3 first = run.MoveAndRest({0.0, 0.0, 13.0}, light);
    ASSERT_GT(first.norm(), 0.03);
    Continue(run, reduced);
    for (int n = 0; n < 600; ++n)
    {
      ASSERT_LE(run.TickAt(light).norm(), first.norm() + Rise);
    }
    EXPECT_EQ(run.TickAt(light), Vector3::Zero());
    run.MoveAndRest(light, {0.0, 0.0, 44.0});
    EXPECT_NEAR(run.MoveAndRest({0.0, 0.0, 44.0}, {0.0, 0.0, 40.0}).norm(), 1.0, 0.1); // 2 mm deep
  }
}

// What a program may change of a scene while the hand is in it.
const std::vector<std::pair<std::string, std::function<void(TouchScene&, const ModelMaker&)>>>
    Changes = {
        {"stiffer",
         [](TouchScene& scene, const ModelMaker&) { scene.Structures[0].Law.Stiffness *= 2.5; }},
        {"larger shape", [](TouchScene& scene, const ModelMaker& sphere)
         { scene.Structures[0].Model = sphere(Radius + 1.0); }},
        {"much larger shape", [](TouchScene& scene, const ModelMaker& sphere)
         { scene.Structures[0].Model = sphere(Radius + 6.0); }},
        {"other kind", [](TouchScene& scene, const ModelMaker&)
         { scene.Structures[0].Model = RadialSphere(Radius); }},
        {"larger tool", [](TouchScene& scene, const ModelMaker&)
         { scene.Tool = ToolShape::SpherePoints(2.5, ToolShape::NeighbourCount); }},
        {"smaller scale", [](TouchScene& scene, const ModelMaker&)
         { scene.Frame = DeviceFrame(Matrix3::Identity(), 0.5, Vector3::Zero()); }},
        {"larger scale about the hand", [](TouchScene& scene, const ModelMaker&)
         { scene.Frame = DeviceFrame(Matrix3::Identity(), 2.0, -Pressed); }},
        {"smaller scale about the hand", [](TouchScene& scene, const ModelMaker&)
         { scene.Frame = DeviceFrame(Matrix3::Identity(), 0.4, 0.6 * Pressed); }},
        {"moved over the hand",
         [](TouchScene& scene, const ModelMaker&) {
           scene.Frame = DeviceFrame(Matrix3::Identity(), 1.0, {0.0, 0.0, -8.0});
         }},
        {"turned",
         [](TouchScene& scene, const ModelMaker&)
         {
           const Matrix3 turn = Eigen::AngleAxisd(0.5, Vector3::UnitX()).toRotationMatrix();
           scene.Frame = DeviceFrame(turn, 1.0, Vector3::Zero());
         }},
        {"second structure",
         [](TouchScene& scene, const ModelMaker& sphere)
         {
           scene.Structures.push_back(SceneOf(sphere(Radius + 3.0)).Structures[0]);
           scene.Structures.back().Id = 20 + static_cast<int>(scene.Structures.size());
         }},
        {"other id", [](TouchScene& scene, const ModelMaker&) { scene.Structures[0].Id = 11; }}};

// Each change alone and each after each other one, with a hand that rests and then pushes on.
TEST(ServoHandover, NoPairOfChangesRaisesTheForceOfAHandThatRests)
{
  constexpr double Unnoticed = 0.05; // N
  for (const ModelMaker& maker : Spheres)
  {
    std::map<double, std::shared_ptr<const ContactModel>> made;
    const ModelMaker sphere = [&](double radius)
    {
      std::shared_ptr<const ContactModel>& model = made[radius];
      model = model != nullptr ? model : maker(radius);
      return model;
    };
    for (const auto& [first, change] : Changes)
    {
      for (const auto& [second, next] : Changes)
      {
        TouchScene scene = SceneOf(sphere(Radius));
        test::ServoRun run(scene);
        double most = run.MoveAndRest(Outside, Pressed).norm();
        for (const auto& apply : {change, next})
        {
          apply(scene, sphere);
          Continue(run, scene);
          for (int tick = 0; tick < 250; ++tick)
          {
            ASSERT_LE(run.TickAt(Pressed).norm(), most + Unnoticed)
                << first << ", " << second << ", tick " << tick;
          }
          most = run.TickAt(Pressed).norm();
        }
        const double stiffness = scene.Structures[0].Law.Stiffness;
        for (int tick = 1; tick <= 100; ++tick)
        {
          const Vector3 hand = Pressed - Vector3(0.0, 0.0, 0.02 * tick);
          ASSERT_LE(run.TickAt(hand).norm(), most + Unnoticed + stiffness * 0.02 * tick)
              << first << ", " << second << ", pushing on, tick " << tick;
        }
      }
    }
  }
}

TEST(ServoHandover, RemovedStructureFadesOutToExactlyZero)
{
  for (const ModelMaker& sphere : Spheres)
  {
    TouchScene empty = SceneOf(sphere(Radius));
    empty.Structures.clear();
    EXPECT_EQ(ForceAfter(SceneOf(sphere(Radius)), empty), 0.0);
    test::ServoRun run(SceneOf(sphere(Radius)));
    EXPECT_GT(run.MoveAndRest(Outside, Pressed)[2], 0.9);
    Continue(run, empty);
    run.TickAt(Pressed);
    EXPECT_EQ(run.Loop.Latest().Structure, -1);
    // Without contact no force remains, once the slew limit has released 1 N.
    EXPECT_EQ((run.TickAt(Vector3(0.0, 0.0, 22.0)), run.TickAt(Vector3(0.0, 0.0, 22.0))),
              Vector3::Zero());
  }
}

TEST(ServoHandover, WithoutTouchThereIsNoForce)
{
  for (const ModelMaker& sphere : Spheres)
  {
    test::ServoRun run(SceneOf(sphere(Radius)));
    const Vector3 nearby(0.0, 0.0, 21.5);
    run.RestAt(nearby);
    Continue(run, SceneOf(sphere(Radius), 1.1));
    for (int n = 0; n < 200; ++n)
    {
      ASSERT_EQ(run.TickAt(nearby), Vector3::Zero());
    }
    // After contact the full force is there.
    EXPECT_NEAR(run.TickAt({0.0, 0.0, 20.5})[2], 0.55, 0.03); // the facets' height, of 20 mm
  }
}

TEST(ServoHandover, PassesThroughNothing)
{
  for (const auto& plate : Plates())
  {
    test::ServoRun run(SceneOf(plate));
    run.RestAt({0.0, 0.0, 3.0});
    for (int n = 0; n <= 84; ++n)
    {
      run.TickAt({0.0, 0.0, 3.0 - 0.05 * n});
    }
    const Vector3 below(0.0, 0.0, -1.2);
    const Vector3 force = run.RestAt(below);
    ASSERT_GT(force[2], 1.0);
    Continue(run, SceneOf(plate, 0.6));
    for (int n = 0; n < 300; ++n)
    {
      ASSERT_GT(run.TickAt(below)[2], 1.0);
    }
    EXPECT_GT(run.Loop.Latest().ProxyWorld.Z, 1.4);
    // The oracle: without continuation nothing is known of the side that the tool came from.
    ASSERT_TRUE(run.Loop.Publish(std::make_shared<TouchScene>(SceneOf(plate))).IsOk());
    EXPECT_EQ(run.RestAt(below), Vector3::Zero());
  }
}

TEST(ServoHandover, WorkspaceDraggedIntoAWallIsSilentUntilTheToolHasLeft)
{
  for (const auto& plate : Plates())
  {
    test::ServoRun run(SceneOf(plate));
    const Vector3 hand(0.0, 0.0, 1.6);
    ASSERT_EQ(run.RestAt(hand), Vector3::Zero());
    TouchScene dragged = SceneOf(plate);
    dragged.Frame = DeviceFrame(Matrix3::Identity(), 1.0, {0.0, 0.0, -2.8});
    Continue(run, dragged);
    EXPECT_EQ(run.RestAt(hand), Vector3::Zero());
    EXPECT_EQ(run.MoveAndRest(hand, hand - Vector3(0.0, 0.0, 2.0)), Vector3::Zero());
    // From below the plate is there again.
    EXPECT_LT(run.MoveAndRest(hand - Vector3(0.0, 0.0, 2.0), hand)[2], -0.1);
  }
}

TEST(ServoHandover, WorkspaceDraggedBySmallStepsKeepsContactAndForce)
{
  for (const auto& plate : Plates())
  {
    test::ServoRun run(SceneOf(plate));
    const Vector3 hand(0.0, 0.0, 1.0);
    const double first = run.MoveAndRest({0.0, 0.0, 3.0}, hand)[2];
    ASSERT_NEAR(first, 0.25, 0.01); // 0.5 mm deep
    for (int n = 1; n <= 40; ++n)
    {
      TouchScene dragged = SceneOf(plate);
      dragged.Frame = DeviceFrame(Matrix3::Identity(), 1.0, {0.0, 0.0, -0.1 * n});
      Continue(run, dragged);
      for (int tick = 0; tick < 20; ++tick)
      {
        ASSERT_LE(run.TickAt(hand).norm(), first + Rise);
      }
    }
    EXPECT_NEAR(run.RestAt(hand)[2], first, Rise);
    EXPECT_GT(run.Loop.Latest().ProxyWorld.Z, 1.4);
  }
}

TEST(ServoHandover, JumpOfTheFrameFadesTheOldForceOut)
{
  test::Random random(451);
  for (const ModelMaker& sphere : Spheres)
  {
    const TouchScene before = SceneOf(sphere(Radius));
    TouchScene after = before;
    // The hand stays in place, 2 mm deep; its place in the world rotates and moves.
    after.Frame = DeviceFrame(Eigen::AngleAxisd(0.3, test::RandomDirection(random)).matrix(), 0.9,
                              0.5 * test::RandomDirection(random));
    EXPECT_EQ(ForceAfter(before, after), 0.0);
  }
}

TEST(ServoHandover, TakeoverCostsTwoExtraQueries)
{
  auto control = std::make_shared<test::WallControl>();
  TouchScene scene = test::WallScene(0.0, {0.5, 0.0}, control);
  scene.Structures[0].Id = 1;
  test::ServoRun run(scene);
  run.RestAt({0.0, 0.0, -1.0});
  const int before = control->Questions;
  Continue(run, scene);
  run.TickAt({0.0, 0.0, -1.0});
  EXPECT_EQ(control->Questions, before + 3); // where it begins, twice
  run.TickAt({0.0, 0.0, -1.0});
  EXPECT_EQ(control->Questions, before + 4);
}

TEST(ServoHandover, KeepsTheForceUntilANewSample)
{
  test::ServoRun run(SceneOf(RadialSphere(Radius)));
  const Vector3 force = run.MoveAndRest(Outside, Pressed);
  TouchScene two = SceneOf(RadialSphere(Radius));
  two.Structures.insert(two.Structures.begin(), SceneOf(RadialSphere(3.0)).Structures[0]);
  two.Structures[0].Id = 3;
  Continue(run, two);
  run.Device.RepeatsSample = true;
  EXPECT_EQ(run.TickAt(Pressed), force);
  EXPECT_EQ(run.Loop.Latest().Structure, 1);
  run.Device.RepeatsSample = false;
  // Two in a row: the second one is adopted after the first has begun.
  Continue(run, SceneOf(RadialSphere(Radius)));
  EXPECT_LE((run.TickAt(Pressed) - force).norm(), 1e-9);
  EXPECT_LE((run.TickAt(Pressed) - force).norm(), 1e-9);
  EXPECT_EQ(run.Loop.Latest().Scene, 3U);
}

TEST(ServoHandover, ContinuesNothingAtTheStartAndAfterRearm)
{
  test::ServoRun run(SceneOf(RadialSphere(Radius)));
  Continue(run, SceneOf(RadialSphere(Radius)));
  run.TickAt(Outside);
  EXPECT_FALSE(run.Loop.Latest().WasContinued);
  EXPECT_TRUE(run.Loop.Latest().Safety.IsRamping);
  run.MoveAndRest(Outside, Pressed);
  run.Loop.Rearm();
  Continue(run, SceneOf(RadialSphere(Radius)));
  EXPECT_EQ(run.TickAt(Pressed), Vector3::Zero());
  EXPECT_TRUE(run.Loop.Latest().Safety.IsRamping);
  EXPECT_EQ(run.RestAt(Pressed), Vector3::Zero());
}

// Organs, laws, tools and frames that change during strokes: the tick that adopts them continues
// the hand's force and its rate of change, except for its own motion.
TEST(ServoHandover, NoTakeoverCausesAStep)
{
  test::Random random(90210);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const RadialModel organ = test::RandomOrgan(random, 4);
  const Matrix3 turn = test::RandomOrientation(random);
  // One scene of five has nothing in common with the last one.
  const auto scene = [&]
  {
    const bool isOther = part(random) < 0.2;
    std::vector<double> coefficients =
        (isOther ? test::RandomOrgan(random, 4) : organ).Coefficients();
    coefficients[0] *= 0.98 + 0.04 * part(random);
    TouchScene made =
        SceneOf(test::RadialContact({4, coefficients, Vector3::Zero()}), 0.2 + part(random));
    made.Tool = ToolShape::Sphere(2.0 * part(random));
    made.Structures[0].Friction = {0.4, 0.3};
    made.Structures[0].Law.Damping = 0.0005;
    made.Frame = isOther ? DeviceFrame(test::RandomOrientation(random), 0.5 + part(random),
                                       3.0 * test::RandomDirection(random))
                         : DeviceFrame(turn, 1.0, 0.2 * test::RandomDirection(random));
    return made;
  };
  test::ServoRun run(scene());
  test::WanderingDirection direction(random);
  Vector3 last = Vector3::Zero();
  double lastStep = 0.0; // N
  bool isCut = false;
  int touches = 0;
  for (int tick = 0; tick < 30000; ++tick)
  {
    const bool takesOver = tick > 600 && tick % 37 == 0;
    if (takesOver)
    {
      Continue(run, scene());
    }
    const Vector3 force =
        run.TickAt((18.0 + 6.0 * std::sin(0.003 * tick)) * direction.Next(0.0005));
    const SafetyReport& safety = run.Loop.Latest().Safety;
    const bool wasCut = isCut;
    isCut = safety.IsLimited || safety.IsDamping || safety.IsSlewing;
    if (takesOver && !wasCut && !isCut)
    {
      // 0.03 mm of the hand at 1.2 N/mm, as much again for its damping and for proxies that slide.
      ASSERT_LE((force - last).norm(), lastStep + 0.1) << "tick " << tick;
      ASSERT_LE(force.norm(), last.norm() + 0.1) << "tick " << tick;
      touches += last.norm() > 0.2 ? 1 : 0;
    }
    lastStep = (force - last).norm();
    last = force;
  }
  EXPECT_EQ(run.Loop.Latest().Safety.Fault, SafetyFault::None);
  EXPECT_GT(touches, 80);
}
} // namespace
} // namespace palpate::servo_handover_test
