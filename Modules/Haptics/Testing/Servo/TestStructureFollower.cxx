#include "StructureFollower.h"

#include "OrganContact.h"
#include "RadialModel.h"
#include "TouchDoubles.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::structure_follower_test
{
namespace
{
// A plate, thin in x, that is touched by any tool that crosses it, and keeps it on its side: a
// tracker with a memory, as real ones have.
class PlateModel final : public ContactModel
{
public:
  Eigen::AlignedBox3d BoundsWorld() const noexcept override
  {
    return {Vector3(-0.1, -10.0, -10.0), Vector3(0.1, 10.0, 10.0)};
  }
  Status MakeTracker(const ToolShape&, const SurfaceFriction&,
                     std::unique_ptr<ContactTracker>& tracker) const override
  {
    tracker = std::make_unique<Tracker>();
    return Status::Success();
  }

private:
  class Tracker final : public ContactTracker
  {
  public:
    const Contact& Follow(const ToolPose& pose) noexcept override
    {
      const double x = pose.PositionWorld[0];
      const bool hasCrossed = this->Side != 0.0 && x * this->Side < 0.0;
      this->Felt = {};
      this->Felt.IsValid = true;
      this->Felt.IsTouching = hasCrossed;
      this->Felt.ProxyWorld = pose.PositionWorld;
      this->Felt.ProxyWorld[0] = hasCrossed ? 0.0 : x;
      this->Felt.NormalWorld = (hasCrossed ? this->Side : 1.0) * Vector3::UnitX();
      this->Side = this->Side == 0.0 ? x : this->Side;
      return this->Felt;
    }
    void Release() noexcept override { this->Side = 0.0; }
    bool IsFreeAt(const ToolPose&) noexcept override { return true; } // it has no inside

  private:
    double Side = 0.0; // of the first pose
    Contact Felt;
  };
};

class StructureFollowerTest : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Scene.Tool = ToolShape::Sphere(0.0);
    this->Scene.Structures.push_back({"plate", std::make_shared<PlateModel>(), {1.0, 0.0}, {}});
    ASSERT_TRUE(
        StructureFollower::Make(this->Scene.Structures[0], this->Scene, 0.003, this->Followers)
            .IsOk());
  }
  Vector3 MoveTo(const Vector3& place)
  {
    FollowStep step;
    step.Last.PositionWorld = this->Place;
    step.Now.PositionWorld = place;
    step.Passed = 0.001;
    this->Place = place;
    return this->Followers[0].Follow(step);
  }

  TouchScene Scene;
  std::vector<StructureFollower> Followers;
  Vector3 Place = Vector3(-1.0, 0.0, 0.0);
};

TEST_F(StructureFollowerTest, PathThroughInOneTickIsTouched)
{
  EXPECT_EQ(this->MoveTo({1.0, 0.0, 0.0}), Vector3(-1.0, 0.0, 0.0));
  EXPECT_TRUE(this->Followers[0].Touched().IsTouching);
}

TEST_F(StructureFollowerTest, PathAroundIsNoPathThrough)
{
  // Near the plate's box on its left, around its edge while out of reach, and back on its right.
  this->MoveTo({-0.05, 0.0, 0.0});
  this->MoveTo({-1.0, 0.0, 0.0});
  this->MoveTo({-1.0, 20.0, 0.0});
  this->MoveTo({1.0, 20.0, 0.0});
  this->MoveTo({1.0, 0.0, 0.0});
  EXPECT_EQ(this->MoveTo({0.05, 0.0, 0.0}), Vector3::Zero());
  EXPECT_FALSE(this->Followers[0].Touched().IsTouching);
}

TEST_F(StructureFollowerTest, NonFinitePositionIsNotTouched)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(this->MoveTo({nan, nan, nan}), Vector3::Zero());
}

// A sphere of 10 mm that a scan's border cuts at z = 8 mm.
class CutSphereTest : public StructureFollowerTest
{
protected:
  void SetUp() override
  {
    this->Scene.Tool = ToolShape::Sphere(0.0);
    TouchStructure& sphere = this->Scene.Structures.emplace_back();
    sphere.Law = {1.0, 0.0};
    sphere.Cuts = {{Vector3::UnitZ(), 8.0, 0.5}};
    ASSERT_TRUE(
        MakeOrganContact(std::make_shared<const RadialModel>(
                             0, std::vector<double>{10.0 * std::sqrt(4.0 * M_PI)}, Vector3::Zero()),
                         RadialContactMode::Nearest, sphere.Model)
            .IsOk());
    ASSERT_TRUE(StructureFollower::Make(sphere, this->Scene, 0.003, this->Followers).IsOk());
  }
  // In steps of a tenth of a millimetre; returns the largest force.
  double Glide(const Vector3& end)
  {
    const Vector3 start = this->Place;
    const int steps = static_cast<int>(std::ceil((end - start).norm() / 0.1));
    double most = 0.0;
    for (int step = 1; step <= steps; ++step)
    {
      most = std::max(most, this->MoveTo(start + (end - start) * step / steps).norm());
    }
    return most;
  }
};

TEST_F(CutSphereTest, IsEnteredAndLeftWithoutForceWhereItIsCut)
{
  this->Place = {0.0, 0.0, 12.0};
  EXPECT_EQ(this->Glide({0.0, 0.0, 0.0}), 0.0);
  EXPECT_EQ(this->Glide({12.0, 0.0, 0.0}), 0.0) << "through the wall from inside";
  EXPECT_NEAR(this->Glide({9.0, 0.0, 0.0}), 1.0, 1e-9) << "from outside again";
}

TEST_F(CutSphereTest, LetsGoOfAToolThatSlidesOntoTheCut)
{
  this->Place = {12.0, 0.0, 0.0};
  EXPECT_GT(this->Glide({9.0, 0.0, 0.0}), 0.9);
  EXPECT_GT(this->Glide({6.0, 0.0, 6.0}), 0.9);
  this->Glide({1.0, 0.0, 9.0});
  EXPECT_EQ(this->MoveTo({1.0, 0.0, 9.0}), Vector3::Zero());
  EXPECT_EQ(this->Glide({4.0, 0.0, 0.0}), 0.0);
}
} // namespace
} // namespace palpate::structure_follower_test
