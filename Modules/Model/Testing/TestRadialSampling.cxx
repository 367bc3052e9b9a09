#include "RadialSampling.h"

#include "MeshShapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace palpate::radial_sampling_test
{
namespace
{
TEST(RadialSampling, RadiiAndWeightsAreThoseOfASphere)
{
  const IndexedMesh mesh = test::Sphere(40, 10.0, {3.0, 0.0, 0.0});
  const RadialSamples samples =
      SamplesOf(SampleRadially(mesh, Vector3::Zero(), 10, {}), RadialWeight::Area);
  ASSERT_EQ(samples.Radii.size(), 1002U);
  for (std::size_t i = 0; i < samples.Radii.size(); ++i)
  {
    const Vector3 point = samples.Radii[i] * samples.Directions[i];
    EXPECT_NEAR((point - Vector3(3.0, 0.0, 0.0)).norm(), 10.0, 0.01) << "chords lie inside";
  }
  // solid angle * r^2 * cos^2 instead of / cos: a cosine of the incidence for the slope of the
  // sample, another for its use as a radius.
  const double weight = std::accumulate(samples.Weights.begin(), samples.Weights.end(), 0.0);
  EXPECT_GT(weight, 0.9 * 400.0 * M_PI);
  EXPECT_LT(weight, 400.0 * M_PI);
}

TEST(RadialSampling, DirectionsThatMissTheMeshAreLeftOut)
{
  const IndexedMesh mesh = test::Sphere(10, 1.0, {2.0, 0.0, 0.0});
  const RadialSamples samples =
      SamplesOf(SampleRadially(mesh, Vector3::Zero(), 10, {}), RadialWeight::Area);
  // A sphere of radius 1 at 2 covers (1 - cos 30 degrees) / 2 of the directions.
  EXPECT_NEAR(samples.Radii.size() / 1002.0, 0.067, 0.01);
}
} // namespace
} // namespace palpate::radial_sampling_test
