#include "FieldCases.h"
#include "InstructionSets.h"
#include "RandomRays.h"
#include "RandomVolume.h"
#include "RayCaster.h"
#include "SameBits.h"

#include <cmath>
#include <limits>

namespace palpate::ray_lanes_test
{
namespace
{
using test::NameOf;
using test::RandomVolume;
using test::RunnableInstructionSets;
using test::SameBits;

const double Infinity = std::numeric_limits<double>::infinity();
const double NotANumber = std::numeric_limits<double>::quiet_NaN();

// Rays and their intervals: containing the grid, starting or ending in it, empty, or invalid; and
// invalid rays.
struct Questions
{
  std::vector<FieldRay> Rays;
  std::vector<RayInterval> Intervals;

  Questions(const FieldGrid& grid, int count, std::mt19937_64& random)
  {
    for (int n = 0; n < count; ++n)
    {
      FieldRay ray = test::RandomRay(grid, random);
      ray = {grid.PointWorld(ray.Origin), grid.VectorWorld(ray.Direction)};
      this->Rays.push_back(random() % 40 == 0 ? Spoilt(ray, random) : ray);
      this->Intervals.push_back(RandomInterval(random));
    }
  }

  static FieldRay Spoilt(FieldRay ray, std::mt19937_64& random)
  {
    const double spoils[] = {0.0, 1e-310, 1e-150, 1e13, 1e200, Infinity, NotANumber};
    const double spoil = spoils[random() % 7];
    const auto axis = static_cast<Eigen::Index>(random() % 3);
    switch (random() % 3)
    {
    case 0:
      ray.Origin[axis] = spoil;
      break;
    case 1:
      ray.Direction[axis] = spoil;
      break;
    default:
      ray.Direction *= spoil;
      break;
    }
    return ray;
  }
  static RayInterval RandomInterval(std::mt19937_64& random)
  {
    std::uniform_real_distribution<double> place(-5.0, 80.0);
    switch (random() % 8)
    {
    case 0:
      return {-Infinity, Infinity};
    case 1:
      return {place(random), Infinity};
    case 2:
      return {-Infinity, place(random)};
    case 3:
      return {place(random), place(random)}; // every other one is empty
    case 4:
      return {std::floor(place(random)), Infinity};
    case 5:
      return random() % 4 == 0 ? RayInterval{NotANumber, 1.0} : RayInterval{0.0, 100.0};
    default:
      return {0.0, Infinity};
    }
  }
};

struct Tally
{
  int Hits = 0;
  int Borders = 0;
  int Inside = 0;
};

// How often every ray is counted.
int Sets()
{
  return static_cast<int>(RunnableInstructionSets().size());
}

// Compares every result of a batch with the single ray's; counts the hits.
void ExpectSingleAnswers(const std::shared_ptr<const ScalarField>& field, const Questions& asked,
                         std::size_t count, MaterialSet materials, Tally& tally)
{
  for (const InstructionSet set : RunnableInstructionSets())
  {
    const RayCaster caster(field, set);
    std::vector<FieldHit> hits(count + 1);
    hits[count].T = 17.0;
    caster.CastAllWorld(asked.Rays.data(), asked.Intervals.data(), count, hits.data(), materials);
    ASSERT_EQ(hits[count].T, 17.0) << "written past the end";
    for (std::size_t n = 0; n < count; ++n)
    {
      const FieldRay& ray = asked.Rays[n];
      const RayInterval& interval = asked.Intervals[n];
      const FieldHit single = caster.CastWorld(ray, interval.From, interval.To, materials);
      ASSERT_TRUE(SameBits(hits[n], single))
          << NameOf(set) << " ray " << n << " of " << count << ": from " << ray.Origin.transpose()
          << " along " << ray.Direction.transpose() << " in " << interval.From << " " << interval.To
          << ": " << hits[n].T << " not " << single.T;
      tally.Hits += single.Kind == HitKind::Surface ? 1 : 0;
      tally.Borders += single.Kind == HitKind::Border ? 1 : 0;
      tally.Inside += single.StartsInside != 0 ? 1 : 0;
    }
  }
}

TEST(RayLanes, EqualSingleRays)
{
  for (const auto method : {FieldInterpolation::Trilinear, FieldInterpolation::TricubicBSpline})
  {
    std::mt19937_64 random(61);
    Tally tally;
    const bool isTrilinear = method == FieldInterpolation::Trilinear;
    for (int v = 0; v < (isTrilinear ? 400 : 40); ++v)
    {
      const RandomVolume volume(method, random);
      const Questions asked(volume.Grid, 150, random);
      ASSERT_NO_FATAL_FAILURE(
          ExpectSingleAnswers(volume.Field, asked, asked.Rays.size(), AllMaterials, tally));
    }
    EXPECT_GT(tally.Hits, Sets() * (isTrilinear ? 5000 : 500));
    EXPECT_GT(tally.Borders, Sets() * (isTrilinear ? 500 : 50));
    EXPECT_GT(tally.Inside, Sets() * (isTrilinear ? 2500 : 200));
  }
}

// Hits are often at nodes and on faces, where cells end too.
TEST(RayLanes, EqualSingleRaysWhereIntervalsEndAtHits)
{
  std::mt19937_64 random(65);
  Tally tally;
  for (int v = 0; v < 100; ++v)
  {
    const RandomVolume volume(FieldInterpolation::Trilinear, random);
    Questions asked(volume.Grid, 120, random);
    const RayCaster caster(volume.Field);
    for (std::size_t n = 0; n < asked.Rays.size(); ++n)
    {
      const double t = caster.CastWorld(asked.Rays[n], 0.0, Infinity).T;
      const RayInterval intervals[] = {
          {-Infinity, t}, {t, Infinity}, {std::nextafter(t, Infinity), Infinity}, {t, t}};
      asked.Intervals[n] = intervals[n % 4];
    }
    ASSERT_NO_FATAL_FAILURE(
        ExpectSingleAnswers(volume.Field, asked, asked.Rays.size(), AllMaterials, tally));
  }
  EXPECT_GT(tally.Hits, Sets() * 2500);
}

TEST(RayLanes, HandleAnyNumberOfRays)
{
  std::mt19937_64 random(62);
  const RandomVolume volume(FieldInterpolation::Trilinear, random);
  Tally tally;
  for (const int count : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 63, 64, 65, 127, 131})
  {
    const Questions asked(volume.Grid, count, random);
    ASSERT_NO_FATAL_FAILURE(
        ExpectSingleAnswers(volume.Field, asked, asked.Rays.size(), AllMaterials, tally));
  }
}

// A field of three channels of different types and of materials with one condition and with two,
// on an oblique grid, large enough for leaps.
std::shared_ptr<const ScalarField> MixedField(const FieldGrid& grid, std::mt19937_64& random)
{
  const auto steps = test::RandomSteps<std::int16_t>(grid, random, 9);
  auto bumps = test::RandomSteps<float>(grid, random, 90);
  auto sphere = test::RandomSteps<std::uint8_t>(grid, random, 3);
  for (std::size_t at = 0; at < grid.NodeCount(); ++at)
  {
    const Vector3 node = test::NodeIndex(grid.Size(), at);
    const bool isNear = (node - Vector3::Constant(20.0)).norm() < 9.0;
    bumps[at] = bumps[at] > 85.0f ? 1.0f : 0.0f;
    sphere[at] = static_cast<std::uint8_t>(sphere[at] + (isNear ? 100 : 0));
  }
  FieldBuilder builder(grid);
  const int first = builder.AddChannel(SamplesOfGrid(steps.data(), grid));
  const int second = builder.AddChannel(SamplesOfGrid(bumps.data(), grid));
  const int third = builder.AddChannel(SamplesOfGrid(sphere.data(), grid));
  builder.AddMaterial({third, 50.0});
  builder.AddMaterial({second, 0.5});
  builder.AddMaterial({first, 4.0}, {third, 50.0});
  builder.AddMaterial({third, 50.0, FieldSense::AtMost});
  std::shared_ptr<const ScalarField> field;
  const Status status = builder.Build(field);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return field;
}

TEST(RayLanes, EqualSingleRaysForEveryMaterialSet)
{
  std::mt19937_64 random(63);
  const FieldGrid grid = test::ObliqueGrid({70, 41, 44}, random);
  const auto field = MixedField(grid, random);
  Tally tally;
  for (MaterialSet materials = 0; materials < 16; ++materials)
  {
    const Questions asked(grid, 700, random);
    ASSERT_NO_FATAL_FAILURE(ExpectSingleAnswers(field, asked, asked.Rays.size(), materials, tally));
  }
  EXPECT_GT(tally.Hits, Sets() * 1500);
}
} // namespace
} // namespace palpate::ray_lanes_test
