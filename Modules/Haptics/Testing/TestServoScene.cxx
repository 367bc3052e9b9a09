#include "ServoScene.h"

#include "FieldContactCases.h"
#include "ManyStructures.h"
#include "MeshCases.h"
#include "VolumeViscosity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace palpate::servo_scene_test
{
namespace
{
using Feeling = ServoScene::Feeling;

constexpr double VelocityTime = 0.003; // s

// Brute force: queries every structure in every tick.
class AllAsked
{
public:
  explicit AllAsked(const TouchScene& scene)
  {
    for (const TouchStructure& structure : scene.Structures)
    {
      EXPECT_TRUE(StructureFollower::Make(structure, scene, VelocityTime, this->Followers).IsOk());
    }
  }
  Feeling Follow(const FollowStep& step)
  {
    Feeling feeling;
    feeling.Deepest.ProxyWorld = step.Now.PositionWorld;
    for (std::size_t i = 0; i < this->Followers.size(); ++i)
    {
      feeling.Force += this->Followers[i].Follow(step);
      const Contact& contact = this->Followers[i].Touched();
      feeling.IsValid = feeling.IsValid && contact.IsValid;
      if (contact.IsTouching && (feeling.Structure < 0 || contact.Depth > feeling.Deepest.Depth))
      {
        feeling.Structure = static_cast<int>(i);
        feeling.Deepest = contact;
      }
    }
    return feeling;
  }
  void Leave()
  {
    for (StructureFollower& follower : this->Followers)
    {
      follower.Leave();
    }
  }

private:
  std::vector<StructureFollower> Followers;
};

// NaN never compares equal.
bool AreSameBits(const Vector3& a, const Vector3& b)
{
  const auto isSame = [&](int axis)
  { return a[axis] == b[axis] && std::signbit(a[axis]) == std::signbit(b[axis]); };
  return isSame(0) && isSame(1) && isSame(2);
}

// Organs so close that some lie within others.
RadialModel CloseOrgan(test::Random& random)
{
  const RadialModel organ = test::RandomOrgan(random, 4);
  return {organ.Degree(), organ.Coefficients(), 0.5 * organ.CenterWorld()};
}

// By harmonics, facets and voxels.
TouchScene RandomScene(test::Random& random)
{
  TouchScene scene;
  scene.Tool = ToolShape::SpherePoints(1.5, ToolShape::NeighbourCount);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const auto add = [&](std::shared_ptr<const ContactModel> model)
  {
    TouchStructure structure;
    structure.Name = std::to_string(scene.Structures.size());
    structure.Model = std::move(model);
    structure.Law = {0.2 + part(random), 0.001 * part(random)};
    structure.Friction.Static = part(random) < 0.5 ? 0.0 : 0.3;
    structure.Friction.Dynamic = 0.5 * structure.Friction.Static;
    structure.Effects = {std::make_shared<const VolumeViscosity>(0.001 * part(random))};
    scene.Structures.push_back(structure);
  };
  for (int n = 0; n < 12; ++n)
  {
    add(test::RadialContact(CloseOrgan(random)));
    add(test::FacetContact(test::MeshOf(CloseOrgan(random), 3)));
    add(test::FacetSphere(100.0 * test::RandomDirection(random), 10.0 * part(random)));
  }
  add(test::FieldContact(
      test::SampledField(test::FineGrid(32), test::SphereField{Vector3::Constant(15.5), 14.0})));
  return scene;
}

// A hand that rests, creeps, strokes and jumps, queries its models every `interval` ticks, and
// restarts occasionally; calls visit(step, begins) for each tick.
template <typename Visit>
void WanderAbout(test::Random& random, int interval, int ticks, const Visit& visit)
{
  FollowStep step;
  step.ModelPeriod = interval > 1 ? 0.001 * interval : 0.0;
  Vector3 place = 60.0 * test::RandomDirection(random);
  step.Last.PositionWorld = place;
  double stride = 0.1;
  for (int tick = 0; tick < ticks; ++tick)
  {
    const bool begins = tick % 1000 == 0;
    if (tick % 50 == 0)
    {
      stride = tick % 300 == 0 ? 0.0 : std::pow(10.0, static_cast<double>(random() % 4) - 2.0);
    }
    place += stride * test::RandomDirection(random) - 0.001 * stride * place;
    step.Now.PositionWorld = place;
    step.AsksModel = begins || tick % interval == 0;
    step.Last = begins ? step.Now : step.Last;
    step.Passed = begins ? 0.0 : 0.001;
    visit(step, begins);
    step.Last = step.AsksModel ? step.Now : step.Last;
  }
}

TEST(ServoScene, ForcesEqualThoseOfQueryingAllStructures)
{
  test::Random random(8811);
  int touches = 0;
  std::size_t looks = 0;
  for (const int interval : {1, 1, 3})
  {
    const auto shared = std::make_shared<const TouchScene>(RandomScene(random));
    AllAsked all(*shared);
    std::unique_ptr<ServoScene> scene;
    ASSERT_TRUE(ServoScene::Make(shared, VelocityTime, scene).IsOk());
    WanderAbout(random, interval, 20000,
                [&](const FollowStep& step, bool begins)
                {
                  if (begins)
                  {
                    all.Leave();
                    scene->Leave();
                  }
                  const Feeling expected = all.Follow(step);
                  const Feeling felt = scene->Follow(step);
                  ASSERT_TRUE(AreSameBits(felt.Force, expected.Force));
                  ASSERT_EQ(felt.Structure, expected.Structure);
                  ASSERT_EQ(felt.IsValid, expected.IsValid);
                  ASSERT_TRUE(AreSameBits(felt.Deepest.ProxyWorld, expected.Deepest.ProxyWorld));
                  ASSERT_EQ(felt.Deepest.Depth, expected.Deepest.Depth);
                  touches += felt.Structure >= 0 ? 1 : 0;
                  looks += scene->LookedAtCount();
                });
  }
  EXPECT_GT(touches, 10000);
  EXPECT_LT(touches, 55000);
  EXPECT_LT(looks, 60000u * 37u / 2u);
}

TEST(ServoScene, ExaminesFewOfTenThousandStructures)
{
  const TouchScene scene = test::ManyStructures(10000);
  std::unique_ptr<ServoScene> servo;
  ASSERT_TRUE(
      ServoScene::Make(std::make_shared<const TouchScene>(scene), VelocityTime, servo).IsOk());
  int touches = 0;
  FollowStep step;
  step.Passed = 0.001;
  step.Now.PositionWorld = test::PlaceOnFirst(0);
  for (int tick = 0; tick < 1000; ++tick)
  {
    step.Last = step.Now;
    step.Now.PositionWorld = test::PlaceOnFirst(tick);
    touches += servo->Follow(step).Structure == 0 ? 1 : 0;
    // It leaves its own box by 1.5 mm, and others are 2 mm away.
    ASSERT_LE(servo->LookedAtCount(), 8u);
  }
  EXPECT_GT(touches, 900);
  // Structures out of reach are cheap too: a tracker of facets, a follower, an index entry.
  EXPECT_LT(servo->Bytes(), 10000u * 1100u);
}

TEST(ServoScene, StructurePassedInOneTickIsTouchedAmongMany)
{
  std::unique_ptr<ServoScene> servo;
  const auto scene = std::make_shared<const TouchScene>(test::ManyStructures(1000));
  ASSERT_TRUE(ServoScene::Make(scene, VelocityTime, servo).IsOk());
  FollowStep step;
  step.Passed = 0.001;
  const Vector3 beyond = 2.0 * scene->BoundsWorld().max();
  step.Last.PositionWorld = step.Now.PositionWorld = beyond;
  EXPECT_EQ(servo->Follow(step).Structure, -1);
  step.Now.PositionWorld = Vector3::Zero();
  EXPECT_GE(servo->Follow(step).Structure, 0);
}
} // namespace
} // namespace palpate::servo_scene_test
