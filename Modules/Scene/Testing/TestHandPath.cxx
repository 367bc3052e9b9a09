#include "HandPath.h"

#include "InputError.h"
#include "OrganContact.h"
#include "RadialModel.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::hand_path_test
{
namespace
{
TEST(HandPath, IsLinearBetweenPlacesAndConstantBeyond)
{
  const HandPath path({{1.0, Vector3(0.0, 0.0, 0.0)},
                       {2.0, Vector3(4.0, 0.0, 0.0)},
                       {4.0, Vector3(4.0, 2.0, 0.0)}});
  EXPECT_EQ(path.Duration(), 4.0);
  EXPECT_EQ(path.At(0.0), Vector3(0.0, 0.0, 0.0));
  EXPECT_EQ(path.At(1.25), Vector3(1.0, 0.0, 0.0));
  EXPECT_EQ(path.At(2.0), Vector3(4.0, 0.0, 0.0));
  EXPECT_EQ(path.At(3.0), Vector3(4.0, 1.0, 0.0));
  EXPECT_EQ(path.At(9.0), Vector3(4.0, 2.0, 0.0));
}

TEST(HandPath, ReadsFile)
{
  const test::TemporaryFolder folder;
  WriteWholeFile(folder / "hand.csv", "time_s,x_mm,y_mm,z_mm\r\n0,1,2,3\r\n\r\n0.5,-1,2e1,.5\r\n");
  const HandPath path = ReadHandPath(folder / "hand.csv");
  ASSERT_EQ(path.List().size(), 2U);
  EXPECT_EQ(path.List()[1].Time, 0.5);
  EXPECT_EQ(path.List()[1].PointWorld, Vector3(-1.0, 20.0, 0.5));
}

TEST(HandPath, RejectsMalformedFile)
{
  const test::TemporaryFolder folder;
  for (const char* const lines :
       {"", "0,1,2", "0,1,2,3,4", "0,1,2,nan", "0,1,2,x", "1,1,2,3\n1,1,2,3", "2,1,2,3\n1,1,2,3"})
  {
    WriteWholeFile(folder / "hand.csv", std::string("time_s,x_mm,y_mm,z_mm\n") + lines);
    EXPECT_THROW(ReadHandPath(folder / "hand.csv"), InputError) << lines;
  }
}

constexpr double Radius = 20.0;
constexpr double ToolRadius = 2.0;
constexpr double Depth = 1.5;
constexpr double Speed = 40.0;

// Over a sphere, for at least `longest` seconds if it is that long.
HandPath Sweep(const Vector3& center, double longest, std::vector<ScanCut> cuts = {})
{
  TouchScene scene;
  TouchStructure sphere;
  EXPECT_TRUE(MakeOrganContact(std::make_shared<const RadialModel>(
                                   0, std::vector<double>{Radius * std::sqrt(4.0 * M_PI)}, center),
                               RadialContactMode::Nearest, sphere.Model)
                  .IsOk());
  sphere.Cuts = std::move(cuts);
  scene.Structures = {sphere};
  scene.Tool = ToolShape::Sphere(ToolRadius);
  HandPath path;
  EXPECT_TRUE(SweepOf(scene, Depth, Speed, longest, path).IsOk());
  return path;
}

// A place takes 30 ms and more with a tool of 100 mm.
TEST(HandPath, SweepFindsNoMorePlacesThanItsTimeTakes)
{
  const HandPath whole = Sweep(Vector3::Zero(), std::numeric_limits<double>::infinity());
  const HandPath part = Sweep(Vector3::Zero(), 1.0);
  EXPECT_GE(part.Duration(), 1.0);
  ASSERT_LT(part.List().size(), whole.List().size() / 4);
  for (std::size_t p = 0; p + 1 < part.List().size(); ++p) // the last leads off the structure
  {
    EXPECT_EQ(part.List()[p].Time, whole.List()[p].Time);
    EXPECT_EQ(part.List()[p].PointWorld, whole.List()[p].PointWorld);
  }
  EXPECT_GE(part.List()[part.List().size() - 2].Time, 1.0);
}

TEST(HandPath, SweepGoesAroundWhereTheScanCuts)
{
  const HandPath path = Sweep(Vector3::Zero(), std::numeric_limits<double>::infinity(),
                              {{Vector3::UnitZ(), 10.0, 1.0}});
  const double outside = path.List().front().PointWorld.norm();
  int touching = 0;
  for (std::size_t p = 1; p + 1 < path.List().size(); ++p)
  {
    const Vector3& place = path.List()[p].PointWorld;
    const bool isIn = place.norm() < Radius + ToolRadius;
    touching += isIn ? 1 : 0;
    EXPECT_TRUE(isIn ? place.z() < 9.0 : place.norm() > outside - 1e-9) << place.transpose();
    // It gets in and out along a ray from the centre.
    const Vector3& before = path.List()[p - 1].PointWorld;
    if (isIn != (before.norm() < Radius + ToolRadius))
    {
      EXPECT_NEAR(before.normalized().dot(place.normalized()), 1.0, 1e-9);
    }
  }
  EXPECT_GT(touching, 200) << "of 400 places";
}

TEST(HandPath, SweepFollowsASphereAtItsDepth)
{
  const Vector3 center(10.0, -30.0, 5.0);
  const HandPath path = Sweep(center, std::numeric_limits<double>::infinity());
  const auto& places = path.List();
  ASSERT_GT(places.size(), 100U);
  for (std::size_t p = 1; p + 1 < places.size(); ++p)
  {
    // Bisection finds the contact to 2^-12 of the marching step.
    EXPECT_NEAR((places[p].PointWorld - center).norm(), Radius + ToolRadius - Depth, 1e-3);
    const double length = (places[p].PointWorld - places[p - 1].PointWorld).norm();
    EXPECT_NEAR(length / (places[p].Time - places[p - 1].Time), Speed, 1e-6 * Speed);
  }
  EXPECT_GT((places.front().PointWorld - center).norm(), Radius + ToolRadius);
  EXPECT_GT((places.back().PointWorld - center).norm(), Radius + ToolRadius);
}
} // namespace
} // namespace palpate::hand_path_test
