// 100,000 short paths over an organ that yields, as over rigid bodies in TestTouchTruth.
#include "ContactCases.h"
#include "ElasticCases.h"
#include "ElasticContactModel.h"
#include "ElasticForce.h"
#include "TouchPaths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace palpate::elastic_paths_test
{
namespace
{
// Bumpy, with a lesion of five times the modulus beside the surface.
class ElasticPaths : public testing::TestWithParam<double>
{
protected:
  static constexpr int Paths = 34000; // with each of three balls

  void SetUp() override
  {
    std::mt19937_64 random(71);
    this->Organ.Model = test::RandomModel(random, 4, 0.015);
    const Vector3 lesion = test::RandomDirection(random);
    this->Organ.Solid.Tissue.AddInclusion(
        test::BallFraction(this->Organ.Model.PointWorld(lesion) - 9.0 * lesion, 6.0), 0.1);
    this->Organ.Build(8, 8);
    ComplianceMaps maps;
    Status status = ComplianceMaps::Fit(this->Organ.Model, this->Organ.Solid, this->Organ.Reduced,
                                        {16, 0.0}, {}, maps);
    ASSERT_TRUE(status.IsOk()) << status.Message();
    this->Atlas = std::make_unique<ComplianceAtlas>(maps);
    status = ElasticContactModel::Make(test::Shared(this->Organ.Model), maps, this->Contacts);
    ASSERT_TRUE(status.IsOk()) << status.Message();
  }

  test::ElasticCase Organ;
  std::unique_ptr<ComplianceAtlas> Atlas;
  std::shared_ptr<const ContactModel> Contacts;
};

TEST_P(ElasticPaths, ForceIsThatOfTheNearestPlaceAndDoesNotJump)
{
  const double ball = GetParam();
  const auto tracker = test::TrackerOf(*this->Contacts, ToolShape::Sphere(ball), {});
  const ClosestPointSearch search(test::Shared(this->Organ.Model));
  const double stiffness = this->Contacts->OwnStiffness(ToolShape::Sphere(ball)); // N/mm
  test::Random random(72);
  for (int path = 0; path < Paths; ++path)
  {
    tracker->Release();
    Vector3 last = Vector3::Zero(); // force, N
    Vector3 place = Vector3::Zero();
    test::FollowTouchPath(
        test::RadialWalk(this->Organ.Model, random), ball,
        [&](const Vector3& probe)
        {
          const Contact& contact = tracker->Follow(test::At(probe));
          ASSERT_TRUE(contact.IsValid && contact.Elastic != nullptr);
          const Vector3& force = contact.Elastic->ForceWorld;
          if (place != Vector3::Zero())
          {
            // Sideways the force turns with the surface, by less than that.
            ASSERT_LE((force - last).norm(), 1.5 * stiffness * (probe - place).norm()) << path;
          }
          last = force;
          place = probe;
        });
    const ClosestPoint foot = search.Nearest(place);
    const ElasticForce wanted = ElasticForce::Of(*this->Atlas, this->Organ.Model, foot.Direction,
                                                 ball - foot.SignedDistance, ball);
    ASSERT_GT(wanted.ForceWorld.dot(foot.Normal), 0.0);
    // Places are the same to 1e-9 mm, patches to the tolerance of their iteration.
    ASSERT_LE((last - wanted.ForceWorld).norm(), 1e-6 * wanted.ForceWorld.norm()) << path;
  }
}

INSTANTIATE_TEST_SUITE_P(Balls, ElasticPaths, testing::Values(2.0, 4.0, 8.0));
} // namespace
} // namespace palpate::elastic_paths_test
