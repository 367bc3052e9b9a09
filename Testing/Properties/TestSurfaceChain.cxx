#include "LabelMask.h"
#include "MeshDistances.h"
#include "NoisyMask.h"
#include "RandomOrientation.h"
#include "SegmentationFile.h"
#include "SurfaceChain.h"
#include "SurfacePhantoms.h"
#include "TestData.h"

#include <gtest/gtest.h>
#include <numeric>
#include <random>

// From masks to surface models: what a fit keeps of shapes that are known, and what it refuses.
namespace palpate::test::surface_chain_test
{
namespace
{
const Vector3 Isotropic(1.0, 1.0, 1.0);
constexpr int Degree = 16;

SurfaceChain ChainOf(const VoxelMask& mask, int degree = Degree, int triangles = 5000,
                     double spacing = 0.0)
{
  SurfaceChain chain;
  const Status status = RunSurfaceChain(mask, degree, chain, triangles, spacing);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  EXPECT_TRUE(IsBijective(chain.Mesh.Triangles, chain.Fit.Parameters));
  return chain;
}

IndexedMesh Moved(IndexedMesh mesh, const Matrix3& turn, const Vector3& shift)
{
  for (Vector3& point : mesh.Points)
  {
    point = turn * point + shift;
  }
  return mesh;
}

// The truth is the tessellation that was voxelised. A mask tells a boundary to some tenth of a
// voxel, and nowhere better than to its diagonal.
void ExpectRecovered(const SurfaceModel& surface)
{
  const IndexedMesh truth = Tessellated(surface);
  const PlacedMask placed = Voxelised(truth, Isotropic);
  const SurfaceChain chain = ChainOf(placed.Mask);
  const IndexedMesh found =
      Moved(Tessellated(chain.Fit.Surface), Matrix3::Identity(), placed.Origin);
  MeshDistances distances;
  ASSERT_TRUE(MeasureMeshDistances(found, truth, distances).IsOk());
  EXPECT_LT(distances.Both.Mean, 0.15);
  EXPECT_LT(distances.Both.Largest, 1.2);
  EXPECT_NEAR(chain.Fit.Surface.Volume() / static_cast<double>(placed.Mask.Count()), 1.0, 0.001);
  EXPECT_EQ(OverlapOf(chain.Fit.Surface, placed.Mask).Irregular, 0);
}

TEST(SurfaceChain, RecoversCToTheVoxelsLimit)
{
  ExpectRecovered(OpenRing(Degree));
}

TEST(SurfaceChain, RecoversBowlToTheVoxelsLimit)
{
  ExpectRecovered(Bowl(Degree));
}

TEST(SurfaceChain, RecoversBentTubeWithBumpsToTheVoxelsLimit)
{
  Random random(3);
  ExpectRecovered(BumpyTube(random, Degree));
}

TEST(SurfaceChain, RecoversCleftToTheVoxelsLimit)
{
  ExpectRecovered(CleftBlob(Degree));
}

// A bean with a hilum.
bool IsInKidney(double x, double y, double z)
{
  const double bend = x + 0.012 * y * y;
  const bool isHilum = std::hypot(x - 20.0, 1.2 * y, 1.2 * z) < 13.0;
  return bend * bend / 324.0 + y * y / 1600.0 + z * z / 225.0 < 1.0 && !isHilum;
}

// A body, an arch around the foramen, a spinous and two transverse processes: one handle.
bool IsInVertebra(double x, double y, double z)
{
  const double around = std::hypot(x, y + 20.0);
  const bool isBody = std::hypot(x / 1.2, y) < 14.0 && std::abs(z) < 11.0;
  const bool isArch = std::abs(around - 11.0) < 3.0 && std::abs(z) < 6.0;
  const bool isSpine = std::hypot(x, 0.6 * z) < 3.5 && y < -28.0 && y > -52.0;
  const bool isAcross = std::hypot(y + 22.0, z) < 4.0 && std::abs(std::abs(x) - 20.0) < 10.0;
  return isBody || isArch || isSpine || isAcross;
}

TEST(SurfaceChain, ModelsKidneysAndVertebrae)
{
  const auto model = [](const char* name, const auto& isInside, int handles)
  {
    const VoxelMask mask =
        MaskWhere({64, 100, 36}, {1.0, 1.0, 1.0},
                  [&](int i, int j, int k) { return isInside(i - 31.5, j - 55.5, k - 17.5); });
    const SurfaceChain chain = ChainOf(mask, 20, 10000);
    const TopologyReport& topology = chain.Surface.Topology;
    EXPECT_EQ(topology.CutHandles.Count + topology.FilledHandles.Count, handles) << name;
    const WindingOverlap overlap = OverlapOf(chain.Fit.Surface, mask);
    EXPECT_GT(overlap.Dice(), 0.97) << name;
    EXPECT_LT(overlap.IrregularPercent(), 0.15) << name;
  };
  model("kidney", IsInKidney, 0);
  model("vertebra", IsInVertebra, 1);
}

// A mask on other axes of the file: index n runs along the axis Axes[n], reversed or not.
struct FileAxes
{
  std::array<std::size_t, 3> Axes;
  std::array<bool, 3> IsReversed;

  Vector3 ToFile(const Vector3& point, const VoxelMask& mask) const
  {
    Vector3 moved;
    for (std::size_t n = 0; n < 3; ++n)
    {
      const std::size_t axis = this->Axes[n];
      const double length = mask.Spacing[axis] * (mask.Size[axis] - 1);
      const double at = point[static_cast<long>(axis)];
      moved[static_cast<long>(n)] = this->IsReversed[n] ? length - at : at;
    }
    return moved;
  }
  VoxelMask Reordered(const VoxelMask& mask) const
  {
    std::array<int, 3> size{};
    std::array<double, 3> spacing{};
    for (std::size_t n = 0; n < 3; ++n)
    {
      size[n] = mask.Size[this->Axes[n]];
      spacing[n] = mask.Spacing[this->Axes[n]];
    }
    return MaskWhere(size, spacing,
                     [&](int i, int j, int k)
                     {
                       const std::array<int, 3> to{i, j, k};
                       std::array<int, 3> from{};
                       for (std::size_t n = 0; n < 3; ++n)
                       {
                         const int last = size[n] - 1;
                         from[this->Axes[n]] = this->IsReversed[n] ? last - to[n] : to[n];
                       }
                       return mask.Inside[mask.Offset(from[0], from[1], from[2])] != 0;
                     });
  }
};

double MeanDistance(const IndexedMesh& a, const IndexedMesh& b)
{
  MeshDistances distances;
  EXPECT_TRUE(MeasureMeshDistances(a, b, distances).IsOk());
  return distances.Both.Mean;
}

// Diagonals of the grid keep their direction, so that triangles differ but not the shape: by less
// than a tenth of a pixel.
TEST(SurfaceChain, OrderOfTheFilesAxesDoesNotChangeTheShape)
{
  const PlacedMask placed = Voxelised(Tessellated(OpenRing(12)), {0.8, 0.8, 2.4});
  const SurfaceChain chain = ChainOf(placed.Mask, 12);
  const IndexedMesh mesh = Tessellated(chain.Fit.Surface);
  for (const FileAxes& axes :
       {FileAxes{{0, 1, 2}, {true, false, false}}, FileAxes{{0, 1, 2}, {true, true, true}},
        FileAxes{{2, 0, 1}, {false, true, false}}})
  {
    const SurfaceChain other = ChainOf(axes.Reordered(placed.Mask), 12);
    IndexedMesh expected = mesh;
    for (Vector3& point : expected.Points)
    {
      point = axes.ToFile(point, placed.Mask);
    }
    EXPECT_LT(MeanDistance(Tessellated(other.Fit.Surface), expected), 0.06); // mm
    EXPECT_NEAR(other.Fit.Surface.Volume() / chain.Fit.Surface.Volume(), 1.0, 0.001);
  }
}

TEST(SurfaceChain, UnitsDoNotChangeTheShape)
{
  PlacedMask placed = Voxelised(Tessellated(Bowl(12)), {1.2, 1.2, 2.0});
  const SurfaceChain chain = ChainOf(placed.Mask, 12);
  for (double& spacing : placed.Mask.Spacing)
  {
    spacing *= 4.0; // exact in floating point: every decision is the same
  }
  const SurfaceChain scaled = ChainOf(placed.Mask, 12);
  const IcosahedronDirections sphere(4);
  for (const Vector3& u : sphere.Directions())
  {
    EXPECT_LT((scaled.Fit.Surface.Point(u) - 4.0 * chain.Fit.Surface.Point(u)).norm(), 1e-9);
  }
}

TEST(SurfaceChain, TurnedAndMovedBodiesKeepTheirShape)
{
  std::mt19937_64 random(8);
  const IndexedMesh truth = Tessellated(Bowl(12));
  for (int n = 0; n < 2; ++n)
  {
    const IndexedMesh turned =
        Moved(truth, RandomOrientation(random), Vector3(0.3, 0.7, 0.1) * (n + 1));
    const PlacedMask placed = Voxelised(turned, Isotropic);
    const SurfaceChain chain = ChainOf(placed.Mask, 12);
    const IndexedMesh found =
        Moved(Tessellated(chain.Fit.Surface), Matrix3::Identity(), placed.Origin);
    EXPECT_LT(MeanDistance(found, turned), 0.15);
  }
}

TEST(SurfaceChain, IsDeterministic)
{
  const PlacedMask placed = Voxelised(Tessellated(OpenRing(12)), {1.0, 1.0, 2.0});
  const SurfaceChain one = ChainOf(placed.Mask, 12);
  const SurfaceChain other = ChainOf(placed.Mask, 12);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(one.Fit.Surface.Coefficients(axis), other.Fit.Surface.Coefficients(axis));
  }
}

double MeanGap(const SurfaceModel& a, const std::function<Vector3(const Vector3&)>& b,
               double& largest)
{
  const IcosahedronDirections sphere(10);
  double sum = 0.0;
  for (const Vector3& u : sphere.Directions())
  {
    const double gap = (a.Point(u) - b(u)).norm();
    sum += gap;
    largest = std::max(largest, gap);
  }
  return sum / static_cast<double>(sphere.Directions().size());
}

// The same direction is the same place: under noise of the boundary, on another grid and mesh, and
// in the mirrored body.
TEST(SurfaceChain, SameDirectionsAreTheSamePlaces)
{
  std::mt19937_64 random(21);
  const PlacedMask placed = Voxelised(Tessellated(Bowl(12)), {0.5, 0.5, 3.0});
  const VoxelMask& mask = placed.Mask;
  const SurfaceModel model = ChainOf(mask, 12).Fit.Surface;
  const auto same = [&](const Vector3& u) { return model.Point(u); };
  double largest = 0.0;
  EXPECT_LT(MeanGap(ChainOf(WithNoise(mask, 0.15, random), 12).Fit.Surface, same, largest), 0.6);
  const double spacing = 1.17 * ChainOf(mask, 4).Surface.Field.Grid.Spacing;
  EXPECT_LT(MeanGap(ChainOf(mask, 12, 3600, spacing).Fit.Surface, same, largest), 0.6);
  const FileAxes mirror{{0, 1, 2}, {true, false, false}};
  const auto mirrored = [&](const Vector3& u)
  { return mirror.ToFile(model.Point(Vector3(-u[0], u[1], u[2])), mask); };
  EXPECT_LT(MeanGap(ChainOf(mirror.Reordered(mask), 12).Fit.Surface, mirrored, largest), 0.6);
  EXPECT_LT(largest, 5.0);
}

// A zone with long horns, which may lie to either side on the sphere: a search for the map of least
// energy with all the weight of area turns one of the three variants, by 1.8 mm in the mean.
TEST(SurfaceChain, NoiseKeepsThePlacesOfHorns)
{
  const std::filesystem::path file = DataPath("prostate/cohort/zones/10482_1000490.nii.gz");
  PALPATE_REQUIRE_FILE(file);
  const Segmentation zones = ReadSegmentation(file);
  const VoxelMask mask = CopyLabelMask(zones.Layers.front(), 1, 1).Mask;
  const SurfaceModel model = ChainOf(mask, 12).Fit.Surface;
  const auto same = [&](const Vector3& u) { return model.Point(u); };
  std::mt19937_64 random(21);
  for (int variant = 0; variant < 3; ++variant)
  {
    double largest = 0.0;
    const SurfaceChain noisy = ChainOf(WithNoise(mask, 0.15, random), 12);
    EXPECT_LT(MeanGap(noisy.Fit.Surface, same, largest), 1.4); // mm
    EXPECT_LT(largest, 8.0);
  }
}

bool IsInSphere(int i, int j, int k, double centre, double radius)
{
  return std::hypot(i - centre, j - centre, k - centre) < radius;
}

std::string MessageOf(const VoxelMask& mask, int degree = 12)
{
  SurfaceChain chain;
  return RunSurfaceChain(mask, degree, chain).Message();
}

TEST(SurfaceChain, RefusesSeveralAndHollowBodies)
{
  const std::array<double, 3> spacing{1.0, 1.0, 1.0};
  std::mt19937_64 random(2);
  const std::string two = MessageOf(MaskWhere({40, 18, 18}, spacing,
                                              [](int i, int j, int k) {
                                                return IsInSphere(i, j, k, 8.5, 8.0) ||
                                                       IsInSphere(i - 22, j, k, 8.5, 8.0);
                                              }));
  EXPECT_NE(two.find("mm apart"), std::string::npos) << two;
  const std::string hollow = MessageOf(MaskWhere({24, 24, 24}, spacing,
                                                 [](int i, int j, int k) {
                                                   return IsInSphere(i, j, k, 11.5, 11.0) &&
                                                          !IsInSphere(i, j, k, 11.5, 6.0);
                                                 }));
  EXPECT_NE(hollow.find("cavity"), std::string::npos) << hollow;
  const std::string sponge = MessageOf(MaskWhere(
      {34, 34, 34}, spacing,
      [&](int i, int j, int k) { return IsInSphere(i, j, k, 16.5, 16.0) && random() % 4 != 0; }));
  EXPECT_NE(sponge.find("% of its volume"), std::string::npos) << sponge;
  const std::string none =
      MessageOf(MaskWhere({4, 4, 4}, spacing, [](int, int, int) { return false; }));
  EXPECT_FALSE(none.empty());
}

// A helix of 3.5 turns.
bool IsInHelix(int i, int j, int k)
{
  const double x = i - 19.0;
  const double y = j - 19.0;
  const double turn = std::atan2(y, x) / (2.0 * M_PI);
  double nearest = 100.0;
  for (int n = 0; n < 5; ++n)
  {
    const double along = std::clamp(turn + n, 0.0, 3.5);
    const Vector3 axis(14.0 * std::cos(2.0 * M_PI * along), 14.0 * std::sin(2.0 * M_PI * along),
                       9.0 * along + 5.0);
    nearest = std::min(nearest, (Vector3(x, y, k) - axis).norm());
  }
  return nearest < 3.0;
}

TEST(SurfaceChain, RefusesNeedlesAndHelicesThatNoDegreeHolds)
{
  const std::string needle =
      MessageOf(MaskWhere({60, 1, 1}, {1.0, 1.0, 1.0}, [](int, int, int) { return true; }));
  EXPECT_NE(needle.find("too long and thin"), std::string::npos) << needle;
  const std::string helix = MessageOf(MaskWhere({39, 39, 42}, {1.0, 1.0, 1.0}, IsInHelix));
  EXPECT_NE(helix.find("too long and thin"), std::string::npos) << helix;
}

TEST(SurfaceChain, ModelsVoxelsSheetsAndBodiesWithDirt)
{
  const std::array<double, 3> spacing{1.0, 1.0, 1.0};
  const auto all = [](int, int, int) { return true; };
  const auto dirty = [](int i, int j, int k)
  {
    const bool isCavity = i > 8 && i < 14 && j == 11 && k > 10 && k < 13;
    const bool isBeside = j < 3 && k == 22 && i > 8 && i < 14; // an island of 15 voxels
    return (IsInSphere(i, j, k, 11.5, 11.0) && !isCavity) || isBeside;
  };
  for (const VoxelMask& mask :
       {MaskWhere({1, 1, 1}, spacing, all), MaskWhere({40, 40, 1}, spacing, all),
        MaskWhere({24, 24, 24}, spacing, dirty)})
  {
    const SurfaceChain chain = ChainOf(mask, 12);
    EXPECT_GT(OverlapOf(chain.Fit.Surface, mask).Dice(), 0.98) << mask.Size[2];
  }
}
} // namespace
} // namespace palpate::test::surface_chain_test
