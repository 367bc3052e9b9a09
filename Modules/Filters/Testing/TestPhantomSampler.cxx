#include "PhantomSampler.h"

#include "ModelMeasures.h"
#include "ProstateLikeModel.h"
#include "SphereQuadrature.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkSMPTools.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>
#include <vector>

namespace palpate::phantom_sampler_test
{
namespace
{
const Vector3 TestCenter(12.3, -45.6, 78.9);

palpate::RadialModel TestModel(std::uint64_t seed = 3)
{
  return palpate::MakeProstateLikeModel(8, seed, TestCenter);
}

// A grid of cubic voxels, about 64 mm wide, around the test model, rotated about an oblique axis.
PhantomGrid ObliqueGrid(double spacing, double degrees)
{
  const int count = static_cast<int>(std::ceil(64.0 / spacing));
  PhantomGrid grid;
  grid.Size = {count, count, count};
  grid.Spacing.setConstant(spacing);
  grid.Direction =
      Eigen::AngleAxisd(degrees * M_PI / 180.0, Vector3(1, 2, -1).normalized()).toRotationMatrix();
  grid.CenterOn(TestCenter);
  return grid;
}

palpate::PhantomAppearance OneInsideZeroOutside()
{
  palpate::PhantomAppearance look;
  look.Background = 0.0;
  look.Body = look.Capsule = look.InnerZone = 1.0;
  return look;
}

vtkIdType VoxelCount(vtkImageData* image)
{
  return image->GetNumberOfPoints();
}

std::vector<float> Intensities(const PhantomImages& phantom)
{
  const auto* first = static_cast<const float*>(phantom.Volume->GetScalarPointer());
  return {first, first + VoxelCount(phantom.Volume)};
}

std::vector<unsigned char> MaskOf(const PhantomImages& phantom)
{
  const auto* first = static_cast<const unsigned char*>(phantom.Mask->GetScalarPointer());
  return {first, first + VoxelCount(phantom.Mask)};
}

Vector3 VoxelWorld(vtkImageData* image, vtkIdType voxel)
{
  double point[3];
  image->GetPoint(voxel, point); // honours the direction matrix
  return Vector3(point);
}

Vector3 Centroid(const palpate::RadialModel& model)
{
  const palpate::SphereQuadrature sphere(4 * model.Degree() + 1);
  Vector3 moment = Vector3::Zero();
  for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
  {
    const double radius = model.Radius(sphere.Directions[i]);
    moment += sphere.Weights[i] * std::pow(radius, 4) / 4.0 * sphere.Directions[i];
  }
  return model.CenterWorld() + moment / VolumeOf(model);
}

// Standard deviation (mm^3) of a volume counted by points h apart: about Area / h^2 cells are cut,
// each with an error of h^3 / sqrt(12) if the cuts are evenly distributed.
double CountingDeviation(double areaSquareMillimeters, double spacing)
{
  return spacing * spacing * std::sqrt(areaSquareMillimeters / 12.0);
}

TEST(Phantom, MaskVolumeConvergesToModelVolume)
{
  const palpate::RadialModel model = TestModel();
  for (const double spacing : {4.0, 2.0, 1.0, 0.5})
  {
    const PhantomImages phantom = MakePhantom(model, ObliqueGrid(spacing, 25.0));
    const std::vector<unsigned char> mask = MaskOf(phantom);
    const auto inside = static_cast<double>(std::count(mask.begin(), mask.end(), 1));
    // Five standard deviations of counting.
    EXPECT_NEAR(inside * std::pow(spacing, 3), VolumeOf(model),
                5.0 * CountingDeviation(AreaOf(model), spacing))
        << "spacing " << spacing;
  }
}

TEST(Phantom, MaskHoldsVoxelsWithCentreInside)
{
  const palpate::RadialModel model = TestModel();
  const PhantomImages phantom = MakePhantom(model, ObliqueGrid(2.0, 40.0));
  const std::vector<unsigned char> mask = MaskOf(phantom);
  for (std::size_t v = 0; v < mask.size(); ++v)
  {
    const Vector3 offset =
        VoxelWorld(phantom.Mask, static_cast<vtkIdType>(v)) - model.CenterWorld();
    const double depth = model.Radius(offset.normalized()) - offset.norm();
    // Closer to the surface than 1e-9 mm, rounding may decide.
    if (std::abs(depth) > 1e-9)
    {
      ASSERT_EQ(mask[v] == 1, depth > 0.0) << "voxel " << v;
    }
  }
}

TEST(Phantom, MaskIsAtModelCentreOnObliqueGrids)
{
  for (const double degrees : {0.0, 17.0, 90.0, 133.0})
  {
    const palpate::RadialModel model = TestModel();
    const PhantomImages phantom = MakePhantom(model, ObliqueGrid(1.0, degrees));
    const std::vector<unsigned char> mask = MaskOf(phantom);
    Vector3 sum = Vector3::Zero();
    double count = 0.0;
    for (std::size_t v = 0; v < mask.size(); ++v)
    {
      if (mask[v])
      {
        sum += VoxelWorld(phantom.Mask, static_cast<vtkIdType>(v));
        count += 1.0;
      }
    }
    // Counting errors lie at most 30 mm from the centre: 30 * deviation / volume is 0.02 mm; five
    // of those are allowed.
    EXPECT_LT((sum / count - Centroid(model)).norm(), 0.1) << degrees << " degrees";
  }
}

TEST(Phantom, PartialVolumesSumToModelVolume)
{
  const palpate::RadialModel model = TestModel();
  const std::vector<float> fractions =
      Intensities(MakePhantom(model, ObliqueGrid(2.0, 25.0), OneInsideZeroOutside()));
  double sum = 0.0;
  for (const float fraction : fractions)
  {
    ASSERT_GE(fraction, 0.0F);
    ASSERT_LE(fraction, 1.0F);
    sum += fraction;
  }
  // A 2 mm voxel is averaged over points 0.5 mm apart: five standard deviations of that count.
  EXPECT_NEAR(sum * 8.0, VolumeOf(model), 5.0 * CountingDeviation(AreaOf(model), 0.5));
}

TEST(Phantom, SkippingPureVoxelsChangesNothing)
{
  // Slow reference: every voxel subdivided, on an anisotropic grid with strong bumps.
  palpate::RadialModel model = palpate::MakeProstateLikeModel(8, 11, TestCenter);
  palpate::PhantomAppearance look;
  look.Subdivision = 3;
  look.Nodule.emplace();
  ASSERT_TRUE(palpate::PhantomNodule::Place(model, 9.0, 2.5, *look.Nodule).IsOk());
  PhantomGrid grid = ObliqueGrid(2.0, 33.0);
  grid.Spacing = {2.0, 1.5, 4.0};
  grid.Size = {30, 40, 16};
  grid.CenterOn(TestCenter);
  const PhantomImages phantom = MakePhantom(model, grid, look);
  const std::vector<float> fast = Intensities(phantom);
  const Eigen::Matrix3d step = grid.Direction * grid.Spacing.asDiagonal();
  for (std::size_t v = 0; v < fast.size(); ++v)
  {
    const Vector3 center = VoxelWorld(phantom.Volume, static_cast<vtkIdType>(v));
    double sum = 0.0;
    for (int part = 0; part < 27; ++part)
    {
      const int row = part / 3 % 3;
      const int slice = part / 9;
      const Vector3 shift = Vector3(part % 3 - 1, row - 1, slice - 1) / 3.0;
      const Vector3 offset = center + step * shift - TestCenter;
      const double distance = offset.norm();
      const double radius = model.Radius(offset.normalized());
      sum += look.Nodule->Contains(offset)                 ? look.NoduleIntensity
             : distance > radius                           ? look.Background
             : distance > radius - look.CapsuleThickness   ? look.Capsule
             : distance <= look.InnerZoneFraction * radius ? look.InnerZone
                                                           : look.Body;
    }
    // Rounding only: a float near 220 has a resolution of 1.5e-5.
    ASSERT_NEAR(fast[v], sum / 27.0, 2e-5) << "voxel " << v;
  }
}

TEST(Phantom, IntensityIsExactAwayFromBoundaries)
{
  const palpate::RadialModel model = TestModel();
  const palpate::PhantomAppearance look;
  const PhantomImages phantom = MakePhantom(model, ObliqueGrid(1.0, 25.0), look);
  const std::vector<float> values = Intensities(phantom);
  int innerCount = 0;
  int bodyCount = 0;
  int backgroundCount = 0;
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    const Vector3 offset =
        VoxelWorld(phantom.Volume, static_cast<vtkIdType>(v)) - model.CenterWorld();
    const double radius = model.Radius(offset.normalized());
    // 2 mm along the radius is more than half a voxel diagonal from any boundary.
    if (offset.norm() < look.InnerZoneFraction * radius - 2.0)
    {
      ASSERT_EQ(values[v], static_cast<float>(look.InnerZone));
      ++innerCount;
    }
    else if (offset.norm() > look.InnerZoneFraction * radius + 2.0 &&
             offset.norm() < radius - look.CapsuleThickness - 2.0)
    {
      ASSERT_EQ(values[v], static_cast<float>(look.Body));
      ++bodyCount;
    }
    else if (offset.norm() > radius + 2.0)
    {
      ASSERT_EQ(values[v], static_cast<float>(look.Background));
      ++backgroundCount;
    }
  }
  EXPECT_GT(std::min({innerCount, bodyCount, backgroundCount}), 1000);
}

TEST(Phantom, BitsAreIndependentOfThreads)
{
  const auto make = [](unsigned int seed, const char* backend, int threads)
  {
    palpate::PhantomAppearance look;
    look.NoiseDeviation = 15.0;
    look.BiasAmplitude = 0.3;
    look.Seed = seed;
    std::vector<float> values;
    vtkSMPTools::LocalScope(
        vtkSMPTools::Config{threads, backend, false},
        [&]() { values = Intensities(MakePhantom(TestModel(), ObliqueGrid(2.0, 10.0), look)); });
    return values;
  };
  const std::vector<float> reference = make(7, "Sequential", 1);
  EXPECT_EQ(make(7, "STDThread", 4), reference);
  EXPECT_EQ(make(7, "STDThread", 3), reference);
  EXPECT_NE(make(8, "Sequential", 1), reference);
}

TEST(Phantom, RicianBackgroundHasRayleighMean)
{
  constexpr double Deviation = 10.0;
  palpate::PhantomAppearance look;
  look.Background = 0.0;
  look.NoiseDeviation = Deviation;
  const PhantomImages phantom = MakePhantom(TestModel(), ObliqueGrid(1.0, 0.0), look);
  const std::vector<float> values = Intensities(phantom);
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    const Vector3 point = VoxelWorld(phantom.Volume, static_cast<vtkIdType>(v));
    if ((point - TestCenter).norm() > 30.0)
    {
      sum += values[v];
      count += 1.0;
    }
  }
  ASSERT_GT(count, 1e4);
  // Rayleigh: mean s sqrt(pi/2), deviation s sqrt(2 - pi/2) = 0.655 s; five standard errors.
  EXPECT_NEAR(sum / count, Deviation * std::sqrt(M_PI / 2.0),
              5.0 * 0.655 * Deviation / std::sqrt(count));
}

TEST(Phantom, GaussianNoiseHasGivenDeviation)
{
  constexpr double Deviation = 12.0;
  const PhantomGrid grid = ObliqueGrid(2.0, 0.0);
  palpate::PhantomAppearance look;
  look.NoiseKind = palpate::PhantomAppearance::Noise::Gaussian;
  const std::vector<float> clean = Intensities(MakePhantom(TestModel(), grid, look));
  look.NoiseDeviation = Deviation;
  const std::vector<float> noisy = Intensities(MakePhantom(TestModel(), grid, look));
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t v = 0; v < clean.size(); ++v)
  {
    const double noise = noisy[v] - clean[v];
    sum += noise;
    squares += noise * noise;
  }
  const auto count = static_cast<double>(clean.size());
  // Five standard errors of a mean, and of a deviation (s / sqrt(2 n)).
  EXPECT_NEAR(sum / count, 0.0, 5.0 * Deviation / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), Deviation, 5.0 * Deviation / std::sqrt(2.0 * count));
}

TEST(Phantom, NoiseIsUncorrelatedBetweenVoxels)
{
  const PhantomGrid grid = ObliqueGrid(2.0, 0.0);
  palpate::PhantomAppearance look;
  look.NoiseKind = palpate::PhantomAppearance::Noise::Gaussian;
  const std::vector<float> clean = Intensities(MakePhantom(TestModel(), grid, look));
  look.NoiseDeviation = 1.0;
  const std::vector<float> noisy = Intensities(MakePhantom(TestModel(), grid, look));
  for (const std::size_t step : {1U, 32U, 32U * 32U}) // along a row, a column and a stack
  {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t v = step; v < clean.size(); ++v)
    {
      sum += (noisy[v] - clean[v]) * (noisy[v - step] - clean[v - step]);
      count += 1.0;
    }
    // The mean of products of independent numbers of variance 1: five standard errors.
    EXPECT_NEAR(sum / count, 0.0, 5.0 / std::sqrt(count)) << "step " << step;
  }
}

TEST(Phantom, BiasFieldVariesWithinAmplitude)
{
  constexpr double Amplitude = 0.4;
  const PhantomGrid grid = ObliqueGrid(2.0, 0.0);
  const std::vector<float> clean = Intensities(MakePhantom(TestModel(), grid));
  palpate::PhantomAppearance look;
  look.BiasAmplitude = Amplitude;
  const std::vector<float> biased = Intensities(MakePhantom(TestModel(), grid, look));
  double smallest = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t v = 0; v < clean.size(); ++v)
  {
    const double factor = biased[v] / clean[v];
    smallest = std::min(smallest, factor);
    largest = std::max(largest, factor);
  }
  EXPECT_GE(smallest, 1.0 - Amplitude - 1e-6); // rounding of floats
  EXPECT_LE(largest, 1.0 + Amplitude + 1e-6);
  EXPECT_GT(largest - smallest, 0.5 * Amplitude);
}

TEST(Phantom, ImagesCarryDirectionMatrix)
{
  const PhantomGrid grid = ObliqueGrid(4.0, 25.0);
  const PhantomImages phantom = MakePhantom(TestModel(), grid);
  for (vtkImageData* image : {phantom.Volume.Get(), phantom.Mask.Get()})
  {
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        EXPECT_EQ(image->GetDirectionMatrix()->GetElement(row, column),
                  grid.Direction(row, column));
      }
    }
  }
}

TEST(Phantom, ProgressEndsTheWork)
{
  int calls = 0;
  const auto stop = [&calls](double part)
  {
    ++calls;
    if (part >= 0.5)
    {
      throw std::runtime_error("stopped");
    }
  };
  EXPECT_THROW(MakePhantom(TestModel(), ObliqueGrid(4.0, 0.0), {}, stop), std::runtime_error);
  EXPECT_EQ(calls, 8); // of 16 slices
}
} // namespace
} // namespace palpate::phantom_sampler_test
