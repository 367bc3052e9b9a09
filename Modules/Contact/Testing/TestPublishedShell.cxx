#include "FieldContactCases.h"
#include "WorstCase.h"

#include <limits>

namespace palpate::published_shell_test
{
namespace
{
using test::At;
using test::Random;
using test::TrackerOf;

constexpr double VoxelSize = 0.5;   // mm
constexpr double ToolRadius = 1.25; // mm

// The published method, literally, with one point at a time.
class PublishedLaw
{
public:
  PublishedLaw(std::shared_ptr<const ScalarField> field, const ToolShape& tool)
      : Sampler(field), Caster(field), Tool(tool)
  {
  }

  // The proxy, which keeps to the method.
  Vector3 Next(const Vector3& probe)
  {
    const int touching = this->Touching(probe);
    if (touching == 0)
    {
      this->Proxy = probe;
    }
    else if (touching > 13)
    {
      // The path back, in quarters of a voxel.
      const Vector3 path = this->Proxy - probe;
      const int steps = static_cast<int>(std::ceil(path.norm() / (0.25 * VoxelSize)));
      Vector3 place = this->Proxy;
      for (int step = steps - 1; step >= 1; --step)
      {
        const Vector3 earlier = probe + (1.0 * step / steps) * path;
        place = this->Touching(earlier) <= 13 ? earlier : place;
      }
      this->Proxy = place;
    }
    else
    {
      this->Proxy = this->PushedOut(probe);
    }
    return this->Proxy;
  }

private:
  int Touching(const Vector3& center) const
  {
    int touching = 0;
    for (const Vector3& point : this->Tool.Points())
    {
      touching += this->Sampler.IsInsideWorld(0, center + point) ? 1 : 0;
    }
    return touching;
  }

  Vector3 PushedOut(const Vector3& center) const
  {
    Vector3 sum = Vector3::Zero();
    double mean = 0.0;
    const int touching = this->Touching(center);
    for (std::size_t i = 0; i < this->Tool.Points().size(); ++i)
    {
      const Vector3 point = center + this->Tool.Points()[i];
      if (this->Sampler.IsInsideWorld(0, point))
      {
        const FieldHit hit =
            this->Caster.CastWorld({point, this->Tool.Normals()[i]}, 0.0, ToolRadius);
        const double length = hit.Kind == HitKind::Missed ? ToolRadius : hit.T;
        sum += length * this->Tool.Normals()[i];
        mean += length / touching;
      }
    }
    return center + mean * sum.normalized();
  }

  FieldSampler Sampler;
  RayCaster Caster;
  ToolShape Tool;
  Vector3 Proxy = Vector3::Zero();
};

TEST(PublishedShell, EqualsThePublishedMethod)
{
  Random random(5201);
  const FieldGrid grid = test::FineGrid(48);
  const auto field = test::SampledField(grid, test::GyroidField{20.0});
  const ToolShape tool = ToolShape::SpherePoints(ToolRadius, 26);
  const auto model = test::PublishedContact(field);
  int kinds[3] = {0, 0, 0};
  for (int path = 0; path < 40; ++path)
  {
    const auto tracker = TrackerOf(*model, tool);
    PublishedLaw law(field, tool);
    Vector3 probe = grid.PointWorld(Vector3(24, 24, 24) + 12.0 * test::RandomDirection(random));
    Vector3 velocity = 0.1 * test::RandomDirection(random);
    Vector3 before = probe;
    for (int tick = 0; tick < 200; ++tick)
    {
      velocity = (velocity + 0.01 * test::RandomDirection(random)).normalized() * 0.1;
      probe += velocity;
      const Contact& contact = tracker->Follow(At(probe));
      if (tick == 0 && contact.IsTouching)
      {
        break; // without a proxy the method is undefined
      }
      const Vector3 expected = law.Next(probe);
      if ((expected - probe).norm() > 60.0 * 0.25 * VoxelSize)
      {
        break; // farther back, the tracker's steps are longer
      }
      ASSERT_TRUE(contact.IsValid);
      ASSERT_LE((contact.ProxyWorld - expected).norm(), 1e-9); // rounding
      ++kinds[!contact.IsTouching ? 0 : contact.ProxyWorld == before ? 1 : 2];
      before = contact.ProxyWorld;
    }
  }
  EXPECT_GT(kinds[0], 100);
  EXPECT_GT(kinds[1], 100);
  EXPECT_GT(kinds[2], 100);
}

TEST(PublishedShell, MeanOfManyPointsIsLessThanTheDepth)
{
  // A known limitation left open by its authors; FieldProxyTracker solves it.
  const FieldGrid grid = test::FineGrid(48);
  const auto field = test::SampledField(grid, test::PlaneField{-Vector3::UnitZ(), -24.0});
  const auto published = test::PublishedContact(field);
  const auto solved = test::FieldContact(field);
  const Vector3 top = grid.PointWorld({24.0, 24.0, 24.0});
  const Vector3 above = top + Vector3(0.0, 0.0, 1.0 + 1e-3);
  const ToolShape tool = ToolShape::SpherePoints(1.0, 26);
  const auto first = TrackerOf(*published, tool);
  const auto second = TrackerOf(*solved, tool);
  first->Follow(At(above));
  second->Follow(At(above));
  const Vector3 probe = top + Vector3(0.0, 0.0, 0.5); // 0.5 mm deep
  // Of the 9 points inside, those at the side have shorter exits along their normals or none.
  EXPECT_LT(first->Follow(At(probe)).Depth, 0.45);
  EXPECT_NEAR(second->Follow(At(probe)).Depth, 0.5, 1e-3 * VoxelSize); // where solving ends
}

TEST(PublishedShell, InvalidAndFarPosesHaveNoContact)
{
  const FieldGrid grid = test::FineGrid(48);
  const auto field = test::SampledField(grid, test::SphereField{Vector3::Constant(24.0), 15.0});
  const auto model = test::PublishedContact(field);
  const auto tracker = TrackerOf(*model, ToolShape::SpherePoints(1.0, 26));
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(tracker->Follow(At({0.0, notANumber, 0.0})).IsValid);
  for (const double far : {1e4, 1e50})
  {
    const Contact& contact = tracker->Follow(At({far, -far, 0.0}));
    EXPECT_TRUE(contact.IsValid);
    EXPECT_FALSE(contact.IsTouching);
  }
  tracker->Release();
  const Contact& deep = tracker->Follow(At(grid.PointWorld(Vector3::Constant(24.0))));
  EXPECT_TRUE(deep.IsValid);
  EXPECT_TRUE(deep.IsTouching);
  EXPECT_TRUE(deep.ProxyWorld.allFinite());
}

TEST(PublishedShell, RejectsPointsAndFriction)
{
  const FieldGrid grid = test::FineGrid(24);
  const auto field = test::SampledField(grid, test::SphereField{Vector3::Constant(12.0), 8.0});
  const auto model = test::PublishedContact(field);
  std::unique_ptr<ContactTracker> tracker;
  EXPECT_FALSE(model->MakeTracker(ToolShape::Sphere(0.0), {}, tracker).IsOk());
  EXPECT_FALSE(model->MakeTracker(ToolShape::Sphere(1.0), {0.3, 0.2}, tracker).IsOk());
  EXPECT_TRUE(model->MakeTracker(ToolShape::Sphere(1.0), {}, tracker).IsOk());
}
} // namespace
} // namespace palpate::published_shell_test
