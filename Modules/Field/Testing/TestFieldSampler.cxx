#include "DenseReference.h"
#include "FieldCases.h"
#include "FieldSampler.h"
#include "InstructionSets.h"
#include "ProceduralFields.h"
#include "WorstCase.h"

#include <cmath>
#include <limits>

namespace palpate::field_sampler_test
{
namespace
{
using test::MakeField;
using test::NameOf;
using test::PlainGrid;
using test::RunnableInstructionSets;
using test::WorstCase;

constexpr FieldInterpolation Methods[] = {FieldInterpolation::Trilinear,
                                          FieldInterpolation::TricubicBSpline};
const double Infinity = std::numeric_limits<double>::infinity();
const double NaN = std::numeric_limits<double>::quiet_NaN();

Vector3 RandomPoint(const FieldGrid& grid, std::mt19937_64& random)
{
  Vector3 p;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double last = grid.Size()[static_cast<std::size_t>(axis)] - 1;
    const double quarters = std::floor(std::uniform_real_distribution<double>(0, 4 * last)(random));
    // Half of the points lie on faces, edges and nodes.
    p[axis] = random() % 2 == 0 ? std::uniform_real_distribution<double>(0, last)(random)
                                : std::min(last, std::round(quarters / 4));
  }
  return p;
}

TEST(FieldSampler, EqualsTheDenseSamplerOnRandomVolumes)
{
  std::mt19937_64 random(11);
  for (int round = 0; round < 60; ++round)
  {
    const std::array<int, 3> size{2 + static_cast<int>(random() % 22),
                                  2 + static_cast<int>(random() % 12),
                                  2 + static_cast<int>(random() % 19)};
    const FieldGrid grid = test::ObliqueGrid(size, random);
    const std::vector<double> samples = test::RandomSteps(grid, random, 5);
    for (const FieldInterpolation method : Methods)
    {
      const FieldSampler sampler(MakeField(grid, samples, 2.0, method));
      const test::DenseReference reference(size, samples, method);
      // Coefficients are kept in float; they are up to 27 times as large as samples at worst.
      const double tolerance = method == FieldInterpolation::Trilinear ? 1e-14 : 1e-5;
      WorstCase value;
      WorstCase gradient;
      for (int point = 0; point < 100; ++point)
      {
        const Vector3 p = RandomPoint(grid, random);
        const FieldGradientSample sample = sampler.ValueAndGradientIndex(0, p);
        if (sample.Kind != SampleKind::Sampled)
        {
          ASSERT_EQ(sample.Kind, SampleKind::Constant);
          continue;
        }
        value.Add(sample.Value - static_cast<double>(reference.Value(test::ToPoint(p))));
        value.Add(sample.Value - sampler.ValueIndex(0, p).Value);
        const auto expected = reference.Gradient(test::ToPoint(p));
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          gradient.Add(sample.Gradient[static_cast<int>(axis)] -
                       static_cast<double>(expected[axis]));
        }
      }
      EXPECT_LE(value.Value(), tolerance) << "round " << round;
      EXPECT_LE(gradient.Value(), 4 * tolerance) << "round " << round;
    }
  }
}

TEST(FieldSampler, InsideIsWhereTheDenseValueReachesTheIsoValue)
{
  std::mt19937_64 random(12);
  for (int round = 0; round < 60; ++round)
  {
    const FieldGrid grid = PlainGrid({17, 9, 12});
    // Two levels leave whole bricks without a surface only where the volume is nearly constant.
    std::vector<double> samples(grid.NodeCount(), random() % 2 == 0 ? 0.0 : 2.0);
    for (int bump = 0; bump < 40; ++bump)
    {
      samples[random() % samples.size()] = static_cast<double>(random() % 3);
    }
    for (const FieldInterpolation method : Methods)
    {
      const FieldSampler sampler(MakeField(grid, samples, 1.0, method));
      const test::DenseReference reference(grid.Size(), samples, method);
      const double tolerance = method == FieldInterpolation::Trilinear ? 1e-14 : 1e-5;
      for (int point = 0; point < 200; ++point)
      {
        const Vector3 p = RandomPoint(grid, random);
        const auto excess = static_cast<double>(reference.Value(test::ToPoint(p)) - 1);
        const bool isInside = sampler.IsInsideIndex(0, p);
        ASSERT_TRUE(std::abs(excess) <= tolerance || isInside == (excess >= 0))
            << "round " << round << " at " << p.transpose() << ": " << excess;
      }
    }
  }
}

TEST(FieldSampler, IsoValueIsInsideAtNodesAndInConstantRegions)
{
  const FieldGrid grid = PlainGrid({20, 4, 4});
  std::vector<std::int16_t> samples(grid.NodeCount(), 300);
  samples[0] = 299;
  const FieldSampler sampler(MakeField(grid, samples, 300.0));
  for (const double x : {1.0, 1.3, 7.7, 8.0, 8.1, 19.0})
  {
    EXPECT_TRUE(sampler.IsInsideIndex(0, {x, 1.1, 2.9})) << x;
  }
  EXPECT_FALSE(sampler.IsInsideIndex(0, {0, 0, 0}));
  EXPECT_FALSE(sampler.IsInsideIndex(0, {0.999, 0, 0}));
  EXPECT_TRUE(sampler.IsInsideIndex(0, {1, 0, 0}));
}

TEST(FieldSampler, ReportsPointsOutsideTheGrid)
{
  std::mt19937_64 random(13);
  const FieldGrid grid = test::ObliqueGrid({5, 6, 7}, random);
  const std::vector<double> samples =
      test::SampleAtIndices(grid.Size(), test::PlaneField{{1, 0, 0}, 0.0});
  for (const FieldInterpolation method : Methods)
  {
    const FieldSampler sampler(MakeField(grid, samples, 1.0, method));
    EXPECT_EQ(sampler.ValueIndex(0, {4, 5, 6}).Kind, SampleKind::Sampled);
    EXPECT_EQ(sampler.ValueIndex(0, {0, 0, 0}).Kind, SampleKind::Sampled);
    for (const Vector3& p :
         {Vector3(4.0000001, 5, 6), Vector3(4, 5, 6.0000001), Vector3(-1e-300, 0, 0),
          Vector3(2, -1, 2), Vector3(NaN, 2, 2), Vector3(2, 2, Infinity), Vector3(2, -Infinity, 2),
          Vector3(1e300, 2, 2)})
    {
      EXPECT_EQ(sampler.ValueIndex(0, p).Kind, SampleKind::Outside) << p.transpose();
      EXPECT_EQ(sampler.ValueAndGradientIndex(0, p).Kind, SampleKind::Outside);
      EXPECT_FALSE(sampler.IsInsideIndex(0, p));
      EXPECT_FALSE(sampler.IsInsideWorld(0, p * 1e6));
    }
  }
}

TEST(FieldSampler, ReproducesLinearFieldsInTheWorld)
{
  std::mt19937_64 random(14);
  const FieldGrid grid = test::ObliqueGrid({12, 19, 9}, random);
  const test::PlaneField plane{{0.36, 0.48, -0.8}, 3.0};
  std::vector<double> samples;
  for (int k = 0; k < 9; ++k)
  {
    for (int j = 0; j < 19; ++j)
    {
      for (int i = 0; i < 12; ++i)
      {
        samples.push_back(plane.Value(grid.PointWorld({1.0 * i, 1.0 * j, 1.0 * k})));
      }
    }
  }
  FieldBuilder builder(grid);
  const double middle = plane.Value(grid.PointWorld({5.5, 9.0, 4.0}));
  builder.AddMaterial({builder.AddChannel(SamplesOfGrid(samples.data(), grid)), middle});
  builder.KeepAll();
  std::shared_ptr<const ScalarField> field;
  ASSERT_TRUE(builder.Build(field).IsOk());
  const FieldSampler sampler(field);
  WorstCase value;
  WorstCase gradient;
  for (int point = 0; point < 300; ++point)
  {
    const Vector3 world =
        grid.PointWorld(Vector3::Constant(0.01) + 0.99 * RandomPoint(grid, random));
    const FieldGradientSample sample = sampler.ValueAndGradientWorld(0, world);
    ASSERT_EQ(sample.Kind, SampleKind::Sampled);
    value.Add(sample.Value - plane.Value(world));
    value.Add(sampler.ValueWorld(0, world).Value - plane.Value(world));
    gradient.Add((sample.Gradient - plane.Normal).norm());
    const bool isInside = sampler.IsInsideWorld(0, world);
    ASSERT_TRUE(isInside == (plane.Value(world) >= middle) ||
                std::abs(plane.Value(world) - middle) < 1e-12);
  }
  EXPECT_LE(value.Value(), 1e-12); // roundings of world coordinates of some 50 mm
  EXPECT_LE(gradient.Value(), 1e-12);
}

// Largest errors of value and of the normal's angle on a sphere's surface.
struct SphereErrors
{
  double Value = 0.0;
  double Angle = 0.0;
};

SphereErrors ErrorsOnSphere(int nodes, FieldInterpolation method)
{
  const FieldGrid grid = PlainGrid({nodes, nodes, nodes});
  // Off the nodes, and smooth inside too, since the B-spline depends on distant samples.
  const double unit = (nodes - 1) / 10.0;
  const Vector3 center = Vector3(5.03, 4.97, 5.01) * unit;
  const test::QuadraticSphereField quadratic{center, 3.3 * unit};
  std::vector<double> samples = test::SampleAtIndices(grid.Size(), quadratic);
  for (double& sample : samples)
  {
    sample = std::tanh(sample / (unit * unit) / 10.0); // not a polynomial; the same surface
  }
  const FieldSampler sampler(MakeField(grid, samples, 0.0, method));
  std::mt19937_64 random(15);
  std::normal_distribution<double> normal;
  SphereErrors errors;
  for (int point = 0; point < 3000; ++point)
  {
    const Vector3 u = Vector3(normal(random), normal(random), normal(random)).normalized();
    const FieldGradientSample sample = sampler.ValueAndGradientIndex(0, center + 3.3 * unit * u);
    // Of the value, in units of length: the true gradient there is 0.66 per unit.
    errors.Value = std::max(errors.Value, std::abs(sample.Value) / 0.66);
    const double cosine = -sample.Gradient.normalized().dot(u);
    const double sine = sample.Gradient.normalized().cross(u).norm();
    errors.Angle = std::max(errors.Angle, std::atan2(sine, cosine));
  }
  return errors;
}

// Between 20 and 80 cells; a least-squares fit of four points gives the same.
double FittedOrder(double coarse, double fine)
{
  return std::log2(coarse / fine) / 2.0;
}

TEST(FieldSampler, TrilinearConvergesOnASphereWithOrderTwoAndItsNormalWithOne)
{
  const SphereErrors coarse = ErrorsOnSphere(21, FieldInterpolation::Trilinear);
  const SphereErrors fine = ErrorsOnSphere(81, FieldInterpolation::Trilinear);
  EXPECT_NEAR(FittedOrder(coarse.Value, fine.Value), 2.0, 0.15);
  EXPECT_NEAR(FittedOrder(coarse.Angle, fine.Angle), 1.0, 0.15);
  RecordProperty("value", std::to_string(FittedOrder(coarse.Value, fine.Value)));
  RecordProperty("angle", std::to_string(FittedOrder(coarse.Angle, fine.Angle)));
}

TEST(FieldSampler, TricubicConvergesOnASphereWithOrderFourAndItsNormalWithThree)
{
  const SphereErrors coarse = ErrorsOnSphere(21, FieldInterpolation::TricubicBSpline);
  const SphereErrors fine = ErrorsOnSphere(81, FieldInterpolation::TricubicBSpline);
  EXPECT_NEAR(FittedOrder(coarse.Value, fine.Value), 4.0, 0.4);
  EXPECT_NEAR(FittedOrder(coarse.Angle, fine.Angle), 3.0, 0.4);
}

TEST(FieldSampler, TricubicGradientIsContinuousAcrossFaces)
{
  std::mt19937_64 random(16);
  const FieldGrid grid = PlainGrid({20, 20, 20});
  const std::vector<double> samples = test::RandomSteps(grid, random, 100);
  const FieldSampler sampler(MakeField(grid, samples, 50.0, FieldInterpolation::TricubicBSpline));
  WorstCase jump;
  for (int round = 0; round < 300; ++round)
  {
    Vector3 p = RandomPoint(grid, random);
    const int axis = static_cast<int>(random() % 3);
    p[axis] = 1.0 + static_cast<double>(random() % 18);
    Vector3 before = p;
    before[axis] = std::nextafter(p[axis], 0.0);
    jump.Add((sampler.ValueAndGradientIndex(0, p).Gradient -
              sampler.ValueAndGradientIndex(0, before).Gradient)
                 .norm());
  }
  EXPECT_LE(jump.Value(), 1e-11); // roundings of gradients of some hundreds
}

template <typename T>
void ExpectBatchesLikeSingleQueries(FieldInterpolation method, FieldSense sense)
{
  std::mt19937_64 random(17);
  const FieldGrid grid = test::ObliqueGrid({21, 30, 17}, random);
  std::vector<T> samples = test::RandomSteps<T>(grid, random, 9);
  std::fill(samples.begin(), samples.begin() + 21 * 30 * 9, T{7}); // bricks without a surface
  FieldBuilder builder(grid);
  builder.AddMaterial({builder.AddChannel(SamplesOfGrid(samples.data(), grid)), 4.0, sense});
  builder.SetInterpolation(method);
  std::shared_ptr<const ScalarField> field;
  ASSERT_TRUE(builder.Build(field).IsOk());
  for (const InstructionSet set : RunnableInstructionSets())
  {
    const FieldSampler sampler(field, set);
    for (const std::size_t count : {0u, 1u, 3u, 4u, 7u, 400u})
    {
      std::vector<Vector3> world;
      for (std::size_t p = 0; p < count; ++p)
      {
        world.push_back(grid.PointWorld(RandomPoint(grid, random) * 1.1));
      }
      if (count > 3)
      {
        world[1][2] = NaN;
        world[2][0] = Infinity;
        world[3][1] = 1e300;
      }
      std::vector<unsigned char> inside(count, 7);
      sampler.AreInsideWorld(0, world.data(), count, inside.data());
      for (std::size_t p = 0; p < count; ++p)
      {
        ASSERT_EQ(inside[p], sampler.IsInsideWorld(0, world[p]) ? 1 : 0) << NameOf(set);
      }
    }
  }
}

TEST(FieldSampler, BatchesEqualSingleQueriesForEveryInstructionSet)
{
  for (const FieldInterpolation method : Methods)
  {
    for (const FieldSense sense : {FieldSense::AtLeast, FieldSense::AtMost})
    {
      ExpectBatchesLikeSingleQueries<std::int8_t>(method, sense);
      ExpectBatchesLikeSingleQueries<std::uint8_t>(method, sense);
      ExpectBatchesLikeSingleQueries<std::int16_t>(method, sense);
      ExpectBatchesLikeSingleQueries<std::uint16_t>(method, sense);
      ExpectBatchesLikeSingleQueries<float>(method, sense);
      ExpectBatchesLikeSingleQueries<double>(method, sense);
    }
  }
}

template <typename T>
void ExpectRightAnswersFor()
{
  const FieldGrid grid({9, 17, 3}, Vector3::Zero(), {0.5, 0.5, 6.0}, Matrix3::Identity());
  std::vector<T> samples(grid.NodeCount(), static_cast<T>(10));
  samples[9 * 17 + 9 * 4 + 4] = static_cast<T>(50); // node (4, 4, 1)
  const FieldSampler sampler(MakeField(grid, samples, 30.0));
  EXPECT_EQ(sampler.ValueIndex(0, {4, 4, 1}).Value, 50.0);
  EXPECT_EQ(sampler.ValueIndex(0, {4.25, 4, 1}).Value, 40.0);
  EXPECT_EQ(sampler.ValueAndGradientWorld(0, {2.125, 2.0, 6.0}).Gradient[0], -80.0);
  EXPECT_TRUE(sampler.IsInsideIndex(0, {4.5, 4, 1}));
  EXPECT_FALSE(sampler.IsInsideIndex(0, {4.51, 4, 1}));
}

TEST(FieldSampler, ReadsEveryTypeOfSample)
{
  ExpectRightAnswersFor<std::int8_t>();
  ExpectRightAnswersFor<std::uint8_t>();
  ExpectRightAnswersFor<std::int16_t>();
  ExpectRightAnswersFor<std::uint16_t>();
  ExpectRightAnswersFor<std::int32_t>();
  ExpectRightAnswersFor<std::uint32_t>();
  ExpectRightAnswersFor<std::int64_t>();
  ExpectRightAnswersFor<std::uint64_t>();
  ExpectRightAnswersFor<long long>();
  ExpectRightAnswersFor<float>();
  ExpectRightAnswersFor<double>();
}
} // namespace
} // namespace palpate::field_sampler_test
