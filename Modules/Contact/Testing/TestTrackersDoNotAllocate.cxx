#include "AllocationCounter.h"
#include "ElasticCases.h"
#include "ElasticContactModel.h"
#include "FieldContactCases.h"
#include "MeshCases.h"
#include "NearestByBruteForce.h"
#include "OrganContact.h"
#include "SurfacePhantoms.h"

#include <utility>
#include <vector>

namespace palpate::trackers_do_not_allocate_test
{
namespace
{
using test::AllocationCount;

// Functions for the servo thread cannot throw either.
static_assert(noexcept(std::declval<ContactTracker&>().Follow(std::declval<const ToolPose&>())));
static_assert(noexcept(std::declval<ContactTracker&>().Release()));
static_assert(noexcept(std::declval<const ContactModel&>().BoundsWorld()));

// Poses in and out of a sphere of 15 mm, near and far, slow and fast, rotated, and invalid.
std::vector<ToolPose> Poses(const Vector3& middle)
{
  test::Random random(7101);
  std::vector<ToolPose> poses;
  Vector3 place(0.0, 0.0, 20.0);
  for (int tick = 0; tick < 3500; ++tick)
  {
    const double far = std::pow(10.0, static_cast<double>(random() % 4) - 2.0);
    place += far * test::RandomDirection(random);
    place *= place.norm() > 40.0 ? 0.5 : 1.0;
    ToolPose pose = test::At(middle + place);
    pose.Orientation = Eigen::AngleAxisd(0.01 * tick, Vector3::UnitX());
    pose.PositionWorld[0] *= tick % 100 == 0 ? std::nan("") : 1.0;
    poses.push_back(pose);
  }
  return poses;
}

int TouchesWithoutAllocation(const ContactModel& model, const ToolShape& tool,
                             const SurfaceFriction& friction)
{
  const auto tracker = test::TrackerOf(model, tool, friction);
  const std::vector<ToolPose> poses = Poses(model.BoundsWorld().center());
  int touches = 0;
  const std::size_t before = AllocationCount();
  for (const ToolPose& pose : poses)
  {
    touches += tracker->Follow(pose).IsTouching ? 1 : 0;
    if (touches % 50 == 49)
    {
      tracker->Release();
    }
  }
  EXPECT_EQ(AllocationCount(), before);
  return touches;
}

TEST(TrackersDoNotAllocate, OnStructuresThatYield)
{
  test::ElasticCase organ;
  organ.Model = test::SphereModel(15.0);
  ASSERT_NO_FATAL_FAILURE(organ.Build(4, 4));
  ComplianceMaps maps;
  ASSERT_TRUE(
      ComplianceMaps::Fit(organ.Model, organ.Solid, organ.Reduced, {4, 0.0}, {}, maps).IsOk());
  std::shared_ptr<const ContactModel> model;
  ASSERT_TRUE(ElasticContactModel::Make(test::Shared(organ.Model), maps, model).IsOk());
  EXPECT_GT(TouchesWithoutAllocation(*model, ToolShape::Sphere(3.0), {0.4, 0.3}), 100);
}

TEST(TrackersDoNotAllocate, OnSphericalHarmonics)
{
  test::Random random(7102);
  RadialModel organ = test::RandomOrgan(random, 12);
  for (const double radius : {0.0, 2.0})
  {
    const auto nearest = test::RadialContact(organ);
    EXPECT_GT(TouchesWithoutAllocation(*nearest, ToolShape::Sphere(radius), {0.3, 0.2}), 300);
    const auto radial = test::RadialContact(organ, RadialContactMode::Radial);
    EXPECT_GT(TouchesWithoutAllocation(*radial, ToolShape::Sphere(radius), {}), 300);
  }
}

TEST(TrackersDoNotAllocate, OfASphereTooLargeForSomeHollows)
{
  test::Random random(7103);
  const auto model = test::RadialContact(test::RandomRough(random, 12, 15.0));
  const ToolShape sphere = ToolShape::Sphere(4.0);
  EXPECT_GT(test::TrackerOf(*model, sphere)->Bytes(), 100000U); // with its proof
  EXPECT_GT(TouchesWithoutAllocation(*model, sphere, {0.3, 0.2}), 300);
}

TEST(TrackersDoNotAllocate, OnSurfaceModels)
{
  for (const SurfaceModel& surface : {test::OpenRing(8), test::CrossingRing(8)})
  {
    std::shared_ptr<const ContactModel> model;
    ASSERT_TRUE(MakeOrganContact(surface, model).IsOk());
    for (const double radius : {0.0, 2.0})
    {
      EXPECT_GT(TouchesWithoutAllocation(*model, ToolShape::Sphere(radius), {0.3, 0.2}), 100);
    }
  }
}

TEST(TrackersDoNotAllocate, OnFacets)
{
  const auto model = test::FacetContact(test::MeshOf(test::Sphere(15.0), 10));
  for (const double radius : {0.0, 2.0})
  {
    EXPECT_GT(TouchesWithoutAllocation(*model, ToolShape::Sphere(radius), {0.3, 0.2}), 300);
  }
}

TEST(TrackersDoNotAllocate, OnFields)
{
  const FieldGrid grid = test::FineGrid(64);
  for (const auto method : {FieldInterpolation::Trilinear, FieldInterpolation::TricubicBSpline})
  {
    const auto field =
        test::SampledField(grid, test::SphereField{Vector3::Constant(31.5), 30.0}, method);
    const auto solved = test::FieldContact(field);
    EXPECT_GT(TouchesWithoutAllocation(*solved, ToolShape::SpherePoints(1.0, 26), {0.3, 0.2}), 300);
    EXPECT_GT(TouchesWithoutAllocation(*solved, ToolShape::Capsule(0.5, 3.0, 40), {}), 300);
    const auto published = test::PublishedContact(field);
    EXPECT_GT(TouchesWithoutAllocation(*published, ToolShape::SpherePoints(1.0, 26), {}), 300);
  }
}
} // namespace
} // namespace palpate::trackers_do_not_allocate_test
