#include "ClosestPointSearch.h"
#include "FieldContactCases.h"
#include "MeshCases.h"
#include "SharedProxy.h"

#include <algorithm>
#include <vector>

namespace palpate::shared_proxy_test
{
namespace
{
constexpr double BallRadius = 15.0; // mm, of the structures
constexpr double ToolRadius = 2.0;  // mm
// mm. A tangent plane stands for the surface over a micrometre, in which it turns by 1e-4.
constexpr double PlaneError = 2e-4;

// A tool among some models, all of which are near.
class Tool
{
public:
  explicit Tool(const ToolShape& shape) : Shape(shape), Proxy(*shape.Skeleton()) {}

  void Among(const ContactModel& model, const SurfaceFriction& friction = {})
  {
    std::unique_ptr<ToolGaps> gaps;
    const Status status = model.MakeGaps(this->Shape, friction, gaps);
    ASSERT_TRUE(status.IsOk()) << status.Message();
    this->Near.push_back(static_cast<std::uint32_t>(this->Proxy.Add(std::move(gaps))));
  }
  void Begin(const ToolPose& pose)
  {
    this->Proxy.Begin(pose, this->Near.data(), this->Near.size());
  }
  void Follow(const ToolPose& hand)
  {
    this->Proxy.Follow(hand, this->Near.data(), this->Near.size());
  }
  // Until the proxy rests.
  const Contact& Settle(const ToolPose& hand, std::size_t structure = 0)
  {
    for (int tick = 0; tick < 400; ++tick)
    {
      this->Follow(hand);
      if (!this->Proxy.ShareOf(structure).IsBehind)
      {
        break;
      }
    }
    return this->Proxy.ShareOf(structure);
  }
  const ToolPose& Place() const { return this->Proxy.Pose(); }
  const Contact& ShareOf(std::size_t structure) const { return this->Proxy.ShareOf(structure); }
  bool Passes(std::size_t structure) const { return this->Proxy.Passes(structure); }

private:
  ToolShape Shape;
  SharedProxy Proxy;
  std::vector<std::uint32_t> Near;
};

// A ball of 15 mm in voxels of 0.5 mm; index coordinates.
struct BallField
{
  Vector3 Middle;

  double Value(const Vector3& p) const { return 2.0 * BallRadius - (p - this->Middle).norm(); }
};

std::shared_ptr<const ContactModel> BallByField(const Vector3& center)
{
  const FieldGrid grid = test::FineGrid(96);
  return test::FieldContact(test::SampledField(grid, BallField{grid.PointIndex(center)}));
}

struct Kind
{
  const char* Name;
  std::shared_ptr<const ContactModel> Model;
  Vector3 Center;
  double Error; // mm
};

// The ball as all kinds of structures. The mesh is inside of it by up to 0.01 mm; the gradient of
// an interpolated distance turns by as much within a voxel.
std::vector<Kind> Kinds()
{
  const RadialModel ball = test::Sphere(BallRadius, Vector3(3.0, -2.0, 5.0));
  const Vector3 inField = test::FineGrid(96).PointWorld(Vector3::Constant(47.3));
  return {{"radial", test::RadialContact(ball), ball.CenterWorld(), 1e-6},
          {"facets", test::FacetContact(test::MeshOf(ball, 40)), ball.CenterWorld(), 0.01},
          {"field", BallByField(inField), inField, 0.015}};
}

TEST(SharedProxy, CapsuleAcrossABallGivesTheClosedForm)
{
  const Eigen::Quaterniond lying(Eigen::AngleAxisd(0.5 * EIGEN_PI, Vector3::UnitY()));
  for (const Kind& kind : Kinds())
  {
    SCOPED_TRACE(kind.Name);
    Tool tool(ToolShape::Capsule(ToolRadius, 10.0, 400));
    tool.Among(*kind.Model);
    tool.Begin({kind.Center + Vector3(0.0, 0.0, BallRadius + 6.0), lying});
    const ToolPose hand{kind.Center + Vector3(0.0, 0.0, BallRadius + ToolRadius - 1.0), lying};
    const Contact& share = tool.Settle(hand);
    EXPECT_TRUE(share.IsTouching);
    EXPECT_LE((share.ProxyWorld - hand.PositionWorld - Vector3::UnitZ()).norm(), kind.Error);
    EXPECT_LE((share.NormalWorld - Vector3::UnitZ()).norm(), kind.Error);
    EXPECT_LE((share.FootWorld - kind.Center - BallRadius * Vector3::UnitZ()).norm(),
              kind.Error + 0.2)
        << "along the ball it may be anywhere within its own error";
    EXPECT_LE(share.Turn.norm(), 10.0 * kind.Error) << "it is symmetric";
  }
}

TEST(SharedProxy, OneBallIsASphere)
{
  test::Random random(12);
  const RadialModel organ = test::RandomOrgan(random, 8);
  const auto model = test::RadialContact(organ);
  const auto tracker = test::TrackerOf(*model, ToolShape::Sphere(ToolRadius));
  Tool tool(ToolShape::Capsule(ToolRadius, 0.0, 26));
  tool.Among(*model);
  test::WanderingDirection direction(random);
  const auto place = [&](double depth)
  {
    const Vector3 u = direction.Next(0.01);
    return test::At(organ.PointWorld(u) + (ToolRadius - depth) * u);
  };
  tool.Begin(place(-10.0));
  tracker->Follow(tool.Place());
  int touches = 0;
  for (int tick = 0; tick < 2000; ++tick)
  {
    const ToolPose hand = place(1.0);
    const Contact& share = tool.Settle(hand);
    const Contact& sphere = tracker->Follow(hand);
    touches += sphere.IsTouching ? 1 : 0;
    ASSERT_EQ(share.IsTouching, sphere.IsTouching) << tick;
    ASSERT_LE((share.ProxyWorld - sphere.ProxyWorld).norm(), PlaneError) << tick;
  }
  EXPECT_EQ(touches, 2000);
}

TEST(SharedProxy, TwoStructuresHoldAToolByTheirShares)
{
  constexpr double Aside = 16.0; // mm, of each ball's centre
  const auto left = test::RadialContact(test::Sphere(BallRadius, Vector3(-Aside, 0.0, 0.0)));
  const auto right = test::RadialContact(test::Sphere(BallRadius, Vector3(Aside, 0.0, 0.0)));
  Tool tool(ToolShape::Capsule(ToolRadius, 0.0, 26));
  tool.Among(*left);
  tool.Among(*right);
  tool.Begin(test::At({0.0, 0.0, 20.0}));
  const Vector3 hand(0.0, 0.0, 3.0);
  tool.Settle(test::At(hand));
  const double reach = BallRadius + ToolRadius;
  const double height = std::sqrt(reach * reach - Aside * Aside);
  EXPECT_LE((tool.Place().PositionWorld - Vector3(0.0, 0.0, height)).norm(), 1e-5);
  // Each holds half of the height, and pushes aside against the other.
  const Vector3 half = 0.5 * (height - hand.z()) * Vector3(Aside / height, 0.0, 1.0);
  EXPECT_LE((tool.ShareOf(0).ProxyWorld - hand - half).norm(), PlaneError);
  EXPECT_LE((tool.ShareOf(1).ProxyWorld - hand - Vector3(-half.x(), 0.0, half.z())).norm(),
            PlaneError);
}

TEST(SharedProxy, StructureAroundTheToolIsPassedUntilItHasLeft)
{
  for (const Kind& kind : Kinds())
  {
    SCOPED_TRACE(kind.Name);
    Tool tool(ToolShape::Capsule(ToolRadius, 6.0, 200));
    tool.Among(*kind.Model);
    tool.Begin(test::At(kind.Center));
    EXPECT_TRUE(tool.Passes(0));
    EXPECT_FALSE(tool.Settle(test::At(kind.Center + Vector3(0.0, 3.0, 0.0))).IsTouching);
    EXPECT_FALSE(tool.Settle(test::At(kind.Center + Vector3(0.0, 30.0, 0.0))).IsTouching);
    tool.Follow(test::At(kind.Center + Vector3(0.0, 30.0, 0.0)));
    EXPECT_FALSE(tool.Passes(0));
    EXPECT_TRUE(tool.Settle(test::At(kind.Center)).IsTouching) << "it is outside now";
  }
}

TEST(SharedProxy, EntersNoOrganHoweverTheHandMoves)
{
  test::Random random(99);
  std::uniform_real_distribution<double> any(-30.0, 30.0);
  const RadialModel organ = test::RandomOrgan(random, 10);
  const ClosestPointSearch search(test::Shared(organ));
  const ToolShape shape = ToolShape::Capsule(ToolRadius, 12.0, 200);
  Tool tool(shape);
  tool.Among(*test::RadialContact(organ));
  tool.Begin(test::At(organ.CenterWorld() + Vector3(0.0, 0.0, 60.0)));
  double deepest = 0.0;
  for (int jump = 0; jump < 300; ++jump)
  {
    const ToolPose hand{
        organ.CenterWorld() + Vector3(any(random), any(random), any(random)),
        Eigen::Quaterniond(Eigen::AngleAxisd(any(random), test::RandomDirection(random)))};
    for (int held = 0; held < 5; ++held)
    {
      tool.Follow(hand);
      for (const ToolSkeleton::Ball& ball : shape.Skeleton()->Balls())
      {
        const Vector3 center = tool.Place().PositionWorld + tool.Place().Orientation * ball.Center;
        deepest = std::max(deepest, ball.Radius - search.Nearest(center).SignedDistance);
      }
    }
  }
  EXPECT_LT(deepest, 0.1) << "mm: a wall may be unknown for Skin, and curves within a stride";
}
} // namespace
} // namespace palpate::shared_proxy_test
