#include "SurfaceModelFit.h"

#include "IcosahedronDirections.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::parametric_fit_test
{
namespace
{
// A tube bent by this angle (rad), round at both ends: not star-shaped beyond about 2.
Vector3 BentTube(const Vector3& u, double bend)
{
  constexpr double Width = 8.0;       // mm
  constexpr double HalfLength = 40.0; // mm, of the axis
  const double along = HalfLength * u.z();
  const double turn = 0.5 * bend * u.z();
  const double radius = bend > 0.0 ? 2.0 * HalfLength / bend : 0.0;
  const Vector3 axis = bend > 0.0
                           ? Vector3(radius * (1.0 - std::cos(turn)), 0.0, radius * std::sin(turn))
                           : Vector3(0.0, 0.0, along);
  const Vector3 inward(std::cos(turn), 0.0, -std::sin(turn));
  return axis + Width * (u.x() * inward + u.y() * Vector3::UnitY());
}

struct MappedMesh
{
  IndexedMesh Mesh;
  std::vector<Vector3> Parameters;
};

// The tube with parameters that are turned about z by an angle that depends on z: bijective.
MappedMesh TwistedTube(double bend, double twist, int frequency = 20)
{
  const IcosahedronDirections sphere(frequency);
  MappedMesh made;
  made.Mesh.Triangles = sphere.Triangles();
  for (const Vector3& u : sphere.Directions())
  {
    made.Mesh.Points.push_back(BentTube(u, bend));
    const double angle = twist * u.z();
    made.Parameters.emplace_back(std::cos(angle) * u.x() - std::sin(angle) * u.y(),
                                 std::sin(angle) * u.x() + std::cos(angle) * u.y(), u.z());
  }
  return made;
}

SurfaceModelFitResult Fitted(const MappedMesh& mapped, const SurfaceModelFitOptions& options)
{
  SurfaceModelFitResult result;
  const Status status = FitSurfaceModel(mapped.Mesh, mapped.Parameters, options, result);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return result;
}

SurfaceModelFitOptions OfDegree(int degree, int refits)
{
  SurfaceModelFitOptions options;
  options.Degree = degree;
  options.Refits = refits;
  return options;
}

double Orientation(const std::vector<Vector3>& q, const std::array<int, 3>& t)
{
  return q[static_cast<std::size_t>(t[0])].dot(
      q[static_cast<std::size_t>(t[1])].cross(q[static_cast<std::size_t>(t[2])]));
}

TEST(SurfaceModelFit, DescribesShapeThatIsNotStarShaped)
{
  const SurfaceModelFitResult result = Fitted(TwistedTube(4.0, 0.0), OfDegree(12, 0));
  EXPECT_LT(result.NormalRms, 0.01); // mm; the tube is no finite sum of harmonics
  EXPECT_EQ(result.Folded, 0);
}

TEST(SurfaceModelFit, RefitsReduceTheDistance)
{
  const MappedMesh mapped = TwistedTube(4.0, 1.5);
  const double once = Fitted(mapped, OfDegree(6, 0)).NormalRms;
  const double twice = Fitted(mapped, OfDegree(6, 1)).NormalRms;
  const double often = Fitted(mapped, OfDegree(6, 4)).NormalRms;
  EXPECT_LT(twice, 0.7 * once);
  EXPECT_LT(often, twice);
}

TEST(SurfaceModelFit, ParametersStayBijective)
{
  const MappedMesh mapped = TwistedTube(5.0, 2.0);
  const SurfaceModelFitResult result = Fitted(mapped, OfDegree(8, 6));
  for (const std::array<int, 3>& t : mapped.Mesh.Triangles)
  {
    ASSERT_GT(Orientation(result.Parameters, t), 0.0);
  }
}

double VolumeOf(const IndexedMesh& mesh)
{
  double sixfold = 0.0;
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    sixfold += Orientation(mesh.Points, t);
  }
  return sixfold / 6.0;
}

// Of a degree that is too low for the shape, so that the volume of the fit by points differs.
TEST(SurfaceModelFit, RefitsKeepTheVolume)
{
  const MappedMesh mapped = TwistedTube(4.0, 0.0);
  const double volume = VolumeOf(mapped.Mesh);
  const auto error = [&](int refits)
  { return std::abs(Fitted(mapped, OfDegree(3, refits)).Surface.Volume() / volume - 1.0); };
  EXPECT_GT(error(0), 0.01);
  EXPECT_LT(error(2), 0.1 * error(0));
}

TEST(SurfaceModelFit, ScaleAndTranslationCarryOver)
{
  MappedMesh mapped = TwistedTube(4.0, 1.0);
  const SurfaceModelFitResult before = Fitted(mapped, OfDegree(8, 2));
  const Vector3 shift(300.0, -200.0, 1000.0);
  for (Vector3& point : mapped.Mesh.Points)
  {
    point = 3.0 * point + shift;
  }
  const SurfaceModelFitResult after = Fitted(mapped, OfDegree(8, 2));
  const IcosahedronDirections sphere(4);
  for (const Vector3& u : sphere.Directions())
  {
    // The stop rules of the refits see other roundings.
    EXPECT_LT((after.Surface.Point(u) - 3.0 * before.Surface.Point(u) - shift).norm(), 1e-6);
  }
}

// The same shape with its parameter sphere turned.
TEST(SurfaceModelFit, PlacementDoesNotDependOnTheParametrisation)
{
  MappedMesh mapped = TwistedTube(2.0, 0.5);
  const SurfaceModelFitResult before = Fitted(mapped, OfDegree(8, 2));
  const Matrix3 turn =
      Eigen::AngleAxisd(1.1, Vector3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  for (Vector3& parameter : mapped.Parameters)
  {
    parameter = turn * parameter;
  }
  const SurfaceModelFitResult after = Fitted(mapped, OfDegree(8, 2));
  const IcosahedronDirections sphere(4);
  for (const Vector3& u : sphere.Directions())
  {
    EXPECT_LT((after.Surface.Point(u) - before.Surface.Point(u)).norm(), 1e-6); // mm, of 80
  }
}

TEST(SurfaceModelFit, RejectsParametersThatAreNotFinite)
{
  SurfaceModelFitResult result;
  MappedMesh mapped = TwistedTube(1.0, 0.0, 8);
  mapped.Parameters[5] = Vector3::Constant(std::nan(""));
  EXPECT_FALSE(FitSurfaceModel(mapped.Mesh, mapped.Parameters, OfDegree(6, 2), result).IsOk());
}

TEST(SurfaceModelFit, StopsWhenCancelled)
{
  SurfaceModelFitResult result;
  const MappedMesh mapped = TwistedTube(1.0, 0.0);
  EXPECT_FALSE(FitSurfaceModel(mapped.Mesh, mapped.Parameters, OfDegree(6, 4), result,
                               [](double) { return false; })
                   .IsOk());
}
} // namespace
} // namespace palpate::parametric_fit_test
