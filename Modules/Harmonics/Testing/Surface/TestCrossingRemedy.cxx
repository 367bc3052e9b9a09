#include "CrossingRemedy.h"

#include "MeshCrossings.h"
#include "SurfaceModelFit.h"
#include "SurfaceTessellation.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace palpate::crossing_remedy_test
{
namespace
{
/// A closed mesh with a direction for each vertex.
struct MappedMesh
{
  IndexedMesh Mesh;
  std::vector<Vector3> Parameters;
};

template <typename Shape>
MappedMesh MeshOf(const Shape& shape)
{
  const IcosahedronDirections sphere(24);
  MappedMesh made;
  made.Mesh.Triangles = sphere.Triangles();
  made.Parameters = sphere.Directions();
  for (const Vector3& u : sphere.Directions())
  {
    made.Mesh.Points.push_back(shape(u));
  }
  return made;
}

// A tube of 16 mm, bent until its flat ends are this far apart, mm.
MappedMesh OpenRing(double gap)
{
  return MeshOf(
      [gap](const Vector3& u)
      {
        constexpr double HalfLength = 40.0; // mm
        const double radius = (2.0 * HalfLength + gap) / (2.0 * M_PI);
        const double turn = u.z() * HalfLength / radius;
        const Vector3 inward(std::cos(turn), 0.0, -std::sin(turn));
        const double width = 8.0 * std::pow(1.0 - std::pow(std::abs(u.z()), 8.0), 0.125);
        const double length = std::max(std::hypot(u.x(), u.y()), 1e-9);
        return Vector3(Vector3(radius * (1.0 - std::cos(turn)), 0.0, radius * std::sin(turn)) +
                       width / length * (u.x() * inward + u.y() * Vector3::UnitY()));
      });
}

// A disc of 40 mm that is this thick in the middle; below 0 its faces have passed through each
// other there.
MappedMesh Disc(double wallInTheMiddle)
{
  return MeshOf(
      [wallInTheMiddle](const Vector3& u)
      {
        const double away = (u - u.z() * Vector3::UnitZ()).squaredNorm(); // 1 at the rim
        const double half = 0.5 * wallInTheMiddle + 3.0 * away;
        return Vector3(20.0 * u.x(), 20.0 * u.y(), half * u.z());
      });
}

// A plate with four lobes, of whose parameters most lie at one pole.
MappedMesh UnevenPlate(double unevenness)
{
  MappedMesh plate = MeshOf(
      [](const Vector3& u)
      {
        const double away = std::hypot(u.x(), u.y());
        const double radius =
            20.0 * (1.0 + 0.25 * std::cos(4.0 * std::atan2(u.y(), u.x())) * std::pow(away, 4.0));
        return Vector3(radius * u.x(), radius * u.y(), 5.0 * u.z());
      });
  for (Vector3& u : plate.Parameters)
  {
    // A Moebius map of the sphere: bijective.
    const double polar = 2.0 * std::atan(unevenness * std::tan(0.5 * std::acos(u.z())));
    const double away = std::hypot(u.x(), u.y());
    u = away > 1e-9 ? Vector3(u.x() / away * std::sin(polar), u.y() / away * std::sin(polar),
                              std::cos(polar))
                    : u;
  }
  return plate;
}

SurfaceModelFitResult Fitted(const MappedMesh& mapped, int degree, int separations, int refits = 4)
{
  SurfaceModelFitOptions options;
  options.Degree = degree;
  options.Refits = refits;
  options.MostSeparations = separations;
  SurfaceModelFitResult result;
  const Status status = FitSurfaceModel(mapped.Mesh, mapped.Parameters, options, result);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return result;
}

// By finer triangles than those in which the fit looks for them.
std::int64_t CrossingsOf(const SurfaceModel& surface)
{
  const IndexedMesh mesh = Tessellated(surface, IcosahedronDirections(5 * surface.Degree()));
  MeshCrossings found;
  EXPECT_TRUE(FindMeshCrossings(mesh, {}, found).IsOk());
  return found.Count;
}

CrossingRemedy RemedyFor(const SurfaceModel& surface, const MappedMesh& mapped)
{
  CrossingRemedy remedy;
  EXPECT_TRUE(FindCrossingRemedy(surface, SampleMesh(mapped.Mesh, mapped.Parameters, 1.0),
                                 mapped.Parameters.size(), remedy)
                  .IsOk());
  return remedy;
}

TEST(CrossingRemedy, NothingIsChangedWithoutCrossings)
{
  const MappedMesh ring = OpenRing(20.0);
  const CrossingRemedy remedy = RemedyFor(Fitted(ring, 8, 0).Surface, ring);
  EXPECT_EQ(remedy.Crossings, 0);
  EXPECT_FALSE(remedy.HasPleats());
  EXPECT_TRUE(std::all_of(remedy.Shifts.begin(), remedy.Shifts.end(),
                          [](double shift) { return shift == 0.0; }));
}

TEST(CrossingRemedy, SurfacesOfDegreeOneAndLessNeedNone)
{
  const MappedMesh ring = OpenRing(20.0);
  for (const int degree : {0, 1})
  {
    EXPECT_EQ(RemedyFor(Fitted(ring, degree, 12).Surface, ring).Crossings, 0) << degree;
  }
}

TEST(CrossingRemedy, FitIsCancelledWhileItIsTakenApart)
{
  const MappedMesh ring = OpenRing(0.3);
  SurfaceModelFitOptions options;
  options.Degree = 8;
  SurfaceModelFitResult result;
  EXPECT_FALSE(FitSurfaceModel(ring.Mesh, ring.Parameters, options, result,
                               [](double part) { return part < 0.85; })
                   .IsOk());
}

TEST(CrossingRemedy, BothSidesOfAGapRetreat)
{
  const MappedMesh ring = OpenRing(0.3);
  SurfaceModelFitResult fit = Fitted(ring, 8, 0);
  const CrossingRemedy remedy = RemedyFor(fit.Surface, {ring.Mesh, fit.Parameters});
  ASSERT_GT(remedy.Crossings, 0);
  EXPECT_FALSE(remedy.HasPleats());
  for (const bool isUpper : {false, true})
  {
    double least = 0.0;
    double most = 0.0;
    for (std::size_t i = 0; i < remedy.Shifts.size(); ++i)
    {
      if ((ring.Parameters[i].z() > 0.0) == isUpper)
      {
        least = std::min(least, remedy.Shifts[i]);
        most = std::max(most, remedy.Shifts[i]);
      }
    }
    EXPECT_LT(least, -0.1) << "mm";
    EXPECT_EQ(most, 0.0);
  }
}

TEST(CrossingRemedy, BothFacesOfAThinWallMoveOutwards)
{
  const SurfaceModel inverted = Fitted(Disc(-1.0), 8, 0, 0).Surface;
  const CrossingRemedy remedy = RemedyFor(inverted, Disc(0.3));
  ASSERT_GT(remedy.Crossings, 0);
  EXPECT_FALSE(remedy.HasPleats());
  EXPECT_GT(*std::max_element(remedy.Shifts.begin(), remedy.Shifts.end()), 0.1) << "mm";
  EXPECT_EQ(*std::min_element(remedy.Shifts.begin(), remedy.Shifts.end()), 0.0);
}

// Faces that have passed through each other in a spot smaller than a triangle, where only the
// coarser tessellation has a vertex.
TEST(CrossingRemedy, CrossingsOnlyAsDrawnCountToo)
{
  const auto tilted = [](MappedMesh disc)
  {
    const Eigen::AngleAxisd tilt(0.45, Vector3::UnitY());
    for (Vector3& point : disc.Mesh.Points)
    {
      point = tilt * point;
    }
    return disc;
  };
  const SurfaceModel surface = Fitted(tilted(Disc(-0.01)), 6, 0, 0).Surface;
  MeshCrossings finer;
  ASSERT_TRUE(FindMeshCrossings(Tessellated(surface, IcosahedronDirections(12)), {}, finer).IsOk());
  ASSERT_EQ(finer.Count, 0);
  EXPECT_GT(RemedyFor(surface, tilted(Disc(0.3))).Crossings, 0);
}

TEST(CrossingRemedy, PleatsAreToldFromSheetsThatMeet)
{
  const MappedMesh plate = UnevenPlate(3.0);
  const SurfaceModelFitResult fit = Fitted(plate, 8, 0);
  const CrossingRemedy remedy = RemedyFor(fit.Surface, {plate.Mesh, fit.Parameters});
  ASSERT_GT(remedy.Crossings, 0);
  EXPECT_TRUE(remedy.HasPleats());
  EXPECT_TRUE(std::all_of(remedy.Shifts.begin(), remedy.Shifts.end(),
                          [](double shift) { return shift == 0.0; }));
}

class FitAcrossAGap : public testing::TestWithParam<int>
{
};

TEST_P(FitAcrossAGap, DoesNotCrossItself)
{
  const MappedMesh ring = OpenRing(0.3);
  const SurfaceModelFitResult before = Fitted(ring, GetParam(), 0);
  const SurfaceModelFitResult after = Fitted(ring, GetParam(), 12);
  EXPECT_GT(CrossingsOf(before.Surface), 0);
  EXPECT_EQ(CrossingsOf(after.Surface), 0);
  // The ends are moved by less than the degree resolves.
  EXPECT_LT(after.NormalRms, 3.0 * before.NormalRms);
  EXPECT_NEAR(after.Surface.Volume() / before.Surface.Volume(), 1.0, 5e-4);
}

INSTANTIATE_TEST_SUITE_P(Degrees, FitAcrossAGap, testing::Values(6, 8, 12));

// mm: half the shortest wavelength.
double ResolutionOf(const SurfaceModel& surface)
{
  return std::sqrt(surface.Area() / (4.0 * M_PI)) * M_PI / surface.Degree();
}

class FitWithUnevenParameters : public testing::TestWithParam<int>
{
};

TEST_P(FitWithUnevenParameters, HasNoPleats)
{
  const MappedMesh plate = UnevenPlate(5.0);
  const SurfaceModelFitResult before = Fitted(plate, GetParam(), 0);
  const SurfaceModelFitResult after = Fitted(plate, GetParam(), 12);
  EXPECT_GT(CrossingsOf(before.Surface), 0);
  EXPECT_EQ(CrossingsOf(after.Surface), 0);
  EXPECT_EQ(after.Folded, 0);
  EXPECT_LT(after.NormalRms - before.NormalRms, 0.01 * ResolutionOf(before.Surface));
}

INSTANTIATE_TEST_SUITE_P(Degrees, FitWithUnevenParameters, testing::Values(12, 16));

struct UnevenFit
{
  double Unevenness;
  int Degree;
};

class FitThatCannotBeTakenApart : public testing::TestWithParam<UnevenFit>
{
};

// Without limits the RMS distance of the second and third would rise by 2 and 6 % of the resolution
// while they still cross themselves.
TEST_P(FitThatCannotBeTakenApart, IsOnlyGivenUpForABetterOne)
{
  const MappedMesh plate = UnevenPlate(GetParam().Unevenness);
  const SurfaceModelFitResult before = Fitted(plate, GetParam().Degree, 0);
  const SurfaceModelFitResult after = Fitted(plate, GetParam().Degree, 12);
  const double rise = (after.NormalRms - before.NormalRms) / ResolutionOf(before.Surface);
  ASSERT_GT(CrossingsOf(after.Surface), 0);
  EXPECT_LE(rise, 0.0075);
  EXPECT_TRUE(rise == 0.0 || 2 * CrossingsOf(after.Surface) < CrossingsOf(before.Surface));
}

INSTANTIATE_TEST_SUITE_P(Plates, FitThatCannotBeTakenApart,
                         testing::Values(UnevenFit{7.0, 12}, UnevenFit{7.0, 8}, UnevenFit{9.0, 8}));

TEST(CrossingRemedy, FewerCrossingsAreBetterThanMany)
{
  const MappedMesh plate = UnevenPlate(7.0);
  const SurfaceModelFitResult before = Fitted(plate, 12, 0);
  const SurfaceModelFitResult after = Fitted(plate, 12, 12);
  EXPECT_LT(2 * CrossingsOf(after.Surface), CrossingsOf(before.Surface));
}
} // namespace
} // namespace palpate::crossing_remedy_test
