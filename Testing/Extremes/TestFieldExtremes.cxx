// Rays, inside tests and touch on fields with extreme values that a scanner or a file can contain.
#include "FieldContactCases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <sstream>

namespace palpate::field_extremes_test
{
namespace
{
using test::At;

template <typename T>
class EverySampleType : public ::testing::Test
{
};
using SampleTypes =
    ::testing::Types<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t,
                     std::uint32_t, std::int64_t, std::uint64_t, float, double>;
TYPED_TEST_SUITE(EverySampleType, SampleTypes);

constexpr int Nodes = 12;

// The lower half along k has one value, the nodes from `first` on the other.
template <typename T>
std::vector<T> Step(T below, T above, int first)
{
  std::vector<T> samples(static_cast<std::size_t>(Nodes * Nodes * Nodes), below);
  std::fill(samples.begin() + static_cast<std::ptrdiff_t>(first) * Nodes * Nodes, samples.end(),
            above);
  return samples;
}

// Rays, inside tests and a point's proxy at the plane k = height, material above it.
void ExpectPlaneAt(const std::shared_ptr<const ScalarField>& field, double height)
{
  const RayCaster caster(field);
  const FieldSampler sampler(field);
  const Vector3 below(5.3, 4.6, 0.5);
  const FieldHit hit = caster.CastWorld({below, Vector3::UnitZ()}, 0.0, 20.0);
  ASSERT_EQ(hit.Kind, HitKind::Surface);
  EXPECT_TRUE(hit.IsEntering);
  EXPECT_NEAR(hit.Position[2], height, 1e-12); // roundings of an index of 12
  EXPECT_TRUE(hit.Gradient.normalized().isApprox(Vector3::UnitZ(), 1e-12));
  EXPECT_FALSE(sampler.IsInsideWorld(0, {5.3, 4.6, height - 1e-9}));
  EXPECT_TRUE(sampler.IsInsideWorld(0, {5.3, 4.6, height + 1e-9}));

  const auto contact = test::FieldContact(field);
  const auto tracker = test::TrackerOf(*contact, ToolShape::Sphere(0.0));
  tracker->Follow(At(below));
  const Vector3 within(5.3, 4.6, height + 0.25);
  const Contact& felt = tracker->Follow(At(within));
  ASSERT_TRUE(felt.IsValid);
  EXPECT_TRUE(felt.IsTouching);
  EXPECT_NEAR(felt.Depth, 0.25, 1e-3); // the tracker's tolerance: 1e-3 of a voxel
  EXPECT_LE((felt.NormalWorld + Vector3::UnitZ()).norm(), 1e-9);
}

const FieldGrid Cube = test::PlainGrid({Nodes, Nodes, Nodes});

void ExpectPlaneAt(const FieldSamples& samples, double iso, double height)
{
  FieldBuilder builder(Cube);
  builder.AddMaterial({builder.AddChannel(samples), iso});
  std::shared_ptr<const ScalarField> field;
  const Status status = builder.Build(field);
  ASSERT_TRUE(status.IsOk()) << status.Message();
  ExpectPlaneAt(field, height);
}

void ExpectRefusedAsConstant(const FieldSamples& samples, double value)
{
  std::ostringstream range;
  range << "from " << value << " to " << value;
  for (const FieldSense sense : {FieldSense::AtLeast, FieldSense::AtMost})
  {
    for (const double iso : {value, 0.5 * value + 1.0})
    {
      FieldBuilder builder(Cube);
      builder.AddMaterial({builder.AddChannel(samples), iso, sense});
      const std::string refusal = test::RefusalOf(builder);
      EXPECT_NE(refusal.find(range.str()), std::string::npos) << refusal;
    }
  }
}

// The range of double that a field accepts.
template <typename T>
T HighestValue()
{
  return std::is_same_v<T, double> ? static_cast<T>(1e140) : std::numeric_limits<T>::max();
}
template <typename T>
T LowestValue()
{
  return std::is_same_v<T, double> ? static_cast<T>(-1e140) : std::numeric_limits<T>::lowest();
}

TYPED_TEST(EverySampleType, SupportsItsWholeRange)
{
  const auto samples = Step(LowestValue<TypeParam>(), HighestValue<TypeParam>(), 6);
  const auto lowest = static_cast<double>(samples.front());
  const auto highest = static_cast<double>(samples.back());
  const FieldSamples given = SamplesOfGrid(samples.data(), Cube);
  ExpectPlaneAt(given, 0.5 * lowest + 0.5 * highest, 5.5);
  // At the type's own limit the iso-value is inside: the surface is where the limit is reached.
  ExpectPlaneAt(given, highest, 6.0);
}

TYPED_TEST(EverySampleType, RejectsConstantVolumeNamingItsValue)
{
  for (const TypeParam value : {LowestValue<TypeParam>(), HighestValue<TypeParam>(), TypeParam(7)})
  {
    const std::vector<TypeParam> samples = Step(value, value, 6);
    ExpectRefusedAsConstant(SamplesOfGrid(samples.data(), Cube), static_cast<double>(value));
  }
}

// The iso-value exactly at a layer of nodes, between other values and as a plateau above it.
TYPED_TEST(EverySampleType, IsoValueExactlyOnVoxelsIsTheSurface)
{
  std::vector<TypeParam> ramp;
  for (int k = 0; k < Nodes; ++k)
  {
    ramp.insert(ramp.end(), static_cast<std::size_t>(Nodes * Nodes), static_cast<TypeParam>(3 * k));
  }
  ExpectPlaneAt(SamplesOfGrid(ramp.data(), Cube), 15.0, 5.0);
  const auto plateau = Step(TypeParam(0), TypeParam(15), 5);
  ExpectPlaneAt(SamplesOfGrid(plateau.data(), Cube), 15.0, 5.0);
}

// One layer of voxels of value 1 between zeros is as thick as the iso-value makes it.
std::shared_ptr<const ScalarField> Layer(double iso)
{
  std::vector<float> samples = Step(0.0F, 0.0F, 0);
  std::fill(samples.begin() + 5 * Nodes * Nodes, samples.begin() + 6 * Nodes * Nodes, 1.0F);
  return test::MakeField(Cube, samples, iso);
}

// Farthest place (voxels) of a point's proxy that is pushed through the layer at 5.
double FarthestProxy(const std::shared_ptr<const ScalarField>& field)
{
  const auto tracker = test::TrackerOf(*test::FieldContact(field), ToolShape::Sphere(0.0));
  const Vector3 start(5.3, 4.6, 2.0);
  tracker->Follow(At(start));
  double farthest = 0.0;
  test::MoveStraight(*tracker, start, {5.3, 4.6, 9.0}, 0.1,
                     [&farthest](const Vector3&, const Contact& felt)
                     {
                       ASSERT_TRUE(felt.IsValid && felt.ProxyWorld.allFinite());
                       farthest = std::max(farthest, felt.ProxyWorld[2]);
                     });
  return farthest;
}

TEST(FieldExtremes, HalfVoxelWallIsTouchedAndZeroThicknessWallOnlyHit)
{
  EXPECT_LE(FarthestProxy(Layer(0.75)), 4.75 + 1e-3); // tolerance: 1e-3 of a voxel
  // The layer only just reaches the iso-value.
  const auto field = Layer(1.0);
  const FieldHit hit = RayCaster(field).CastWorld({{5.3, 4.6, 0.5}, Vector3::UnitZ()}, 0.0, 20.0);
  EXPECT_EQ(hit.Kind, HitKind::Surface);
  EXPECT_EQ(hit.Position[2], 5.0);
  EXPECT_TRUE(FieldSampler(field).IsInsideWorld(0, {5.3, 4.6, 5.0}));
  EXPECT_EQ(FarthestProxy(field), 9.0);
}

TEST(FieldExtremes, RejectsDenormalAndHugeDoubles)
{
  using Limits = std::numeric_limits<double>;
  for (const auto& [below, above] :
       {std::pair(0.0, Limits::denorm_min()), {0.0, 1e-310}, {Limits::lowest(), Limits::max()}})
  {
    const std::vector<double> samples = Step(below, above, 6);
    FieldBuilder builder(Cube);
    builder.AddMaterial({builder.AddChannel(SamplesOfGrid(samples.data(), Cube)), above});
    EXPECT_NE(test::RefusalOf(builder).find("rescale"), std::string::npos);
  }
}

// Denormal floats are ordinary doubles.
TEST(FieldExtremes, SupportsDenormalFloats)
{
  const auto samples = Step(0.0F, 2.0F * std::numeric_limits<float>::denorm_min(), 6);
  const double iso = static_cast<double>(std::numeric_limits<float>::denorm_min());
  ExpectPlaneAt(test::MakeField(Cube, samples, iso), 5.5);
}

TEST(FieldExtremes, BSplineRejectsValuesBeyondItsFloats)
{
  const auto refusal = [](float above)
  {
    const std::vector<float> samples = Step(-above, above, 6);
    FieldBuilder builder(Cube);
    builder.AddMaterial({builder.AddChannel(SamplesOfGrid(samples.data(), Cube)), 0.0});
    builder.SetInterpolation(FieldInterpolation::TricubicBSpline);
    return test::RefusalOf(builder);
  };
  EXPECT_NE(refusal(std::numeric_limits<float>::max()).find("rescale"), std::string::npos);
  EXPECT_NE(refusal(std::numeric_limits<float>::denorm_min()).find("rescale"), std::string::npos);
  for (const float size : {1e-29F, 1e35F})
  {
    const std::vector<float> samples = Step(-size, size, 6);
    const auto field = test::MakeField(Cube, samples, 0.0, FieldInterpolation::TricubicBSpline);
    const FieldHit hit = RayCaster(field).CastWorld({{5.3, 4.6, 0.5}, Vector3::UnitZ()}, 0.0, 20.0);
    EXPECT_NEAR(hit.Position[2], 5.5, 1e-5); // coefficients in float; half way by symmetry
  }
}
} // namespace
} // namespace palpate::field_extremes_test
