#include "BodyComparison.h"

#include "ComparedCases.h"
#include "MeshShapes.h"
#include "SignedMeshDistances.h"

#include <cmath>
#include <random>

namespace palpate::body_comparison_test
{
namespace
{
using test::BodyOfMesh;
using test::BodyOfModel;
using test::EllipsoidModel;
using test::SphereModel;

BodyComparison Compared(const ComparedBody& one, const ComparedBody& other)
{
  BodyComparison comparison;
  const Status status = CompareBodies(one, other, {1.0, 2.0, 3.0}, {}, comparison);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return comparison;
}

// Of two balls: that of their lens (Weisstein, "Sphere-Sphere Intersection", MathWorld).
double LensVolume(double r, double s, double d)
{
  return M_PI * std::pow(r + s - d, 2) * (d * d + 2.0 * d * (r + s) - 3.0 * (r - s) * (r - s)) /
         (12.0 * d);
}

// The distance of a point outside or inside an ellipsoid from its surface, by bisection of the
// multiplier of the closest point (Eberly, "Distance from a Point to an Ellipse, an Ellipsoid, or a
// Hyperellipsoid", 2013); no coordinate may be 0.
double DistanceFromEllipsoid(const Vector3& axes, const Vector3& point)
{
  const Vector3 squares = axes.cwiseAbs2();
  const Vector3 p = point.cwiseAbs();
  const auto level = [&](double t)
  {
    return (axes.cwiseProduct(p)).cwiseQuotient((squares.array() + t).matrix()).squaredNorm() - 1.0;
  };
  double low = -squares.minCoeff();
  double high = axes.maxCoeff() * p.norm();
  for (int i = 0; i < 200; ++i)
  {
    const double middle = 0.5 * (low + high);
    (level(middle) > 0.0 ? low : high) = middle;
  }
  const Vector3 foot = squares.cwiseProduct(p).cwiseQuotient((squares.array() + high).matrix());
  const double distance = (p - foot).norm();
  return p.cwiseQuotient(axes).squaredNorm() < 1.0 ? -distance : distance;
}

// The centres of parts^2 equal parts of each triangle: an implementation of its own.
DistanceSummary ByDenseSampling(const ComparedBody& one, const ComparedBody& other)
{
  constexpr int Parts = 12;
  DistanceSamples dense;
  for (const std::array<int, 3>& t : one.Surface().Triangles)
  {
    const Vector3& a = one.Surface().Points[t[0]];
    const Vector3 u = (one.Surface().Points[t[1]] - a) / Parts;
    const Vector3 v = (one.Surface().Points[t[2]] - a) / Parts;
    for (int i = 0; i < Parts; ++i)
    {
      for (int j = 0; i + j < Parts; ++j)
      {
        dense.Points.emplace_back(a + (i + 1.0 / 3.0) * u + (j + 1.0 / 3.0) * v);
        if (i + j + 1 < Parts)
        {
          dense.Points.emplace_back(a + (i + 2.0 / 3.0) * u + (j + 2.0 / 3.0) * v);
        }
      }
    }
    dense.Weights.resize(dense.Points.size(), 0.5 * u.cross(v).norm() / one.Area());
  }
  EXPECT_TRUE(other.DistancesOf(dense.Points, {}, dense.Values).IsOk());
  for (const double value : dense.Values)
  {
    dense.Largest = std::max(dense.Largest, std::abs(value));
  }
  return Summarise(dense);
}

// An ellipsoid in voxels like those of prostates, its centre off their lattice.
ComparedBody EllipsoidOfVoxels(const Vector3& axes, const Vector3& origin)
{
  IndexToWorld grid;
  grid.Origin = origin;
  grid.Axes = Vector3(0.7, 0.7, 3.0).asDiagonal();
  const auto isInside = [&](const Vector3& point)
  { return point.cwiseQuotient(axes).squaredNorm() < 1.0; };
  return test::BodyOfVoxels({46, 34, 8}, grid, isInside);
}

TEST(BodyComparison, DistancesOfStepsEqualDenseSampling)
{
  const Vector3 axes(14.0, 10.0, 8.0);
  const ComparedBody mask = EllipsoidOfVoxels(axes, {-15.9, -11.7, -10.2});
  const ComparedBody shifted = EllipsoidOfVoxels(axes, {-15.6, -11.2, -11.1});
  const ComparedBody model = BodyOfModel(EllipsoidModel(axes));
  struct Case
  {
    const ComparedBody& One;
    const ComparedBody& Other;
    double Percentile95; // parallel steps have few different distances
  };
  for (const auto& [one, other, tolerance] :
       {Case{mask, model, 0.01}, Case{model, mask, 0.01}, Case{mask, shifted, 0.03}})
  {
    const DistanceSummary found = Compared(one, other).OneToOther.Unsigned;
    const DistanceSummary expected = ByDenseSampling(one, other);
    EXPECT_NEAR(found.Mean, expected.Mean, 0.01 * expected.Mean);
    EXPECT_NEAR(found.Rms, expected.Rms, 0.01 * expected.Rms);
    EXPECT_NEAR(found.Percentile95, expected.Percentile95, tolerance * expected.Percentile95);
    EXPECT_GE(found.Largest, 0.999 * expected.Largest);
  }
}

TEST(BodyComparison, SignsOfSamplesAreThoseOfTheirPlaces)
{
  const Vector3 axes(14.0, 10.0, 8.0);
  const ComparedBody model = BodyOfModel(EllipsoidModel({13.0, 11.0, 8.0}));
  const ComparedBody mask = EllipsoidOfVoxels(axes, {-15.9, -11.7, -10.2});
  const DistanceSamples samples = Compared(model, mask).OneToOther.Samples;
  const std::vector<std::uint8_t> inside = InsideOf(samples.Points, mask.Surface());
  for (std::size_t i = 0; i < samples.Points.size(); ++i)
  {
    ASSERT_EQ(samples.Values[i] < 0.0, inside[i] != 0) << samples.Values[i];
  }
}

TEST(BodyComparison, LeastDistanceIsThatOfBodies)
{
  const ComparedBody one = BodyOfModel(SphereModel(10.0));
  EXPECT_NEAR(Compared(one, BodyOfModel(SphereModel(5.0, {20.0, 0.0, 20.0}))).LeastDistance,
              std::sqrt(800.0) - 15.0, 0.01); // drawings lie inside by up to 0.005 mm
  EXPECT_EQ(Compared(one, BodyOfModel(SphereModel(5.0, {14.0, 0.0, 0.0}))).LeastDistance, 0.0);
  EXPECT_EQ(Compared(one, BodyOfModel(SphereModel(5.0))).LeastDistance, 0.0); // one in the other
}

TEST(BodyComparison, ConcentricSpheresAreTheirRadiiApartEverywhere)
{
  const BodyComparison found =
      Compared(BodyOfModel(SphereModel(22.0)), BodyOfModel(SphereModel(20.0)));
  for (const DistanceSummary& summary :
       {found.OneToOther.Unsigned, found.OtherToOne.Unsigned, found.Both})
  {
    EXPECT_NEAR(summary.Mean, 2.0, 1e-12);
    EXPECT_NEAR(summary.Rms, 2.0, 1e-12);
    EXPECT_NEAR(summary.Percentile95, 2.0, 1e-12);
    EXPECT_NEAR(summary.Largest, 2.0, 1e-12);
  }
  EXPECT_NEAR(found.OneToOther.SignedMean, 2.0, 1e-12);
  EXPECT_NEAR(found.OtherToOne.SignedMean, -2.0, 1e-12);
}

TEST(BodyComparison, ShiftedSpheresHaveTheirExactValues)
{
  constexpr double Radius = 20.0;
  constexpr double Shift = 3.0;
  const BodyComparison found = Compared(BodyOfModel(SphereModel(Radius, {Shift, 0.0, 0.0})),
                                        BodyOfModel(SphereModel(Radius)));
  // The mean of |r u + d e| over the sphere is r + d^2 / (3 r).
  EXPECT_NEAR(found.OneToOther.SignedMean, Shift * Shift / (3.0 * Radius), 1e-4);
  EXPECT_NEAR(found.Both.Largest, Shift, 1e-3); // at a point of the drawing near the pole
  const double lens = LensVolume(Radius, Radius, Shift);
  const double ball = 4.0 / 3.0 * M_PI * std::pow(Radius, 3);
  ASSERT_TRUE(found.Overlap);
  EXPECT_NEAR(found.Overlap->Dice(), lens / ball, 1e-5);
  EXPECT_NEAR(found.Overlap->Jaccard(), lens / (2.0 * ball - lens), 1e-5);
  // |p - c|^2 = r^2 + d^2 + 2 r d cos, and cos is uniform over the sphere.
  for (const BodyComparison::Tolerance& tolerance : found.Tolerances)
  {
    const auto cosine = [&](double distance)
    {
      return std::clamp((std::pow(Radius + distance, 2) - Radius * Radius - Shift * Shift) /
                            (2.0 * Radius * Shift),
                        -1.0, 1.0);
    };
    const double share = 0.5 * (cosine(tolerance.Millimeters) - cosine(-tolerance.Millimeters));
    EXPECT_NEAR(tolerance.SurfaceDice, share, 1e-3) << tolerance.Millimeters << " mm";
  }
}

TEST(BodyComparison, DistancesFromEllipsoidAreExact)
{
  const Vector3 axes(25.0, 18.0, 12.0);
  const ComparedBody body = BodyOfModel(EllipsoidModel(axes));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-35.0, 35.0);
  std::vector<Vector3> points;
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 point(coordinate(random), coordinate(random), coordinate(random));
    // Near the middle plane's ellipse, points are equally far from two sides.
    if (point.cwiseQuotient(axes).norm() > 0.7)
    {
      points.push_back(point);
    }
  }
  std::vector<double> distances;
  ASSERT_TRUE(body.DistancesOf(points, {}, distances).IsOk());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ASSERT_NEAR(distances[i], DistanceFromEllipsoid(axes, points[i]), 1e-9)
        << points[i].transpose();
  }
}

TEST(BodyComparison, RadialAndSurfaceModelsOfOneBodyAreEqual)
{
  const RadialModel star(2, {70.0, 3.0, -2.0, 1.0, 2.0, -1.5, 4.0, 0.5, 1.0}, {5.0, -3.0, 40.0});
  const BodyComparison found =
      Compared(BodyOfModel(star), BodyOfModel(SurfaceModel::FromModel(star)));
  EXPECT_LT(found.Both.Largest, 1e-9);
  EXPECT_NEAR(found.Overlap->Dice(), 1.0, 1e-12);
  EXPECT_EQ(found.Tolerances.front().SurfaceDice, 1.0);
}

TEST(BodyComparison, BoxInBoxHasItsExactValues)
{
  // Of 12 triangles each: long edges are split.
  const ComparedBody small = BodyOfMesh(test::Box(Vector3::Constant(-5.0), Vector3::Constant(5.0)));
  const ComparedBody large = BodyOfMesh(test::Box(Vector3::Constant(-7.0), Vector3::Constant(7.0)));
  const BodyComparison found = Compared(small, large);
  EXPECT_NEAR(found.OneToOther.Unsigned.Mean, 2.0, 1e-9);
  EXPECT_NEAR(found.OneToOther.SignedMean, -2.0, 1e-9);
  EXPECT_NEAR(found.OtherToOne.Unsigned.Largest, std::sqrt(12.0), 1e-9);
  // Over a face of the large box, by the midpoint rule.
  constexpr int Steps = 1400;
  double mean = 0.0;
  double within = 0.0; // 3 mm
  for (int i = 0; i < Steps; ++i)
  {
    for (int j = 0; j < Steps; ++j)
    {
      const double y = std::max(0.0, std::abs(-7.0 + 14.0 * (i + 0.5) / Steps) - 5.0);
      const double z = std::max(0.0, std::abs(-7.0 + 14.0 * (j + 0.5) / Steps) - 5.0);
      mean += std::sqrt(4.0 + y * y + z * z) / (Steps * Steps);
      within += 4.0 + y * y + z * z <= 9.0 ? 1.0 / (Steps * Steps) : 0.0;
    }
  }
  EXPECT_NEAR(found.OtherToOne.Unsigned.Mean, mean, 1e-3);
  EXPECT_EQ(found.Hausdorff95(), found.OtherToOne.Unsigned.Percentile95);
  EXPECT_GT(found.Hausdorff95(), found.OneToOther.Unsigned.Percentile95);
  EXPECT_NEAR(small.Volume(), 1000.0, 1e-9);
  EXPECT_NEAR(found.Overlap->Dice(), 2.0 * 1000.0 / (1000.0 + 2744.0), 2e-4);
  // Nothing of the small one, and of the large one no point is nearer than 2 mm.
  EXPECT_EQ(found.Tolerances[0].SurfaceDice, 0.0);
  EXPECT_NEAR(found.Tolerances[2].SurfaceDice, (600.0 + 1176.0 * within) / (600.0 + 1176.0), 1e-3);
}

// Each triangle on one side becomes four, which adds no area there.
IndexedMesh RefinedAbove(const IndexedMesh& mesh)
{
  IndexedMesh refined{mesh.Points, {}};
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    const Vector3 sum = mesh.Points[t[0]] + mesh.Points[t[1]] + mesh.Points[t[2]];
    if (sum.z() <= 0.0)
    {
      refined.Triangles.push_back(t);
      continue;
    }
    const int first = static_cast<int>(refined.Points.size());
    for (int i = 0; i < 3; ++i)
    {
      refined.Points.emplace_back(0.5 * (mesh.Points[t[i]] + mesh.Points[t[(i + 1) % 3]]));
    }
    refined.Triangles.push_back({t[0], first, first + 2});
    refined.Triangles.push_back({t[1], first + 1, first});
    refined.Triangles.push_back({t[2], first + 2, first + 1});
    refined.Triangles.push_back({first, first + 1, first + 2});
  }
  return refined;
}

TEST(BodyComparison, FinerTrianglesDoNotWeighMore)
{
  const IndexedMesh sphere = test::Sphere(80, 20.0, {0.0, 0.0, 1.0});
  const ComparedBody reference = BodyOfModel(SphereModel(20.0));
  const BodyComparison even = Compared(BodyOfMesh(sphere), reference);
  const BodyComparison uneven = Compared(BodyOfMesh(RefinedAbove(sphere)), reference);
  EXPECT_NEAR(uneven.OneToOther.SignedMean, even.OneToOther.SignedMean, 2e-3);
  EXPECT_NEAR(uneven.OneToOther.Unsigned.Percentile95, even.OneToOther.Unsigned.Percentile95, 5e-3);
  EXPECT_NEAR(uneven.Tolerances[0].SurfaceDice, even.Tolerances[0].SurfaceDice, 2e-3);
}

TEST(BodyComparison, IdenticalBodiesAgreeCompletely)
{
  const ComparedBody torus = BodyOfMesh(test::Torus(60, 30, 20.0, 6.0));
  const BodyComparison found = Compared(torus, torus);
  EXPECT_EQ(found.Overlap->Dice(), 1.0);
  EXPECT_EQ(found.Overlap->Jaccard(), 1.0);
  EXPECT_LT(found.Both.Largest, 1e-9);
  EXPECT_EQ(found.Tolerances.front().SurfaceDice, 1.0);
}

TEST(BodyComparison, DisjointBodiesShareNothing)
{
  const BodyComparison found =
      Compared(BodyOfModel(SphereModel(10.0)), BodyOfModel(SphereModel(10.0, {0.0, 0.0, 50.0})));
  EXPECT_EQ(found.Overlap->Dice(), 0.0);
  EXPECT_EQ(found.Overlap->Jaccard(), 0.0);
  EXPECT_GT(found.OneToOther.SignedMean, 30.0);
  EXPECT_NEAR(found.Both.Largest, 50.0, 0.02);
}

TEST(BodyComparison, OpenSurfaceHasUnsignedDistancesOnly)
{
  IndexedMesh open = test::Sphere(20, 20.0);
  open.Triangles.resize(open.Triangles.size() / 2);
  const ComparedBody shell = BodyOfMesh(open);
  EXPECT_FALSE(shell.IsClosed());
  EXPECT_TRUE(std::isnan(shell.Volume()));
  const BodyComparison found = Compared(shell, BodyOfModel(SphereModel(22.0)));
  EXPECT_FALSE(found.Overlap);
  EXPECT_NEAR(found.OneToOther.SignedMean, -2.0, 0.05);
  EXPECT_TRUE(std::isnan(found.OtherToOne.SignedMean));
  EXPECT_GE(found.OtherToOne.Unsigned.Mean, 2.0);
}

TEST(BodyComparison, OrderOfTheBodiesOnlySwapsDirections)
{
  const ComparedBody one = BodyOfModel(SphereModel(20.0, {2.0, 1.0, 0.0}));
  const ComparedBody other = BodyOfModel(EllipsoidModel({22.0, 18.0, 15.0}));
  const BodyComparison there = Compared(one, other);
  const BodyComparison back = Compared(other, one);
  EXPECT_EQ(there.Both.Mean, back.Both.Mean);
  EXPECT_EQ(there.Hausdorff95(), back.Hausdorff95());
  EXPECT_EQ(there.OneToOther.SignedMean, back.OtherToOne.SignedMean);
  EXPECT_EQ(there.Overlap->Dice(), back.Overlap->Dice());
}

TEST(BodyComparison, ShiftIsBiasOfOppositeSides)
{
  const BodyComparison found =
      Compared(BodyOfModel(SphereModel(20.0, {0.0, 0.0, 2.0})), BodyOfModel(SphereModel(20.0)));
  ASSERT_TRUE(found.Bias);
  // 2 cos over the side of a cube seen from its centre; its mean cosine is about 0.83.
  EXPECT_NEAR(found.Bias->Sides[4].Mean, 2.0 * 0.83, 0.1);
  EXPECT_NEAR(found.Bias->Sides[5].Mean, -2.0 * 0.83, 0.1);
  for (const std::size_t side : {0U, 1U, 2U, 3U})
  {
    EXPECT_NEAR(found.Bias->Sides[side].Mean, 0.0, 0.15);
  }
  double share = 0.0;
  for (const SideBias::Part& octant : found.Bias->Octants)
  {
    share += octant.Share;
  }
  EXPECT_NEAR(share, 1.0, 1e-12);
}

TEST(BodyComparison, CancelFails)
{
  const ComparedBody body = BodyOfModel(SphereModel(20.0));
  BodyComparison comparison;
  EXPECT_FALSE(CompareBodies(
                   body, body, {}, [](double) { return false; }, comparison)
                   .IsOk());
}

TEST(ComparedBody, RefusesWhatHasNoSurface)
{
  ComparedBody body;
  EXPECT_FALSE(ComparedBody::OfMesh({}, body).IsOk());
  const IndexedMesh flat{{Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(2, 0, 0)}, {{0, 1, 2}}};
  EXPECT_FALSE(ComparedBody::OfMesh(flat, body).IsOk());
  EXPECT_FALSE(ComparedBody::OfModel(SphereModel(0.0), body).IsOk());
  EXPECT_FALSE(ComparedBody::OfModel(SphereModel(std::nan("")), body).IsOk());
  EXPECT_FALSE(ComparedBody::OfMask({}, {}, body).IsOk());
  EXPECT_FALSE(ComparedBody::OfMesh(test::Sphere(4, 1e100), body).IsOk());
  EXPECT_FALSE(ComparedBody::OfModel(SphereModel(10.0, {1e9, 0.0, 0.0}), body).IsOk());
}
} // namespace
} // namespace palpate::body_comparison_test
