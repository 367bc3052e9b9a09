#include "FieldContactCases.h"
#include "MeshCases.h"
#include "RandomOrientation.h"
#include "ServoRun.h"

#include <algorithm>
#include <functional>

namespace palpate::servo_handover_test
{
namespace
{
using ModelMaker = std::function<std::shared_ptr<const ContactModel>(double)>;

constexpr double Radius = 20.0; // mm, of spheres around the origin
const Vector3 Pressed(0.3, 0.2,
                      19.0); // 2 mm below first contact of a tool of 1 mm with such a sphere
constexpr double TicksOfHandover = 100.0;  // 0.1 s at 1 kHz
constexpr double TicksOfAppearing = 300.0; // the ramp's 0.3 s

FieldGrid CenteredGrid(int size)
{
  return {{size, size, size},
          Vector3::Constant(-0.25 * (size - 1)),
          Vector3::Constant(0.5),
          Matrix3::Identity()};
}

std::shared_ptr<const ContactModel> HarmonicSphere(double radius)
{
  return test::HarmonicContact({0, {radius * std::sqrt(4.0 * M_PI)}, Vector3::Zero()});
}

std::shared_ptr<const ContactModel> VoxelSphere(double radius)
{
  return test::FieldContact(test::SampledField(
      CenteredGrid(96), test::SphereField{Vector3::Constant(47.5), 2.0 * radius}));
}

std::shared_ptr<const ContactModel> SphereOfFacets(double radius)
{
  const SphericalHarmonicModel sphere(0, {radius * std::sqrt(4.0 * M_PI)}, Vector3::Zero());
  return test::FacetContact(test::MeshOf(sphere, 12));
}

const std::vector<ModelMaker> Spheres = {HarmonicSphere, VoxelSphere, SphereOfFacets};

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

// Rests at a place of the hand during the change from `before` to `after`; the force never steps by
// more than its whole change in `ticks`, and ends as after a long time with `after`.
void ExpectSmooth(const TouchScene& before, const TouchScene& after, double ticks,
                  double differentEnd = 1e-3)
{
  test::ServoRun run(before);
  const Vector3 first = run.RestAt(Pressed);
  test::ServoRun fresh(after);
  const Vector3 end = fresh.RestAt(Pressed);
  Continue(run, after);
  // Trackers of fields and facets end within 0.0005 mm of the others.
  const double step = 1.001 * (end - first).norm() / ticks + 1e-3;
  Vector3 last = first;
  for (int n = 0; n < 400; ++n)
  {
    const Vector3 force = run.TickAt(Pressed);
    ASSERT_LE((force - last).norm(), step) << "tick " << n;
    ASSERT_FALSE(run.Loop.Latest().Safety.IsRamping);
    ASSERT_EQ(run.Loop.Latest().WasContinued, n == 0);
    last = force;
  }
  EXPECT_LE((last - end).norm(), differentEnd);
}

TEST(ServoHandover, RepublishedSceneGivesTheSameForces)
{
  for (const ModelMaker& sphere : Spheres)
  {
    ExpectSmooth(SceneOf(sphere(Radius)), SceneOf(sphere(Radius)), TicksOfHandover);
  }
}

TEST(ServoHandover, NewStiffnessCausesNoStep)
{
  for (const ModelMaker& sphere : Spheres)
  {
    ExpectSmooth(SceneOf(sphere(Radius)), SceneOf(sphere(Radius), 1.1), TicksOfHandover);
    ExpectSmooth(SceneOf(sphere(Radius), 1.1), SceneOf(sphere(Radius)), TicksOfHandover);
  }
}

TEST(ServoHandover, ShrinkingOrGrowingShapeCausesNoStep)
{
  for (const ModelMaker& sphere : Spheres)
  {
    for (const double growth : {-1.0, 1.0, 2.5})
    {
      ExpectSmooth(SceneOf(sphere(Radius)), SceneOf(sphere(Radius + growth)), TicksOfHandover);
    }
    ExpectSmooth(SceneOf(sphere(Radius)), SceneOf(sphere(Radius - 3.0)), TicksOfHandover);
  }
}

TEST(ServoHandover, NewRepresentationCausesNoStep)
{
  for (const ModelMaker& before : Spheres)
  {
    for (const ModelMaker& after : Spheres)
    {
      // If several facets are nearest, the proxy's path decides, on edges of 2 mm.
      ExpectSmooth(SceneOf(before(Radius)), SceneOf(after(Radius)), TicksOfHandover, 0.1);
    }
  }
}

TEST(ServoHandover, NewToolCausesNoStep)
{
  for (const ModelMaker& sphere : Spheres)
  {
    TouchScene larger = SceneOf(sphere(Radius));
    larger.Tool = ToolShape::SpherePoints(2.0, ToolShape::NeighbourCount);
    ExpectSmooth(SceneOf(sphere(Radius)), larger, TicksOfHandover);
  }
}

TEST(ServoHandover, NewStructureAroundTheToolFadesIn)
{
  for (const ModelMaker& sphere : Spheres)
  {
    TouchScene empty = SceneOf(sphere(Radius));
    empty.Structures.clear();
    ExpectSmooth(empty, SceneOf(sphere(Radius)), TicksOfAppearing);
    TouchScene other = SceneOf(sphere(Radius));
    other.Structures[0].Id = 8;
    ExpectSmooth(SceneOf(sphere(5.0)), other, TicksOfAppearing);
  }
}

TEST(ServoHandover, RemovedStructureFadesOutToExactlyZero)
{
  for (const ModelMaker& sphere : Spheres)
  {
    TouchScene empty = SceneOf(sphere(Radius));
    empty.Structures.clear();
    ExpectSmooth(SceneOf(sphere(Radius)), empty, TicksOfHandover);
    test::ServoRun run(SceneOf(sphere(Radius)));
    EXPECT_GT(run.RestAt(Pressed)[2], 0.9);
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
    // The oracle: without continuation, the proxy ends up on the other side.
    ASSERT_TRUE(run.Loop.Publish(std::make_shared<TouchScene>(SceneOf(plate))).IsOk());
    EXPECT_LE(run.RestAt(below)[2], 0.0);
  }
}

TEST(ServoHandover, DraggedWorkspaceLeavesTheToolBeforeAWall)
{
  for (const auto& plate : Plates())
  {
    test::ServoRun run(SceneOf(plate));
    const Vector3 hand(0.0, 0.0, 1.6);
    ASSERT_EQ(run.RestAt(hand), Vector3::Zero());
    TouchScene dragged = SceneOf(plate);
    dragged.Frame = DeviceFrame(Matrix3::Identity(), 1.0, {0.0, 0.0, -2.8});
    Continue(run, dragged);
    double last = 0.0;
    for (int n = 0; n < 400; ++n)
    {
      const double force = run.TickAt(hand)[2];
      ASSERT_LE(std::abs(force - last), 1.4 / TicksOfAppearing + 1e-3);
      last = force;
    }
    EXPECT_NEAR(last, 0.5 * 2.7, 0.01); // from z = -1.2 mm to 1.5 mm
    EXPECT_GT(run.Loop.Latest().ProxyWorld.Z, 1.4);
  }
}

TEST(ServoHandover, DraggedWorkspaceCausesNoStep)
{
  test::Random random(451);
  for (const ModelMaker& sphere : Spheres)
  {
    const TouchScene before = SceneOf(sphere(Radius));
    TouchScene after = before;
    // The hand stays in place, 2 mm deep; its place in the world rotates and moves.
    after.Frame = DeviceFrame(Eigen::AngleAxisd(0.3, test::RandomDirection(random)).matrix(), 0.9,
                              0.5 * test::RandomDirection(random));
    test::ServoRun run(before);
    const Vector3 first = run.RestAt(Pressed);
    Continue(run, after);
    EXPECT_LE((run.TickAt(Pressed) - first).norm(), 1e-3);
    Vector3 last = first;
    for (int n = 0; n < 200; ++n)
    {
      const Vector3 force = run.TickAt(Pressed);
      ASSERT_LE((force - last).norm(), 5.0 / TicksOfHandover); // N, more than either force
      last = force;
    }
    const Vector3 proxy = run.Loop.Latest().ProxyWorld;
    EXPECT_NEAR(proxy.norm(), Radius + 1.0, 0.15); // facets are that much below the sphere
  }
}

TEST(ServoHandover, TakeoverCostsOneExtraQuery)
{
  auto control = std::make_shared<test::WallControl>();
  TouchScene scene = test::WallScene(0.0, {0.5, 0.0}, control);
  scene.Structures[0].Id = 1;
  test::ServoRun run(scene);
  run.RestAt({0.0, 0.0, -1.0});
  const int before = control->Questions;
  Continue(run, scene);
  run.TickAt({0.0, 0.0, -1.0});
  EXPECT_EQ(control->Questions, before + 2);
  run.TickAt({0.0, 0.0, -1.0});
  EXPECT_EQ(control->Questions, before + 3);
}

TEST(ServoHandover, KeepsTheForceUntilANewSample)
{
  test::ServoRun run(SceneOf(HarmonicSphere(Radius)));
  const Vector3 force = run.RestAt(Pressed);
  TouchScene two = SceneOf(HarmonicSphere(Radius));
  two.Structures.insert(two.Structures.begin(), SceneOf(HarmonicSphere(3.0)).Structures[0]);
  two.Structures[0].Id = 3;
  Continue(run, two);
  run.Device.RepeatsSample = true;
  EXPECT_EQ(run.TickAt(Pressed), force);
  EXPECT_EQ(run.Loop.Latest().Structure, 1);
  run.Device.RepeatsSample = false;
  // Two in a row: the second one is adopted after the first has begun.
  Continue(run, SceneOf(HarmonicSphere(Radius)));
  EXPECT_LE((run.TickAt(Pressed) - force).norm(), 1e-9);
  EXPECT_LE((run.TickAt(Pressed) - force).norm(), 1e-9);
  EXPECT_EQ(run.Loop.Latest().Scene, 3U);
}

TEST(ServoHandover, FadesInAtTheStartAndAfterRearm)
{
  test::ServoRun run(SceneOf(HarmonicSphere(Radius)));
  Continue(run, SceneOf(HarmonicSphere(Radius)));
  run.TickAt(Pressed);
  EXPECT_FALSE(run.Loop.Latest().WasContinued);
  EXPECT_TRUE(run.Loop.Latest().Safety.IsRamping);
  const Vector3 force = run.RestAt(Pressed);
  run.Loop.Rearm();
  Continue(run, SceneOf(HarmonicSphere(Radius)));
  EXPECT_EQ(run.TickAt(Pressed), Vector3::Zero());
  EXPECT_TRUE(run.Loop.Latest().Safety.IsRamping);
  EXPECT_LE((run.RestAt(Pressed) - force).norm(), 1e-12);
}

// Organs, laws, tools and frames that change during strokes: the tick that adopts them continues
// the hand's force and its rate of change, except for its own motion.
TEST(ServoHandover, NoTakeoverCausesAStep)
{
  test::Random random(90210);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const auto scene = [&]
  {
    const SphericalHarmonicModel organ = test::RandomOrgan(random, 4);
    TouchScene made =
        SceneOf(test::HarmonicContact({organ.Degree(), organ.Coefficients(), Vector3::Zero()}),
                0.2 + part(random));
    made.Tool = ToolShape::Sphere(2.0 * part(random));
    made.Structures[0].Friction = {0.4, 0.3};
    made.Structures[0].Law.Damping = 0.0005;
    made.Frame = DeviceFrame(test::RandomOrientation(random), 0.5 + part(random),
                             3.0 * test::RandomDirection(random));
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
        run.TickAt((18.0 + 6.0 * std::sin(0.003 * tick)) * direction.Turn(0.0005));
    const SafetyReport& safety = run.Loop.Latest().Safety;
    const bool wasCut = isCut;
    isCut = safety.IsLimited || safety.IsDamping || safety.IsSlewing;
    if (takesOver && !wasCut && !isCut)
    {
      // 0.03 mm of the hand at 1.2 N/mm, as much again for its damping and for proxies that slide.
      ASSERT_LE((force - last).norm(), lastStep + 0.1) << "tick " << tick;
      touches += last.norm() > 0.2 ? 1 : 0;
    }
    lastStep = (force - last).norm();
    last = force;
  }
  EXPECT_EQ(run.Loop.Latest().Safety.Fault, SafetyFault::None);
  EXPECT_GT(touches, 200);
}
} // namespace
} // namespace palpate::servo_handover_test
