#include "FitCases.h"
#include "FitStructure.h"

#include "ClosestPointDistances.h"
#include "IndexedMesh.h"
#include "LabelImages.h"
#include "MeshDistances.h"
#include "ModelSurface.h"
#include "Progress.h"
#include "RepairRemarks.h"
#include "SegmentationFile.h"
#include "SurfaceModelMask.h"
#include "SurfacePhantoms.h"
#include "TestData.h"
#include "TriangleMesh.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace palpate::surface_models_test
{
namespace
{
using test::CubesWhere;
using test::FitMask;
using Outcome = palpate::FitResult::Outcome;

int StagesNamed(const std::string& name, const FitResult& result)
{
  return static_cast<int>(std::count_if(result.Seconds.begin(), result.Seconds.end(),
                                        [&name](const auto& stage)
                                        { return stage.first == name; }));
}

FitSettings SurfaceOfDegree(int degree)
{
  FitSettings settings;
  settings.Model = FitSettings::ModelKind::Surface;
  settings.Degree = degree;
  return settings;
}

palpate::test::LabelGrid Cubes(double step)
{
  palpate::test::LabelGrid grid;
  grid.Spacing = {step, step, step};
  return grid;
}

const SurfaceModel& SurfaceOf(const FitResult& result)
{
  return std::get<SurfaceModel>(result.Model);
}

// Root mean square distance (mm) of the drawn model's points from the true surface.
double ErrorOf(const FitResult& result, const SurfaceModel& truth)
{
  constexpr int Fine = 60;
  palpate::TriangleMesh mesh;
  const IndexedMesh fine = palpate::Tessellated(truth, palpate::IcosahedronDirections(Fine));
  mesh.PointsWorld = fine.Points;
  mesh.Triangles = fine.Triangles;
  double squares = 0.0;
  const std::vector<double> distances =
      palpate::ClosestPointDistances(result.ModelSurface->GetPoints(), palpate::PolyDataOf(mesh));
  for (const double distance : distances)
  {
    squares += distance * distance;
  }
  return std::sqrt(squares / static_cast<double>(distances.size()));
}

vtkSmartPointer<vtkImageData> Ring(double step)
{
  return palpate::test::SurfaceModelMask(palpate::test::OpenRing(), Cubes(step));
}

TEST(SurfaceModels, RecoverATubeToTheVoxelsLimit)
{
  const SurfaceModel truth = palpate::test::OpenRing();
  for (const double step : {2.0, 1.0})
  {
    const FitResult result = FitMask(Ring(step), SurfaceOfDegree(16));
    ASSERT_EQ(result.State, Outcome::Fitted) << result.Message;
    // A surface through the stairs of voxels of size h is off by about h / sqrt(12) / 2 rms.
    EXPECT_LT(ErrorOf(result, truth), 0.15 * step) << step;
    EXPECT_NEAR(1000.0 * result.ModelMilliliters, truth.Volume(), 0.01 * truth.Volume()) << step;
    EXPECT_EQ(result.Details.Crossings, 0);
    EXPECT_EQ(result.Details.IrregularPercent, 0.0);
  }
}

TEST(SurfaceModels, RecoverABowl)
{
  const SurfaceModel truth = palpate::test::Bowl();
  const FitResult result =
      FitMask(palpate::test::SurfaceModelMask(truth, Cubes(1.0)), SurfaceOfDegree(16));
  ASSERT_EQ(result.State, Outcome::Fitted) << result.Message;
  EXPECT_LT(ErrorOf(result, truth), 0.15);
  EXPECT_GT(result.Dice, 0.97);
}

TEST(SurfaceModels, AreChosenOnlyWhereARadiusDoesNot)
{
  FitSettings automatic;
  automatic.Degree = 8;
  const FitResult ring = FitMask(Ring(2.0), automatic);
  ASSERT_EQ(ring.State, Outcome::Fitted) << ring.Message;
  EXPECT_EQ(ring.Radial(), nullptr);
  EXPECT_GT(ring.HiddenPercent, automatic.MaximumHiddenPercent);

  const SurfaceModel ellipsoid = palpate::test::EllipsoidPhantom(Vector3(20.0, 16.0, 12.0));
  const FitResult round =
      FitMask(palpate::test::SurfaceModelMask(ellipsoid, Cubes(2.0)), automatic);
  ASSERT_EQ(round.State, Outcome::Fitted) << round.Message;
  EXPECT_NE(round.Radial(), nullptr);
}

TEST(SurfaceModels, AreRefusedAsRadialOnes)
{
  FitSettings radial;
  radial.Model = FitSettings::ModelKind::Radial;
  const FitResult result = FitMask(Ring(2.0), radial);
  EXPECT_EQ(result.State, Outcome::Refused);
  EXPECT_NE(result.OptionHint.find("--model surface"), std::string::npos) << result.OptionHint;
}

// The same structure on a grid whose axes are turned and mirrored.
TEST(SurfaceModels, DoNotDependOnTheFilesAxes)
{
  const SurfaceModel truth = palpate::test::OpenRing();
  palpate::test::LabelGrid turned = Cubes(1.0);
  turned.Direction = {0, 0, -1, 1, 0, 0, 0, 1, 0}; // left-handed
  const FitResult straight = FitMask(Ring(1.0), SurfaceOfDegree(8));
  const FitResult other =
      FitMask(palpate::test::SurfaceModelMask(truth, turned), SurfaceOfDegree(8));
  ASSERT_EQ(straight.State, Outcome::Fitted) << straight.Message;
  ASSERT_EQ(other.State, Outcome::Fitted) << other.Message;
  double squares = 0.0;
  const palpate::IcosahedronDirections sphere(6);
  for (const Vector3& parameter : sphere.Directions())
  {
    squares +=
        (SurfaceOf(straight).Point(parameter) - SurfaceOf(other).Point(parameter)).squaredNorm();
  }
  // The same parameter is the same place: meshes of two grids slide by some hundredths of the
  // tube's length of 94 mm.
  EXPECT_LT(std::sqrt(squares / static_cast<double>(sphere.Directions().size())), 4.0);
  EXPECT_NEAR(ErrorOf(straight, truth), ErrorOf(other, truth), 0.05);
}

// A drawing as coarse as for radial models cuts off what a high degree adds.
TEST(SurfaceModels, AreDrawnAsFineAsTheirDegree)
{
  const auto degrees = [](int degree)
  {
    const auto count = static_cast<std::size_t>((degree + 1) * (degree + 1));
    const std::vector<double> zeros(count, 0.0);
    return palpate::OrganModel(SurfaceModel(degree, {{zeros, zeros, zeros}}));
  };
  EXPECT_EQ(palpate::DrawnFrequency(degrees(12), 20), 20);
  EXPECT_EQ(palpate::DrawnFrequency(degrees(25), 20), 40);
  EXPECT_EQ(palpate::DrawnFrequency(degrees(25), 64), 64);
  const palpate::OrganModel radial = palpate::RadialModel(0, {1.0}, Vector3::Zero());
  EXPECT_EQ(palpate::DrawnFrequency(radial, 5), 5);
}

TEST(SurfaceModels, AreTheSameEachTime)
{
  const FitResult first = FitMask(Ring(2.0), SurfaceOfDegree(8));
  const FitResult second = FitMask(Ring(2.0), SurfaceOfDegree(8));
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(SurfaceOf(first).Coefficients(axis), SurfaceOf(second).Coefficients(axis));
  }
}

TEST(SurfaceModels, HaveTheSmallestDegreeWithinTheTolerance)
{
  FitSettings settings = SurfaceOfDegree(0);
  settings.Tolerance = 0.35;
  const FitResult result = FitMask(Ring(1.0), settings);
  ASSERT_EQ(result.State, Outcome::Fitted) << result.Message;
  EXPECT_LE(result.Rms, 0.35);
  const int degree = palpate::DegreeOf(result.Model);
  EXPECT_GT(FitMask(Ring(1.0), SurfaceOfDegree(degree - 1)).Rms, 0.35);
}

TEST(SurfaceModels, SayHowFarToTrustThem)
{
  const FitResult result = FitMask(Ring(1.0), SurfaceOfDegree(12));
  ASSERT_EQ(result.State, Outcome::Fitted) << result.Message;
  EXPECT_EQ(result.Coverage.Outcome, palpate::DirectionCoverage::Verdict::Good)
      << result.Coverage.Message;
  EXPECT_GT(result.NoiseDeviation, 0.0);
  vtkDataArray* deviation = result.ModelSurface->GetPointData()->GetArray("NormalDeviation");
  ASSERT_NE(deviation, nullptr);
  // Their mean square is the noise times the share of numbers that were fitted to it.
  double squares = 0.0;
  for (vtkIdType id = 0; id < deviation->GetNumberOfTuples(); ++id)
  {
    squares += std::pow(deviation->GetComponent(id, 0), 2);
  }
  const double rms = std::sqrt(squares / static_cast<double>(deviation->GetNumberOfTuples()));
  EXPECT_NEAR(rms, result.NoiseDeviation * result.Coverage.NoiseGainRms, 0.05 * rms);
}

// Two balls of 8 mm, 12 mm apart.
vtkSmartPointer<vtkImageData> TwoBalls()
{
  return CubesWhere({60, 32, 32}, [](double x, double y, double z)
                    { return std::hypot(std::abs(x) - 14.0, y, z) < 8.0; });
}

TEST(SurfaceModels, OfSeveralPartsAreMadeOnlyOnRequest)
{
  FitSettings settings = SurfaceOfDegree(12);
  // One of them alone has a Dice of 2/3 with both.
  for (const int component : {0, 1})
  {
    settings.Component = component;
    const FitResult refused = FitMask(TwoBalls(), settings);
    EXPECT_EQ(refused.State, Outcome::Refused);
    EXPECT_NE(refused.Message.find("mm apart"), std::string::npos) << refused.Message;
    EXPECT_NE(refused.OptionHint.find("--repair"), std::string::npos) << refused.OptionHint;
    EXPECT_EQ(refused.ModelSurface, nullptr);
  }
  settings.MinimumDice = 0.5;
  EXPECT_EQ(FitMask(TwoBalls(), settings).State, Outcome::Refused);
  settings.Rules = 1;
  EXPECT_EQ(FitMask(TwoBalls(), settings).State, Outcome::Fitted);

  settings.Component = 0;
  settings.Repairs = true;
  settings.MinimumDice = 0.0;
  const FitResult bridged = FitMask(TwoBalls(), settings);
  EXPECT_EQ(bridged.State, Outcome::Fitted) << bridged.Message;
  EXPECT_EQ(bridged.Details.Mapped->Topology.Bridges.Count, 1);
}

// Asked for by its number, a part is all that the model has to match.
TEST(SurfaceModels, OfOneComponentAreComparedWithItAlone)
{
  for (const FitSettings::ModelKind kind :
       {FitSettings::ModelKind::Surface, FitSettings::ModelKind::Radial})
  {
    for (const int component : {1, 2})
    {
      FitSettings settings;
      settings.Model = kind;
      settings.Component = component;
      settings.IsAlone = true;
      const FitResult result = FitMask(TwoBalls(), settings);
      ASSERT_EQ(result.State, Outcome::Fitted) << result.Message;
      EXPECT_GT(result.Dice, 0.97); // a ball of 8 voxels in radius
    }
  }
}

// A box of 80 x 4 x 4 mm is star-shaped, but a radius of degree 12 does not reach its ends.
vtkSmartPointer<vtkImageData> Rod()
{
  return CubesWhere({90, 12, 12}, [](double x, double y, double z)
                    { return std::abs(x) < 40.0 && std::abs(y) < 2.0 && std::abs(z) < 2.0; });
}

TEST(SurfaceModels, AreTakenWhereARadiusIsNotGoodEnough)
{
  FitSettings radial;
  radial.Model = FitSettings::ModelKind::Radial;
  ASSERT_EQ(FitMask(Rod(), radial).State, Outcome::Refused);
  const FitResult result = FitMask(Rod());
  ASSERT_EQ(result.State, Outcome::Fitted) << result.Message;
  EXPECT_TRUE(std::holds_alternative<SurfaceModel>(result.Model));
  EXPECT_GT(result.Dice, 0.95);
}

// A ball and a smaller one, 2 mm apart.
vtkSmartPointer<vtkImageData> NearBalls()
{
  return CubesWhere({60, 32, 32}, [](double x, double y, double z)
                    { return std::hypot(x + 8.0, y, z) < 9.0 || std::hypot(x - 9.0, y, z) < 6.0; });
}

TEST(SurfaceModels, AreNotTakenWhereARadialOneIsWantedWhateverItLoses)
{
  FitSettings settings;
  settings.MaximumHiddenPercent = 100.0;
  EXPECT_EQ(FitMask(Rod(), settings).State, Outcome::Refused);
  const FitResult largest = FitMask(NearBalls(), settings);
  ASSERT_EQ(largest.State, Outcome::Fitted) << largest.Message;
  EXPECT_NE(largest.Radial(), nullptr);
}

// Doubtful, as no degree meets the tolerance: by the first rules, whichever overlaps the voxels
// more.
TEST(SurfaceModels, AreTakenByTheFirstRulesOnlyIfTheyOverlapMore)
{
  std::set<bool> taken;
  for (const double step : {2.0, 4.0, 5.0})
  {
    const auto mask = palpate::test::SurfaceModelMask(
        palpate::test::EllipsoidPhantom(Vector3(20.0, 16.0, 12.0)), Cubes(step));
    FitSettings settings;
    settings.Rules = 1;
    settings.Tolerance = 0.001;
    const FitResult automatic = FitMask(mask, settings);
    settings.Model = FitSettings::ModelKind::Radial;
    const FitResult radial = FitMask(mask, settings);
    settings.Model = FitSettings::ModelKind::Surface;
    const FitResult surface = FitMask(mask, settings);
    ASSERT_EQ(radial.State, Outcome::Fitted) << radial.Message;
    const bool isBetter = surface.State == Outcome::Fitted && surface.Dice > radial.Dice;
    EXPECT_EQ(automatic.Radial() == nullptr, isBetter) << step;
    EXPECT_EQ(automatic.Dice, isBetter ? surface.Dice : radial.Dice);
    EXPECT_EQ(StagesNamed("rejected_model", automatic), 1);
    taken.insert(isBetter);
  }
  EXPECT_EQ(taken.size(), 2U);
}

TEST(SurfaceModels, ThatAreRefusedTooKeepTheWayOut)
{
  FitSettings settings;
  settings.MinimumDice = 0.9999;
  const FitResult result = FitMask(Rod(), settings);
  EXPECT_EQ(result.State, Outcome::Refused);
  EXPECT_NE(result.Details.Mapped, nullptr); // the refusal of the surface model
  EXPECT_NE(result.OptionHint.find("--min-dice"), std::string::npos) << result.OptionHint;
}

TEST(SurfaceModels, ProgressNeverRunsBack)
{
  FitSettings halves;
  halves.MinimumDice = 0.5;
  FitSettings searched = SurfaceOfDegree(0);
  searched.Tolerance = 0.16; // of a degree between 18 and 22, which are tried first
  for (const auto& [mask, settings] :
       {std::pair(Ring(2.0), FitSettings()), std::pair(Ring(2.0), SurfaceOfDegree(8)),
        std::pair(Ring(1.5), searched), std::pair(Rod(), FitSettings()),
        std::pair(NearBalls(), FitSettings()), std::pair(TwoBalls(), halves),
        std::pair(TwoBalls(), SurfaceOfDegree(8))})
  {
    double last = 0.0;
    const FitResult result = FitMask(mask, settings,
                                     [&last](double part, const std::string& stage)
                                     {
                                       EXPECT_GE(part, last - 1e-12) << stage;
                                       last = part;
                                       return true;
                                     });
    if (result.State == Outcome::Fitted)
    {
      EXPECT_NEAR(last, 1.0, 1e-12);
    }
  }
}

TEST(SurfaceModels, TakeInNearPartsThatARadiusWouldLeaveOut)
{
  const FitResult result = FitMask(NearBalls());
  ASSERT_EQ(result.State, Outcome::Fitted) << result.Message;
  ASSERT_EQ(result.ComponentMilliliters.size(), 2U);
  EXPECT_EQ(result.Details.Mapped->Topology.Bridges.Count, 1);
  EXPECT_GT(result.Dice, 0.95);
}

// A rod of two pieces that touch by an edge: two components, one organ.
TEST(SurfaceModels, TakeInPartsThatAreNear)
{
  const auto rod = CubesWhere({60, 30, 30},
                              [](double x, double y, double z)
                              {
                                const bool isLeft = x < 0.0;
                                return std::abs(x) < 24.0 && std::abs(z) < 5.0 &&
                                       (isLeft ? y > 0.0 && y < 10.0 : y < 0.0 && y > -10.0);
                              });
  const FitResult result = FitMask(rod, SurfaceOfDegree(16));
  ASSERT_EQ(result.State, Outcome::Fitted) << result.Message;
  ASSERT_EQ(result.ComponentMilliliters.size(), 2U);
  EXPECT_NEAR(result.MaskMilliliters,
              result.ComponentMilliliters[0] + result.ComponentMilliliters[1], 1e-9);
  EXPECT_GT(result.Dice, 0.9);
  // Measured against the whole mask: a corner at most.
  EXPECT_LT(result.ModelToMask.Maximum, 4.0);
}

TEST(SurfaceModels, OfATorusTellThatItsHandleWasCut)
{
  const auto torus = CubesWhere({60, 60, 24}, [](double x, double y, double z)
                                { return std::hypot(std::hypot(x, y) - 18.0, z) < 7.0; });
  const FitResult result = FitMask(torus, SurfaceOfDegree(12));
  ASSERT_EQ(result.State, Outcome::Fitted) << result.Message;
  EXPECT_EQ(result.Details.Mapped->Topology.CutHandles.Count, 1);
  bool isTold = false;
  for (const std::string& note : result.Notes)
  {
    isTold = isTold || note.find("handle cut") != std::string::npos;
  }
  EXPECT_TRUE(isTold);
}

TEST(RepairRemarks, VolumesHaveNoExponent)
{
  EXPECT_EQ(VolumeText(0.34567), "0.346 mm\xC2\xB3");
  EXPECT_EQ(VolumeText(99.96), "100 mm\xC2\xB3");
  EXPECT_EQ(VolumeText(2101.4), "2101 mm\xC2\xB3");
}

// The tube's ellipsoid is longest along the parameter x, wherever the file's axes look.
TEST(SurfaceModels, WithoutOrientationFollowTheirEllipsoid)
{
  Segmentation segmentation;
  segmentation.Layers.emplace_back(Ring(2.0));
  segmentation.IsOriented = false;
  Segment segment;
  segment.Label = segment.Value = 1;
  segmentation.Segments.push_back(segment);
  const FitResult result = palpate::FitStructure(segmentation, segment, SurfaceOfDegree(8));
  ASSERT_EQ(result.State, Outcome::Fitted) << result.Message;
  const auto extent = [&result](const Vector3& axis)
  { return (SurfaceOf(result).Point(axis) - SurfaceOf(result).Point(-axis)).norm(); };
  EXPECT_GT(extent(Vector3::UnitX()), extent(Vector3::UnitZ()));
  bool isTold = false;
  for (const std::string& note : result.Notes)
  {
    isTold = isTold || note.find("axes of the ellipsoid") != std::string::npos;
  }
  EXPECT_TRUE(isTold);
}

TEST(SurfaceModels, OfASpongeAreRefusedForItsHoles)
{
  std::mt19937_64 random(1);
  const auto sponge = CubesWhere({40, 40, 40}, [&random](double x, double y, double z)
                                 { return std::hypot(x, y, z) < 16.0 && random() % 4 != 0; });
  const FitResult result = FitMask(sponge, SurfaceOfDegree(12));
  EXPECT_EQ(result.State, Outcome::Refused);
  EXPECT_NE(result.Message.find("% of its volume"), std::string::npos) << result.Message;
  EXPECT_EQ(result.ModelSurface, nullptr);
}

TEST(SurfaceModels, OfANeedleAreRefusedAndTouchIsNamed)
{
  const auto needle =
      CubesWhere({200, 8, 8}, [](double x, double y, double z)
                 { return std::abs(x) < 97.0 && std::abs(y) < 1.0 && std::abs(z) < 1.0; });
  const FitResult result = FitMask(needle, SurfaceOfDegree(12));
  EXPECT_EQ(result.State, Outcome::Refused);
  EXPECT_NE(result.Message.find("too long and thin"), std::string::npos) << result.Message;
  EXPECT_NE(result.OptionHint.find("palpate touch"), std::string::npos) << result.OptionHint;
}

TEST(SurfaceModels, CanBeCancelled)
{
  for (const double end : {0.32, 0.45, 0.6})
  {
    const auto stop = [end](double part, const std::string&) { return part < end; };
    EXPECT_THROW(FitMask(Ring(2.0), SurfaceOfDegree(12), stop), palpate::Cancelled) << end;
  }
  // While a surface model is tried after a radial one.
  for (const double end : {0.75, 0.9})
  {
    double last = 0.0;
    const auto stop = [end, &last](double part, const std::string&)
    {
      last = part;
      return part < end;
    };
    EXPECT_THROW(FitMask(Rod(), {}, stop), palpate::Cancelled) << end;
    EXPECT_LT(last, 1.0);
  }
}

class SurfaceOfAZone : public testing::TestWithParam<const char*>
{
};

// Each of these crosses itself at 32 to 107 pairs of triangles if its sheets are not taken apart.
TEST_P(SurfaceOfAZone, DoesNotCrossItself)
{
  const auto path =
      palpate::test::DataPath(std::string("prostate/picai/zones_") + GetParam() + ".nii.gz");
  PALPATE_REQUIRE_FILE(path);
  const Segmentation segmentation = ReadSegmentation(path);
  const FitResult result =
      palpate::FitStructure(segmentation, segmentation.Find("1"), SurfaceOfDegree(16));
  ASSERT_EQ(result.State, Outcome::Fitted) << result.Message;
  EXPECT_EQ(result.Details.Crossings, 0);
  EXPECT_EQ(result.Details.IrregularPercent, 0.0);
  EXPECT_GT(result.Dice, 0.97);
}

INSTANTIATE_TEST_SUITE_P(Real, SurfaceOfAZone,
                         testing::Values("10000_1000000", "10001_1000001", "10004_1000004",
                                         "10005_1000005", "10012_1000012"));
} // namespace
} // namespace palpate::surface_models_test
