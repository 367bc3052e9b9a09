#include "vtkSphericalHarmonicPhantom.h"

#include "ProstateLikeModel.h"
#include "SphereQuadrature.h"
#include "SphericalHarmonicMeasures.h"

#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkTestErrorObserver.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace
{
using palpate::Vector3;

const Vector3 TestCenter(12.3, -45.6, 78.9);

palpate::SphericalHarmonicModel TestModel(std::uint64_t seed = 3)
{
  return palpate::MakeProstateLikeModel(8, seed, TestCenter);
}

// A grid of cubic voxels, about 64 mm wide, around the test model, rotated about an oblique axis.
void PrepareOblique(vtkSphericalHarmonicPhantom& phantom, double spacing, double degrees)
{
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> direction =
      Eigen::AngleAxisd(degrees * M_PI / 180.0, Vector3(1, 2, -1).normalized()).toRotationMatrix();
  const int count = static_cast<int>(std::ceil(64.0 / spacing));
  phantom.SetDirectionMatrix(direction.data());
  phantom.SetSpacing(spacing, spacing, spacing);
  phantom.SetDimensions(count, count, count);
  phantom.CenterGridOn(TestCenter.x(), TestCenter.y(), TestCenter.z());
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

std::vector<float> Intensities(vtkSphericalHarmonicPhantom& phantom)
{
  phantom.Update();
  const auto* first = static_cast<const float*>(phantom.GetOutput(0)->GetScalarPointer());
  return {first, first + VoxelCount(phantom.GetOutput(0))};
}

std::vector<unsigned char> MaskOf(vtkSphericalHarmonicPhantom& phantom)
{
  phantom.Update();
  const auto* first = static_cast<const unsigned char*>(phantom.GetOutput(1)->GetScalarPointer());
  return {first, first + VoxelCount(phantom.GetOutput(1))};
}

Vector3 VoxelWorld(vtkImageData* image, vtkIdType voxel)
{
  double point[3];
  image->GetPoint(voxel, point); // honours the direction matrix
  return Vector3(point);
}

Vector3 Centroid(const palpate::SphericalHarmonicModel& model)
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
} // namespace

TEST(SphericalHarmonicPhantom, MaskVolumeConvergesToModelVolume)
{
  const palpate::SphericalHarmonicModel model = TestModel();
  for (const double spacing : {4.0, 2.0, 1.0, 0.5})
  {
    vtkNew<vtkSphericalHarmonicPhantom> phantom;
    phantom->SetModel(model);
    PrepareOblique(*phantom, spacing, 25.0);
    const std::vector<unsigned char> mask = MaskOf(*phantom);
    const auto inside = static_cast<double>(std::count(mask.begin(), mask.end(), 1));
    // Five standard deviations of counting.
    EXPECT_NEAR(inside * std::pow(spacing, 3), VolumeOf(model),
                5.0 * CountingDeviation(AreaOf(model), spacing))
        << "spacing " << spacing;
  }
}

TEST(SphericalHarmonicPhantom, MaskHoldsVoxelsWithCentreInside)
{
  const palpate::SphericalHarmonicModel model = TestModel();
  vtkNew<vtkSphericalHarmonicPhantom> phantom;
  phantom->SetModel(model);
  PrepareOblique(*phantom, 2.0, 40.0);
  const std::vector<unsigned char> mask = MaskOf(*phantom);
  for (std::size_t v = 0; v < mask.size(); ++v)
  {
    const Vector3 offset =
        VoxelWorld(phantom->GetOutput(1), static_cast<vtkIdType>(v)) - model.CenterWorld();
    const double depth = model.Radius(offset.normalized()) - offset.norm();
    // Closer to the surface than 1e-9 mm, rounding may decide.
    if (std::abs(depth) > 1e-9)
    {
      ASSERT_EQ(mask[v] == 1, depth > 0.0) << "voxel " << v;
    }
  }
}

TEST(SphericalHarmonicPhantom, MaskIsAtModelCentreOnObliqueGrids)
{
  for (const double degrees : {0.0, 17.0, 90.0, 133.0})
  {
    const palpate::SphericalHarmonicModel model = TestModel();
    vtkNew<vtkSphericalHarmonicPhantom> phantom;
    phantom->SetModel(model);
    PrepareOblique(*phantom, 1.0, degrees);
    const std::vector<unsigned char> mask = MaskOf(*phantom);
    Vector3 sum = Vector3::Zero();
    double count = 0.0;
    for (std::size_t v = 0; v < mask.size(); ++v)
    {
      if (mask[v])
      {
        sum += VoxelWorld(phantom->GetOutput(1), static_cast<vtkIdType>(v));
        count += 1.0;
      }
    }
    // Counting errors lie at most 30 mm from the centre: 30 * deviation / volume is 0.02 mm; five
    // of those are allowed.
    EXPECT_LT((sum / count - Centroid(model)).norm(), 0.1) << degrees << " degrees";
  }
}

TEST(SphericalHarmonicPhantom, PartialVolumesSumToModelVolume)
{
  const palpate::SphericalHarmonicModel model = TestModel();
  vtkNew<vtkSphericalHarmonicPhantom> phantom;
  phantom->SetModel(model);
  phantom->SetAppearance(OneInsideZeroOutside());
  PrepareOblique(*phantom, 2.0, 25.0);
  const std::vector<float> fractions = Intensities(*phantom);
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

TEST(SphericalHarmonicPhantom, SkippingPureVoxelsChangesNothing)
{
  // Slow reference: every voxel subdivided, on an anisotropic grid with strong bumps.
  palpate::SphericalHarmonicModel model = palpate::MakeProstateLikeModel(8, 11, TestCenter);
  vtkNew<vtkSphericalHarmonicPhantom> phantom;
  phantom->SetModel(model);
  palpate::PhantomAppearance look;
  look.Subdivision = 3;
  phantom->SetAppearance(look);
  PrepareOblique(*phantom, 2.0, 33.0);
  phantom->SetSpacing(2.0, 1.5, 4.0);
  phantom->SetDimensions(30, 40, 16);
  phantom->CenterGridOn(TestCenter.x(), TestCenter.y(), TestCenter.z());
  const std::vector<float> fast = Intensities(*phantom);
  const double* d = phantom->GetDirectionMatrix();
  const double* s = phantom->GetSpacing();
  Eigen::Matrix3d step;
  step << d[0] * s[0], d[1] * s[1], d[2] * s[2], d[3] * s[0], d[4] * s[1], d[5] * s[2], d[6] * s[0],
      d[7] * s[1], d[8] * s[2];
  for (std::size_t v = 0; v < fast.size(); ++v)
  {
    const Vector3 center = VoxelWorld(phantom->GetOutput(0), static_cast<vtkIdType>(v));
    double sum = 0.0;
    for (int part = 0; part < 27; ++part)
    {
      const int row = part / 3 % 3;
      const int slice = part / 9;
      const Vector3 shift = Vector3(part % 3 - 1, row - 1, slice - 1) / 3.0;
      const Vector3 offset = center + step * shift - TestCenter;
      const double distance = offset.norm();
      const double radius = model.Radius(offset.normalized());
      sum += distance > radius                             ? look.Background
             : distance > radius - look.CapsuleThickness   ? look.Capsule
             : distance <= look.InnerZoneFraction * radius ? look.InnerZone
                                                           : look.Body;
    }
    // Rounding only: a float near 220 has a resolution of 1.5e-5.
    ASSERT_NEAR(fast[v], sum / 27.0, 2e-5) << "voxel " << v;
  }
}

TEST(SphericalHarmonicPhantom, IntensityIsExactAwayFromBoundaries)
{
  const palpate::SphericalHarmonicModel model = TestModel();
  const palpate::PhantomAppearance look;
  vtkNew<vtkSphericalHarmonicPhantom> phantom;
  phantom->SetModel(model);
  PrepareOblique(*phantom, 1.0, 25.0);
  const std::vector<float> values = Intensities(*phantom);
  int innerCount = 0;
  int bodyCount = 0;
  int backgroundCount = 0;
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    const Vector3 offset =
        VoxelWorld(phantom->GetOutput(0), static_cast<vtkIdType>(v)) - model.CenterWorld();
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

TEST(SphericalHarmonicPhantom, BitsAreIndependentOfThreads)
{
  const auto make = [](unsigned int seed, const char* backend, int threads)
  {
    vtkNew<vtkSphericalHarmonicPhantom> phantom;
    PrepareOblique(*phantom, 2.0, 10.0);
    phantom->SetNoiseDeviation(15.0);
    phantom->SetBiasAmplitude(0.3);
    phantom->SetAppearanceSeed(seed);
    std::vector<float> values;
    vtkSMPTools::LocalScope(vtkSMPTools::Config{threads, backend, false},
                            [&]() { values = Intensities(*phantom); });
    return values;
  };
  const std::vector<float> reference = make(7, "Sequential", 1);
  EXPECT_EQ(make(7, "STDThread", 4), reference);
  EXPECT_EQ(make(7, "STDThread", 3), reference);
  EXPECT_NE(make(8, "Sequential", 1), reference);
}

TEST(SphericalHarmonicPhantom, RicianBackgroundHasRayleighMean)
{
  constexpr double Deviation = 10.0;
  vtkNew<vtkSphericalHarmonicPhantom> phantom;
  phantom->SetModel(TestModel());
  palpate::PhantomAppearance look;
  look.Background = 0.0;
  look.NoiseDeviation = Deviation;
  phantom->SetAppearance(look);
  PrepareOblique(*phantom, 1.0, 0.0);
  const std::vector<float> values = Intensities(*phantom);
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    const Vector3 point = VoxelWorld(phantom->GetOutput(0), static_cast<vtkIdType>(v));
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

TEST(SphericalHarmonicPhantom, GaussianNoiseHasGivenDeviation)
{
  constexpr double Deviation = 12.0;
  vtkNew<vtkSphericalHarmonicPhantom> phantom;
  PrepareOblique(*phantom, 2.0, 0.0);
  palpate::PhantomAppearance look;
  look.NoiseKind = palpate::PhantomAppearance::Noise::Gaussian;
  phantom->SetAppearance(look);
  const std::vector<float> clean = Intensities(*phantom);
  look.NoiseDeviation = Deviation;
  phantom->SetAppearance(look);
  const std::vector<float> noisy = Intensities(*phantom);
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

TEST(SphericalHarmonicPhantom, NoiseIsUncorrelatedBetweenVoxels)
{
  vtkNew<vtkSphericalHarmonicPhantom> phantom;
  PrepareOblique(*phantom, 2.0, 0.0);
  palpate::PhantomAppearance look;
  look.NoiseKind = palpate::PhantomAppearance::Noise::Gaussian;
  phantom->SetAppearance(look);
  const std::vector<float> clean = Intensities(*phantom);
  look.NoiseDeviation = 1.0;
  phantom->SetAppearance(look);
  const std::vector<float> noisy = Intensities(*phantom);
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

TEST(SphericalHarmonicPhantom, BiasFieldVariesWithinAmplitude)
{
  constexpr double Amplitude = 0.4;
  vtkNew<vtkSphericalHarmonicPhantom> phantom;
  PrepareOblique(*phantom, 2.0, 0.0);
  const std::vector<float> clean = Intensities(*phantom);
  phantom->SetBiasAmplitude(Amplitude);
  const std::vector<float> biased = Intensities(*phantom);
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

TEST(SphericalHarmonicPhantom, OutputsCarryDirectionMatrix)
{
  vtkNew<vtkSphericalHarmonicPhantom> phantom;
  PrepareOblique(*phantom, 4.0, 25.0);
  phantom->Update();
  for (int port = 0; port < 2; ++port)
  {
    for (int e = 0; e < 9; ++e)
    {
      EXPECT_EQ(phantom->GetOutput(port)->GetDirectionMatrix()->GetData()[e],
                phantom->GetDirectionMatrix()[e]);
    }
  }
}

TEST(SphericalHarmonicPhantom, RaisesErrorForInvalidSettings)
{
  const auto message = [](const auto& spoil)
  {
    vtkNew<vtkSphericalHarmonicPhantom> phantom;
    vtkNew<vtkTest::ErrorObserver> observer;
    phantom->AddObserver(vtkCommand::ErrorEvent, observer);
    phantom->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
    phantom->SetDimensions(8, 8, 8);
    spoil(*phantom);
    phantom->Update();
    return observer->GetErrorMessage();
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Phantom = vtkSphericalHarmonicPhantom;
  EXPECT_NE(message([](Phantom& p) { p.SetSpacing(1, -1, 1); }).find("spacing"), std::string::npos);
  EXPECT_NE(message([&](Phantom& p) { p.SetSpacing(1, nan, 1); }).find("spacing"),
            std::string::npos);
  const double sheared[9] = {1, 0.2, 0, 0, 1, 0, 0, 0, 1};
  EXPECT_NE(message([&](Phantom& p) { p.SetDirectionMatrix(sheared); }).find("orthonormal"),
            std::string::npos);
  EXPECT_NE(message([](Phantom& p) { p.SetBiasAmplitude(1.0); }).find("bias"), std::string::npos);
  EXPECT_NE(message([&](Phantom& p) { p.SetNoiseDeviation(nan); }).find("noise"),
            std::string::npos);
}
