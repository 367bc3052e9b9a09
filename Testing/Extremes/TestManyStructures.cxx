// A scene of a million structures of which one is touched.
#include "ServoRun.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

namespace palpate::many_structures_test
{
namespace
{
// A sphere that keeps a point out, as a minimal contact model.
class SmallSphere final : public ContactModel
{
public:
  static constexpr double Radius = 1.0; // mm

  explicit SmallSphere(const Vector3& centerWorld) : Center(centerWorld) {}
  Eigen::AlignedBox3d BoundsWorld() const noexcept override
  {
    return {this->Center - Vector3::Constant(Radius), this->Center + Vector3::Constant(Radius)};
  }
  Status MakeTracker(const ToolShape&, const SurfaceFriction&,
                     std::unique_ptr<ContactTracker>& tracker) const override
  {
    tracker = std::make_unique<Tracker>(this->Center);
    return Status::Success();
  }

private:
  class Tracker final : public ContactTracker
  {
  public:
    explicit Tracker(const Vector3& center) : Center(center) {}
    const Contact& Follow(const ToolPose& pose) noexcept override
    {
      const Vector3 path = pose.PositionWorld - this->Center;
      const double distance = path.norm();
      this->Felt.IsValid = true;
      this->Felt.IsTouching = distance < Radius;
      this->Felt.Depth = this->Felt.IsTouching ? Radius - distance : 0.0;
      this->Felt.NormalWorld = distance > 0.0 ? Vector3(path / distance) : Vector3::UnitZ();
      this->Felt.ProxyWorld = pose.PositionWorld + this->Felt.Depth * this->Felt.NormalWorld;
      return this->Felt;
    }
    void Release() noexcept override {}
    bool IsFreeAt(const ToolPose& pose) noexcept override { return !this->Follow(pose).IsTouching; }

  private:
    Vector3 Center;
    Contact Felt;
  };

  Vector3 Center;
};

constexpr int Side = 100;
constexpr double Apart = 4.0; // mm

Vector3 PlaceOf(int i, int j, int k)
{
  return Apart * Vector3(i, j, k);
}

TouchScene SceneOf(const std::vector<Vector3>& places)
{
  TouchScene scene;
  scene.Tool = ToolShape::Sphere(0.0);
  scene.Structures.reserve(places.size());
  for (const Vector3& place : places)
  {
    scene.Structures.push_back({"ball", std::make_shared<SmallSphere>(place), {0.5, 0.0}, {}});
  }
  return scene;
}

TEST(ManyStructures, OneOfAMillionGivesTheSameForcesAsAlone)
{
  std::vector<Vector3> places;
  places.reserve(Side * Side * Side);
  for (int n = 0; n < Side * Side * Side; ++n)
  {
    places.push_back(PlaceOf(n % Side, n / Side % Side, n / Side / Side));
  }
  const Vector3 touched = PlaceOf(41, 7, 83);
  const int number = 41 + 7 * Side + 83 * Side * Side;
  ServoSettings settings;
  settings.RampDuration = 0.0;
  settings.RecordedTicks = 0;
  test::ServoRun alone(SceneOf({touched}), settings);
  test::ServoRun among(SceneOf(places), settings);
  for (int tick = 0; tick < 60; ++tick)
  {
    // In and out again, past its centre, in the gaps between the others.
    const Vector3 place = touched + Vector3(-1.8 + 0.06 * tick, 0.3, 0.0);
    ASSERT_EQ(among.TickAt(place), alone.TickAt(place)) << tick;
    const TouchState& felt = among.Loop.Latest();
    ASSERT_EQ(felt.Structure, alone.Loop.Latest().Structure < 0 ? -1 : number) << tick;
    ASSERT_EQ(felt.Depth, alone.Loop.Latest().Depth) << tick;
    ASSERT_EQ(felt.Safety.Fault, SafetyFault::None) << tick;
  }
}

// Memory of a structure, without models and their trackers.
TEST(ManyStructures, UntouchedStructureTakesLessThanTwoKilobytes)
{
  EXPECT_LE(sizeof(TouchStructure) + sizeof(StructureFollower), 2048U);
}
} // namespace
} // namespace palpate::many_structures_test
