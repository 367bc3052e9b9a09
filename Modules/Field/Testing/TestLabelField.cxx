#include "FieldCases.h"
#include "FieldSampler.h"
#include "LabelField.h"
#include "RayCaster.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace palpate::label_field_test
{
namespace
{
using test::PlainGrid;

// Label 1 where `inside(world)`.
template <typename T = std::uint8_t, typename Inside>
std::vector<T> MakeLabels(const FieldGrid& grid, const Inside& inside, T label = 1)
{
  std::vector<T> labels;
  labels.reserve(grid.NodeCount());
  for (int k = 0; k < grid.Size()[2]; ++k)
  {
    for (int j = 0; j < grid.Size()[1]; ++j)
    {
      for (int i = 0; i < grid.Size()[0]; ++i)
      {
        labels.push_back(inside(grid.PointWorld(Vector3(i, j, k))) ? label : T{});
      }
    }
  }
  return labels;
}

template <typename T>
std::shared_ptr<const ScalarField> MakeLabelMaterial(const FieldGrid& grid,
                                                     const std::vector<T>& labels, long long label,
                                                     double smoothing = 0.0)
{
  LabelField distances;
  Status status =
      LabelField::Make(SamplesOfGrid(labels.data(), grid), grid, label, smoothing, distances);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  FieldBuilder builder(grid);
  builder.AddMaterial({builder.AddChannel(distances.Samples()), 0.0});
  std::shared_ptr<const ScalarField> field;
  status = builder.Build(field);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return field;
}

template <typename T>
std::string RefusalOfLabel(const std::vector<T>& labels, const FieldGrid& grid, long long label,
                           double smoothing = 0.0)
{
  LabelField distances;
  return LabelField::Make(SamplesOfGrid(labels.data(), grid), grid, label, smoothing, distances)
      .Message();
}

TEST(LabelField, RejectsAbsentLabels)
{
  const FieldGrid grid = PlainGrid({4, 4, 4});
  std::vector<std::uint8_t> labels(grid.NodeCount(), 0);
  labels[21] = 44;
  EXPECT_EQ(RefusalOfLabel(labels, grid, 44), "");
  EXPECT_EQ(RefusalOfLabel(labels, grid, 1), "No voxel has the label 1.");
  EXPECT_EQ(RefusalOfLabel(labels, grid, 300), "No voxel has the label 300."); // 44 in eight bits
  EXPECT_EQ(RefusalOfLabel(labels, grid, -212), "No voxel has the label -212.");
  const std::vector<float> floats(grid.NodeCount(), 1.0f);
  EXPECT_NE(RefusalOfLabel(floats, grid, 1), "");
}

template <typename T>
void ExpectFindsLabel(long long label)
{
  const FieldGrid grid = PlainGrid({5, 5, 5});
  std::vector<T> labels(grid.NodeCount(), static_cast<T>(1));
  labels[62] = static_cast<T>(label); // the centre
  const FieldSampler sampler(MakeLabelMaterial(grid, labels, label));
  EXPECT_TRUE(sampler.IsInsideIndex(0, {2, 2, 2}));
  EXPECT_FALSE(sampler.IsInsideIndex(0, {2, 2, 3}));
}

TEST(LabelField, ReadsEveryIntegerType)
{
  ExpectFindsLabel<std::int8_t>(-128);
  ExpectFindsLabel<std::uint8_t>(255);
  ExpectFindsLabel<std::int16_t>(-300);
  ExpectFindsLabel<std::uint16_t>(65535);
  ExpectFindsLabel<std::int32_t>(-70000);
  ExpectFindsLabel<std::uint32_t>(4000000000LL);
  ExpectFindsLabel<std::int64_t>(std::numeric_limits<std::int64_t>::min());
  ExpectFindsLabel<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
}

TEST(LabelField, KeepsTheSideOfEveryVoxelCentre)
{
  std::mt19937_64 random(61);
  for (const Vector3& spacing : {Vector3(1, 1, 1), Vector3(0.5, 0.5, 6.0), Vector3(3, 0.5, 0.5),
                                 Vector3(1, 4, 1), Vector3(3, 3, 0.5), Vector3(1, 1, 1.4)})
  {
    const FieldGrid grid({14, 11, 9}, Vector3::Zero(), spacing, Matrix3::Identity());
    std::vector<std::uint8_t> labels(grid.NodeCount());
    for (std::uint8_t& label : labels)
    {
      label = static_cast<std::uint8_t>(random() % 2);
    }
    const FieldSampler sampler(MakeLabelMaterial(grid, labels, 1));
    for (std::size_t at = 0; at < labels.size(); ++at)
    {
      const Vector3 p = test::NodeIndex(grid.Size(), at);
      ASSERT_EQ(sampler.IsInsideIndex(0, p), labels[at] == 1) << p.transpose();
    }
  }
}

TEST(LabelField, BoxBoundaryIsHalfWayBetweenCentres)
{
  for (const double thickness : {1.0, 12.0})
  {
    const FieldGrid grid({30, 30, 20}, Vector3::Zero(), {1, 1, thickness}, Matrix3::Identity());
    const auto labels = MakeLabels(grid,
                                   [thickness](const Vector3& p)
                                   {
                                     return p[0] >= 10 && p[0] <= 20 && p[1] >= 8 && p[1] <= 22 &&
                                            p[2] >= 5 * thickness && p[2] <= 15 * thickness;
                                   });
    const RayCaster caster(MakeLabelMaterial(grid, labels, 1));
    const Vector3 middle(15, 15, 10);
    // In float, distances of some millimetres.
    EXPECT_NEAR(caster.CastIndex({middle, {-1, 0, 0}}, 0, 1e3).T, 5.5, 1e-6);
    EXPECT_NEAR(caster.CastIndex({middle, {0, 1, 0}}, 0, 1e3).T, 7.5, 1e-6);
    EXPECT_NEAR(caster.CastIndex({middle, {0, 0, 1}}, 0, 1e3).T, 5.5, thickness > 1 ? 0.3 : 1e-6);
  }
}

// Largest and mean distance (mm) of hits from a sphere given as a mask.
struct SphereErrors
{
  double Largest = 0.0;
  double Mean = 0.0;
  double MeanAngle = 0.0; ///< of the normals, rad
};

SphereErrors ErrorsOfMaskedSphere(const Vector3& spacing, double smoothing)
{
  const double radius = 20.0;
  const Vector3 center(0.2, -0.3, 0.1);
  std::array<int, 3> size{};
  for (int axis = 0; axis < 3; ++axis)
  {
    size[static_cast<std::size_t>(axis)] = static_cast<int>(52.0 / spacing[axis]) + 1;
  }
  const FieldGrid grid(size, Vector3::Constant(-25.5), spacing, Matrix3::Identity());
  const auto labels =
      MakeLabels(grid, [&](const Vector3& p) { return (p - center).norm() <= radius; });
  const RayCaster caster(MakeLabelMaterial(grid, labels, 1, smoothing));
  std::mt19937_64 random(62);
  std::normal_distribution<double> normal;
  SphereErrors errors;
  const int rays = 2000;
  for (int r = 0; r < rays; ++r)
  {
    const Vector3 u = Vector3(normal(random), normal(random), normal(random)).normalized();
    const FieldHit hit = caster.CastWorld({center + 25.0 * u, -u}, 0.0, 50.0);
    EXPECT_EQ(hit.Kind, HitKind::Surface);
    const double error = std::abs(25.0 - hit.T - radius);
    errors.Largest = std::max(errors.Largest, error);
    errors.Mean += error / rays;
    errors.MeanAngle += std::acos(std::min(1.0, -hit.Gradient.normalized().dot(u))) / rays;
  }
  return errors;
}

TEST(LabelField, SphereIsMoreAccurateThanItsVoxels)
{
  const SphereErrors errors = ErrorsOfMaskedSphere({1, 1, 1}, 0.0);
  // The mask itself is off by up to sqrt(3)/2, and 0.25 on average; its faces' normals by 0.6 rad.
  EXPECT_LE(errors.Largest, 0.75);
  EXPECT_LE(errors.Mean, 0.22);
  EXPECT_LE(errors.MeanAngle, 0.35);
}

TEST(LabelField, SmoothingSmoothsASphere)
{
  const SphereErrors errors = ErrorsOfMaskedSphere({1, 1, 1}, 1.0);
  EXPECT_LE(errors.Largest, 0.4);
  EXPECT_LE(errors.Mean, 0.1);
  EXPECT_LE(errors.MeanAngle, 0.08);
}

// A plate of one voxel, a thread of one and a block of five, each smoothed by one voxel.
TEST(LabelField, SmoothingLeavesThinStructures)
{
  const FieldGrid grid({20, 20, 20}, Vector3::Zero(), Vector3::Ones(), Matrix3::Identity());
  for (const auto& [thickness, height] : {std::pair(1, 12), std::pair(1, 1), std::pair(5, 5)})
  {
    std::vector<unsigned char> labels(grid.NodeCount(), 0);
    for (int k = 4; k < 4 + thickness; ++k)
    {
      for (int j = 4; j < 4 + height; ++j)
      {
        std::fill_n(labels.begin() + (20 * k + j) * 20 + 4, 12, 1);
      }
    }
    LabelField field;
    ASSERT_TRUE(LabelField::Make(SamplesOfGrid(labels.data(), grid), grid, 1, 1.0, field).IsOk());
    const FieldSamples samples = field.Samples();
    const auto* first = static_cast<const float*>(samples.Data);
    const auto inside =
        std::count_if(first, first + samples.Count(), [](float value) { return value > 0.0f; });
    EXPECT_GE(inside, 12 * thickness * height / 2);
    EXPECT_EQ(field.Smoothing() == 1.0, thickness == 5);
  }
}

TEST(LabelField, InterpolatesThickSlices)
{
  const SphereErrors errors = ErrorsOfMaskedSphere({0.5, 0.5, 5.0}, 0.0);
  // Half a slice is 2.5; slightly more at the poles, where outlines are farther apart than that.
  EXPECT_LE(errors.Largest, 2.6);
  EXPECT_LE(errors.Mean, 0.6);
}

TEST(LabelField, RejectsInvalidSmoothing)
{
  const FieldGrid grid = PlainGrid({4, 4, 4});
  std::vector<std::uint8_t> labels(grid.NodeCount(), 0);
  labels[21] = 1;
  EXPECT_EQ(RefusalOfLabel(labels, grid, 1, 8.0), "");
  EXPECT_NE(RefusalOfLabel(labels, grid, 1, -0.1), "");
  EXPECT_NE(RefusalOfLabel(labels, grid, 1, 8.1), "");
  EXPECT_NE(RefusalOfLabel(labels, grid, 1, std::numeric_limits<double>::quiet_NaN()), "");
}

TEST(LabelField, StoresLittleOfALargeVolume)
{
  const FieldGrid grid = PlainGrid({128, 128, 128});
  const auto labels =
      MakeLabels(grid, [](const Vector3& p) { return (p - Vector3(60, 64, 70)).norm() <= 20.0; });
  const auto field = MakeLabelMaterial(grid, labels, 1);
  EXPECT_LE(field->Bytes(), grid.NodeCount() * sizeof(float) / 10);
  const FieldSample far = FieldSampler(field).ValueIndex(0, {1.5, 1, 1});
  EXPECT_EQ(far.Kind, SampleKind::Constant);
  EXPECT_EQ(far.Value, -4.0); // the cut-off
}
} // namespace
} // namespace palpate::label_field_test
