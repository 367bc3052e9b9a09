#include "BodyRelation.h"

#include "ComparedCases.h"
#include "MeshShapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <utility>

namespace palpate::body_relation_test
{
namespace
{
RelatedBody Prepared(ComparedBody body)
{
  RelatedBody related;
  const Status status = RelatedBody::Make(std::move(body), SpreadOf::Inside, related);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return related;
}

RelatedBody Ball(double radius, const Vector3& center = Vector3::Zero())
{
  return Prepared(test::BodyOfModel(test::SphereModel(radius, center)));
}

BodyRelation Related(const RelatedBody& one, const RelatedBody& other,
                     const RelationSettings& settings = {})
{
  BodyRelation relation;
  const Status status = RelateBodies(one, other, settings, {}, relation);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return relation;
}

// Area of a ball of radius r around the first centre within `reach` of the other centre.
double CapArea(double r, double apart, double reach)
{
  const double cosine = (r * r + apart * apart - reach * reach) / (2.0 * r * apart);
  return 2.0 * M_PI * r * r * (1.0 - cosine);
}

// Volume that two balls share.
double Lens(double r, double s, double apart)
{
  const double sum = r + s - apart;
  return M_PI * sum * sum * (apart * apart + 2.0 * apart * (r + s) - 3.0 * (r - s) * (r - s)) /
         (12.0 * apart);
}

TEST(BodyRelation, OfTwoBallsIsThatOfFormulas)
{
  const double apart = 20.5;
  const Vector3 way = Vector3(1.0, 2.0, -0.5).normalized();
  const BodyRelation found = Related(Ball(10.0), Ball(10.0, apart * way));
  EXPECT_EQ(found.Is, BodyRelation::Kind::Apart);
  EXPECT_NEAR(found.Distance(), 0.5, 0.01);
  EXPECT_LT((found.Wall.PointOfOne - 10.0 * way).norm(), 0.2);
  EXPECT_LT((found.Offset - apart * way).norm(), 1e-3);
  EXPECT_NEAR(found.One.ContactArea / CapArea(10.0, apart, 11.0), 1.0, 0.02);
  EXPECT_NEAR(found.Other.ContactArea / CapArea(10.0, apart, 11.0), 1.0, 0.02);
  ASSERT_EQ(found.One.Near.size(), 3U);
  for (const NearShare& share : found.One.Near)
  {
    const double reach = 10.0 + share.Millimeters;
    EXPECT_NEAR(share.Area, CapArea(10.0, apart, reach) / (400.0 * M_PI), 2e-3);
    EXPECT_NEAR(share.Volume, Lens(10.0, reach, apart) / (4000.0 / 3.0 * M_PI), 5e-3);
  }
  EXPECT_EQ(found.SharedVolume, 0.0);
}

TEST(BodyRelation, OfCrossingBallsSharesTheirLens)
{
  const BodyRelation found = Related(Ball(10.0), Ball(8.0, Vector3(12.0, 0.0, 0.0)));
  EXPECT_EQ(found.Is, BodyRelation::Kind::Overlapping);
  EXPECT_EQ(found.Distance(), 0.0);
  // By triangles of a sixteenth of the radius.
  EXPECT_NEAR(found.SharedVolume / Lens(10.0, 8.0, 12.0), 1.0, 5e-3);
}

TEST(BodyRelation, OfABodyInAnotherNamesTheWall)
{
  const RelatedBody organ = Ball(20.0);
  const RelatedBody lesion = Ball(4.0, Vector3(0.0, 13.0, 0.0));
  const BodyRelation found = Related(lesion, organ);
  EXPECT_EQ(found.Is, BodyRelation::Kind::Inside);
  EXPECT_EQ(found.Distance(), 0.0);
  EXPECT_NEAR(found.Wall.Distance, 3.0, 0.02);
  EXPECT_NEAR(found.SharedVolume / (256.0 / 3.0 * M_PI), 1.0, 1e-3);
  EXPECT_EQ(found.One.Near.front().Volume, 1.0);
  EXPECT_EQ(found.One.ContactArea, 0.0) << "the wall is thicker than what counts as contact";
  const BodyRelation back = Related(organ, lesion);
  EXPECT_EQ(back.Is, BodyRelation::Kind::Around);
  EXPECT_NEAR(back.Other.ContactArea, found.One.ContactArea, 1e-9);
}

TEST(BodyRelation, OfMasksCountsTheirVoxels)
{
  IndexToWorld toWorld;
  toWorld.Axes = 0.5 * Matrix3::Identity();
  const auto half = [&](bool isLeft)
  {
    return Prepared(test::BodyOfVoxels({40, 40, 40}, toWorld,
                                       [isLeft](const Vector3& world)
                                       {
                                         const Vector3 off = world - Vector3::Constant(10.0);
                                         return off.norm() < 8.0 && (off.x() < 0.1) == isLeft;
                                       }));
  };
  const BodyRelation found = Related(half(true), half(false));
  EXPECT_EQ(found.Is, BodyRelation::Kind::Overlapping) << "their surfaces touch";
  EXPECT_EQ(found.SharedVolume, 0.0) << "labels of one image";
  EXPECT_EQ(found.Distance(), 0.0);
  EXPECT_GT(found.One.ContactArea, 60.0 * M_PI);
}

// Against the distances of all points of each surface from the other one, which are as near for
// meshes as fine as these.
TEST(BodyRelation, LeastDistanceIsThatOfBruteForce)
{
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> off(-1.5, 1.5);
  const IndexedMesh shape = test::Lobed(40);
  const RelatedBody one = Prepared(test::BodyOfMesh(shape));
  for (int trial = 0; trial < 6; ++trial)
  {
    IndexedMesh moved = shape;
    const Vector3 by(off(random), off(random), 4.0 + off(random));
    for (Vector3& point : moved.Points)
    {
      point += by;
    }
    const RelatedBody other = Prepared(test::BodyOfMesh(moved));
    const BodyRelation found = Related(one, other);
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [from, to] : {std::pair(&one, &other), std::pair(&other, &one)})
    {
      for (const double distance : from->Body().DistancesOfTriangles(to->Body().Surface().Points))
      {
        least = std::min(least, distance);
      }
    }
    EXPECT_LE(found.Wall.Distance, least + 1e-12);
    EXPECT_GT(found.Wall.Distance, least - 1e-3);
    EXPECT_NEAR((found.Wall.PointOfOne - found.Wall.PointOfOther).norm(), found.Wall.Distance,
                1e-12);
  }
}

TEST(BodyRelation, OfFarBodiesHasOnlyItsDistance)
{
  const BodyRelation found = Related(Ball(5.0), Ball(5.0, Vector3(0.0, 0.0, 100.0)));
  EXPECT_NEAR(found.Distance(), 90.0, 0.01);
  EXPECT_TRUE(found.One.Distances.empty());
  EXPECT_EQ(found.One.ContactArea, 0.0);
  EXPECT_EQ(found.One.Near.back().Area, 0.0);
}

TEST(BodyRelation, AngleIsThatOfTheLongestAxes)
{
  const RelatedBody along =
      Prepared(test::BodyOfModel(test::EllipsoidModel(Vector3(9.0, 4.0, 4.5))));
  const RelatedBody across =
      Prepared(test::BodyOfModel(test::EllipsoidModel(Vector3(4.0, 9.0, 4.5))));
  EXPECT_NEAR(Related(along, across).AxesAngle, 90.0, 1e-3);
  EXPECT_NEAR(Related(along, along).AxesAngle, 0.0, 1e-3);
}

TEST(RelatedBody, RefusesAnOpenSurface)
{
  IndexedMesh open = test::Sphere(10, 5.0);
  open.Triangles.resize(open.Triangles.size() / 2);
  RelatedBody related;
  const Status status = RelatedBody::Make(test::BodyOfMesh(open), SpreadOf::Inside, related);
  EXPECT_FALSE(status.IsOk());
  EXPECT_EQ(status.Message(), "is open, so that it has no inside");
}
} // namespace
} // namespace palpate::body_relation_test
