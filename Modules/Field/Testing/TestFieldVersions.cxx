#include "FieldVersions.h"

#include "FieldSampler.h"
#include "MaterialVolume.h"
#include "ProceduralFields.h"
#include "RandomRays.h"
#include "RayCaster.h"
#include "SameBits.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace palpate
{
namespace
{
using test::MaterialVolume;
using test::RandomPointNear;
using test::SameBits;

constexpr std::size_t Plenty = std::size_t{1} << 28;

std::unique_ptr<FieldVersions> VersionsOf(const ScalarField& field, std::size_t bytes = Plenty)
{
  std::unique_ptr<FieldVersions> versions;
  const Status status =
      FieldVersions::Make(std::make_shared<const FieldSurvey>(field),
                          std::make_unique<RecordsInMemory>(field), bytes, versions);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return versions;
}

std::shared_ptr<const ScalarField> Make(FieldVersions& versions, const BrickBox& box)
{
  std::shared_ptr<const ScalarField> version;
  const Status status = versions.MakeVersion(box, version);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return version;
}

BrickBox WholeBox(const ScalarField& field)
{
  BrickBox box;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    box.Last[axis] = field.Layout().Bricks[axis] - 1;
  }
  return box;
}

BrickBox RandomBox(const ScalarField& field, std::mt19937_64& random)
{
  BrickBox box;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto count = static_cast<unsigned>(field.Layout().Bricks[axis]);
    box.First[axis] = static_cast<int>(random() % count);
    box.Last[axis] = box.First[axis] +
                     static_cast<int>(random() % (count - static_cast<unsigned>(box.First[axis])));
  }
  return box;
}

bool IsCovered(const BrickLayout& layout, const Vector3& pointIndex)
{
  bool isIn = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    isIn = isIn && pointIndex[axis] >= layout.Lower[a] && pointIndex[axis] <= layout.Upper[a];
  }
  return isIn;
}

FieldForm RandomForm(std::mt19937_64& random)
{
  return {random() % 2 == 0 ? FieldInterpolation::Trilinear : FieldInterpolation::TricubicBSpline,
          BrickSizes[random() % 3]};
}

// Where a version covers, it says what the field says; elsewhere nothing.
void ExpectSamePoints(const std::shared_ptr<const ScalarField>& field,
                      const std::shared_ptr<const ScalarField>& version, std::mt19937_64& random)
{
  const FieldSampler expected(field);
  const FieldSampler sampler(version);
  std::vector<Vector3> points;
  points.reserve(203);
  for (int point = 0; point < 203; ++point)
  {
    points.push_back(RandomPointNear(field->Grid(), random));
  }
  for (int m = 0; m < field->MaterialCount(); ++m)
  {
    std::vector<unsigned char> inside(points.size());
    sampler.AreInsideIndex(m, points.data(), points.size(), inside.data());
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      const bool isCovered = IsCovered(version->Layout(), points[p]);
      const bool isInside = isCovered && expected.IsInsideIndex(m, points[p]);
      ASSERT_EQ(inside[p] != 0, isInside);
      ASSERT_EQ(sampler.IsInsideIndex(m, points[p]), isInside);
    }
  }
  for (const Vector3& point : points)
  {
    for (int channel = 0; channel < field->ChannelCount(); ++channel)
    {
      const FieldGradientSample sample = sampler.ValueAndGradientIndex(channel, point);
      const FieldGradientSample all = expected.ValueAndGradientIndex(channel, point);
      const bool isCovered = IsCovered(version->Layout(), point);
      ASSERT_EQ(sample.Kind, isCovered ? all.Kind : SampleKind::Outside);
      ASSERT_EQ(sample.Value, isCovered ? all.Value : 0.0);
      ASSERT_TRUE(!isCovered || sample.Gradient == all.Gradient);
    }
  }
}

// Ways between two covered points. What a ray begins in is what is just before, which has to be
// covered too.
void ExpectSameRays(const std::shared_ptr<const ScalarField>& field,
                    const std::shared_ptr<const ScalarField>& version, std::mt19937_64& random)
{
  const RayCaster expected(field);
  const RayCaster caster(version);
  const BrickLayout& layout = version->Layout();
  const auto covered = [&]
  {
    Vector3 p = RandomPointNear(field->Grid(), random);
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      const double before = layout.FirstCell[a] > 0 ? 1e-9 : 0.0;
      p[axis] = std::clamp(p[axis], layout.Lower[a] + before, layout.Upper[a]);
    }
    return p;
  };
  for (int n = 0; n < 80; ++n)
  {
    const Vector3 from = covered();
    FieldRay ray{from, covered() - from};
    ray.Direction[static_cast<int>(random() % 3)] *= random() % 4 == 0 ? 0.0 : 1.0;
    const FieldHit hit = caster.CastIndex(ray, 0.0, 1.0);
    const FieldHit all = expected.CastIndex(ray, 0.0, 1.0);
    // Rounding may put the way's end beyond what is covered, and then it is the end of the ray.
    const bool isAtEnd = all.Kind != HitKind::Missed && all.T >= 1.0 - 1e-12;
    ASSERT_TRUE(SameBits(hit, all) || isAtEnd);
  }
}

TEST(FieldVersions, OneOfAllBricksHasTheBitsOfTheField)
{
  std::mt19937_64 random(41);
  for (int round = 0; round < 40; ++round)
  {
    const MaterialVolume volume(random);
    const auto field = volume.Make(RandomForm(random), round % 3 == 0 ? 5.0 : 0.0);
    const auto versions = VersionsOf(*field);
    const auto version = Make(*versions, WholeBox(*field));
    ASSERT_TRUE(version->Layout().IsWhole());
    ExpectSamePoints(field, version, random);
    ASSERT_EQ(version->SurfaceCells(), field->SurfaceCells());
    std::vector<FieldRay> rays;
    for (int n = 0; n < 100; ++n)
    {
      const FieldRay ray = test::RandomRay(volume.Grid, random);
      rays.push_back({volume.Grid.PointWorld(ray.Origin), volume.Grid.VectorWorld(ray.Direction)});
    }
    std::vector<FieldHit> hits(rays.size());
    std::vector<FieldHit> expected(rays.size());
    RayCaster(version).CastAllWorld(rays.data(), rays.size(), 0.0, 300.0, hits.data());
    RayCaster(field).CastAllWorld(rays.data(), rays.size(), 0.0, 300.0, expected.data());
    for (std::size_t n = 0; n < rays.size(); ++n)
    {
      ASSERT_TRUE(SameBits(hits[n], expected[n]));
    }
  }
}

TEST(FieldVersions, OneOfABoxHasTheBitsOfTheFieldThere)
{
  std::mt19937_64 random(42);
  for (int round = 0; round < 60; ++round)
  {
    const MaterialVolume volume(random);
    const auto field = volume.Make(RandomForm(random), round % 3 == 0 ? 5.0 : 0.0);
    const auto versions = VersionsOf(*field);
    for (int box = 0; box < 4; ++box)
    {
      const auto version = Make(*versions, RandomBox(*field, random));
      ExpectSamePoints(field, version, random);
      ExpectSameRays(field, version, random);
    }
  }
}

// What is beyond is not known, which is neither a surface nor a border.
TEST(FieldVersions, ARayThatLeavesWhatIsCoveredEndsThere)
{
  const FieldGrid grid = test::PlainGrid({65, 65, 65});
  const test::PlaneField plane{{1.0, 0.0, 0.0}, 20.3};
  const auto field = test::MakeField(grid, test::SampleAtIndices(grid.Size(), plane), 0.0);
  const auto versions = VersionsOf(*field);
  const auto middle = Make(*versions, {{0, 2, 2}, {4, 5, 5}});
  const FieldSampler sampler(field);
  const bool risesInside = sampler.IsInsideIndex(0, {60.0, 30.0, 30.0});
  const Vector3 inside(risesInside ? 38.0 : 5.0, 30.0, 30.0);
  ASSERT_TRUE(FieldSampler(middle).IsInsideIndex(0, inside));
  for (const Vector3& direction : {Vector3(0.1, 1.0, 0.0), Vector3(-0.1, -1.0, 0.05)})
  {
    const FieldHit hit = RayCaster(middle).CastIndex({inside, direction}, 0.0, 1000.0);
    EXPECT_EQ(hit.Kind, HitKind::Missed);
    EXPECT_EQ(hit.StartsInside, OnlyMaterial(0));
    EXPECT_EQ(RayCaster(field).CastIndex({inside, direction}, 0.0, 1000.0).Kind, HitKind::Border);
  }
  // From beyond, it begins inside at the box's face.
  const FieldHit entering = RayCaster(middle).CastIndex(
      {inside - 20.0 * Vector3::UnitY(), Vector3::UnitY()}, 0.0, 1000.0);
  EXPECT_EQ(entering.Kind, HitKind::Missed);
  EXPECT_EQ(entering.StartsInside, OnlyMaterial(0));
}

TEST(FieldVersions, WhereTheGridEndsItsBorderIsTheVersionsToo)
{
  std::mt19937_64 random(43);
  const FieldGrid grid = test::PlainGrid({41, 37, 33});
  const test::PlaneField plane{{0.3, 0.5, -0.8}, 3.0};
  const auto field = test::MakeField(grid, test::SampleAtIndices(grid.Size(), plane), 0.0);
  const auto versions = VersionsOf(*field);
  int borders = 0;
  for (int round = 0; round < 300; ++round)
  {
    const auto version = Make(*versions, RandomBox(*field, random));
    const BrickLayout& layout = version->Layout();
    Vector3 from;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      from[axis] = std::uniform_real_distribution<double>(layout.Lower[a], layout.Upper[a])(random);
    }
    const auto axis = static_cast<Eigen::Index>(random() % 3);
    const double sign = random() % 2 == 0 ? 1.0 : -1.0;
    const FieldRay ray{from, sign * Vector3::Unit(axis)};
    const FieldHit all = RayCaster(field).CastIndex(ray, 0.0, 1000.0);
    const FieldHit hit = RayCaster(version).CastIndex(ray, 0.0, 1000.0);
    const bool isReached = all.Kind != HitKind::Missed && IsCovered(layout, all.Position);
    borders += isReached && all.Kind == HitKind::Border ? 1 : 0;
    ASSERT_TRUE(isReached ? SameBits(hit, all) : hit.Kind == HitKind::Missed);
  }
  EXPECT_GT(borders, 20);
}

TEST(FieldVersions, TheNextOneReadsOnlyTheBricksThatAreNew)
{
  std::mt19937_64 random(44);
  const MaterialVolume volume(random);
  const auto field = volume.Make({FieldInterpolation::Trilinear, BrickSize::Cells4});
  const auto versions = VersionsOf(*field);
  const FieldSurvey& survey = versions->Survey();
  const BrickBox first{{0, 0, 0}, {2, 2, 2}};
  const BrickBox second{{1, 0, 0}, {3, 2, 2}};
  const BrickBox both{{0, 0, 0}, {3, 2, 2}};
  const auto before = Make(*versions, first);
  EXPECT_EQ(versions->ReadCount(), survey.RecordCount(first));
  const auto after = Make(*versions, second);
  EXPECT_EQ(versions->ReadCount(), survey.RecordCount(both));
  EXPECT_EQ(versions->ResidentCount(), survey.RecordCount(both));
  EXPECT_EQ(after->Memory().SharedBytes, survey.RecordCount(second) * survey.Records().Bytes());
  EXPECT_EQ(survey.RecordCount(WholeBox(*field)), survey.RecordCount());
}

TEST(FieldVersions, OneOfAFewBricksOfALargeFieldTakesKilobytes)
{
  const FieldGrid grid = test::PlainGrid({401, 401, 401});
  std::vector<std::int8_t> samples(grid.NodeCount(), 0);
  for (std::size_t n = 0; n < samples.size(); n += 4003)
  {
    samples[n] = 1;
  }
  const auto field = test::MakeField(grid, samples, 0.5);
  const auto versions = VersionsOf(*field);
  const auto version = Make(*versions, {{20, 20, 20}, {25, 25, 25}});
  EXPECT_GT(field->Memory().Bytes, std::size_t{2000000});
  EXPECT_LT(version->Memory().Bytes, std::size_t{10000});
  const double bytesOfBrick = static_cast<double>(versions->Survey().Bytes()) /
                              static_cast<double>(field->Layout().BrickCount());
  EXPECT_LT(bytesOfBrick, 8.5) << "of one channel: a word, a constant, a bit";
}

// Bricks that nobody holds make room, those first that were used longest ago.
TEST(FieldVersions, WhatWasNotUsedForLongestMakesRoom)
{
  const FieldGrid grid = test::PlainGrid({8 * 10 + 1, 9, 9});
  const test::PlaneField plane{{0.0, 0.0, 1.0}, 4.5};
  const auto field = test::MakeField(grid, test::SampleAtIndices(grid.Size(), plane), 0.0);
  const std::size_t record = FieldVersions::BytesOfRecord(FieldSurvey(*field));
  const auto versions = VersionsOf(*field, 4 * record + record / 2);
  ASSERT_EQ(versions->Room(), 4u);
  const auto use = [&](int brick) { Make(*versions, {{brick, 0, 0}, {brick, 0, 0}}); };
  for (const int brick : {0, 1, 2, 3, 0})
  {
    use(brick);
  }
  EXPECT_EQ(versions->ReadCount(), 4u);
  use(4); // in place of 1
  EXPECT_EQ(versions->ReadCount(), 5u);
  use(0);
  use(2);
  use(3);
  EXPECT_EQ(versions->ReadCount(), 5u);
  use(1);
  EXPECT_EQ(versions->ReadCount(), 6u);
  EXPECT_EQ(versions->ResidentCount(), 4u);
}

TEST(FieldVersions, WhatIsHeldKeepsItsBitsHoweverManyFollow)
{
  std::mt19937_64 random(45);
  const MaterialVolume volume(random);
  const auto field = volume.Make({FieldInterpolation::Trilinear, BrickSize::Cells4});
  const auto versions = VersionsOf(*field, 60 * RecordLayout(*field).Bytes());
  std::vector<std::shared_ptr<const ScalarField>> held;
  int refused = 0;
  for (int round = 0; round < 400; ++round)
  {
    BrickBox box = RandomBox(*field, random);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      box.Last[axis] = std::min(box.Last[axis], box.First[axis] + 2);
    }
    std::shared_ptr<const ScalarField> version;
    const Status status = versions->MakeVersion(box, version);
    EXPECT_EQ(status.IsOk(), version != nullptr);
    refused += status.IsOk() ? 0 : 1;
    if (version != nullptr)
    {
      held.push_back(version);
    }
    if (held.size() > 3)
    {
      held.erase(held.begin() + static_cast<std::ptrdiff_t>(random() % held.size()));
    }
    for (const auto& one : held)
    {
      ExpectSamePoints(field, one, random);
    }
  }
  EXPECT_GT(refused, 0) << "the pool was never full, so that little was tested";
  EXPECT_LT(refused, 390);
}

// Fails from one call on.
class FailingSource final : public BrickSource
{
public:
  FailingSource(const ScalarField& field, int good) : All(field), Good(good) {}
  Status Read(std::uint32_t number, std::byte* record) override
  {
    return this->Good-- > 0 ? this->All.Read(number, record) : Status::Failure("The disk is gone.");
  }

private:
  RecordsInMemory All;
  int Good;
};

TEST(FieldVersions, ASourceThatFailsIsSaidAndWhatWasMadeStays)
{
  std::mt19937_64 random(46);
  const MaterialVolume volume(random);
  const auto field = volume.Make({FieldInterpolation::Trilinear, BrickSize::Cells4});
  const auto survey = std::make_shared<const FieldSurvey>(*field);
  const BrickBox box{{0, 0, 0}, {0, 0, 0}};
  std::unique_ptr<FieldVersions> versions;
  ASSERT_TRUE(FieldVersions::Make(survey,
                                  std::make_unique<FailingSource>(
                                      *field, static_cast<int>(survey->RecordCount(box))),
                                  Plenty, versions)
                  .IsOk());
  const auto version = Make(*versions, box);
  std::shared_ptr<const ScalarField> next;
  const Status status = versions->MakeVersion(WholeBox(*field), next);
  EXPECT_EQ(status.Message(), "The disk is gone.");
  EXPECT_EQ(next, nullptr);
  ExpectSamePoints(field, version, random);
}

TEST(FieldVersions, WhatCannotBeIsRefusedInASentence)
{
  std::mt19937_64 random(47);
  const MaterialVolume volume(random);
  const auto field = volume.Make(FieldInterpolation::Trilinear);
  std::unique_ptr<FieldVersions> versions;
  const Status tiny = FieldVersions::Make(std::make_shared<const FieldSurvey>(*field),
                                          std::make_unique<RecordsInMemory>(*field), 100, versions);
  EXPECT_NE(tiny.Message().find("room for 100"), std::string::npos) << tiny.Message();
  versions = VersionsOf(*field);
  std::shared_ptr<const ScalarField> version;
  for (const BrickBox& box : {BrickBox{{-1, 0, 0}, {0, 0, 0}}, BrickBox{{0, 0, 0}, {999, 0, 0}},
                              BrickBox{{1, 0, 0}, {0, 0, 0}}})
  {
    EXPECT_FALSE(versions->MakeVersion(box, version).IsOk());
    EXPECT_EQ(version, nullptr);
  }
}

// One thread makes versions in a pool that has hardly room, others ask those that they were given.
TEST(FieldVersions, NoneIsSeenHalfWrittenByOtherThreads)
{
  std::mt19937_64 random(48);
  const FieldGrid grid = test::PlainGrid({8 * 12 + 1, 17, 17});
  std::vector<std::int16_t> samples = test::RandomSteps<std::int16_t>(grid, random, 100);
  const auto field = test::MakeField(grid, samples, 50.5);
  const auto versions = VersionsOf(*field, 40 * RecordLayout(*field).Bytes());
  const FieldSampler expected(field);
  constexpr int Readers = 2;
  std::array<std::shared_ptr<const ScalarField>, Readers> newest;
  std::array<std::atomic<int>, Readers> given{};
  std::atomic<bool> isOver{false};
  std::atomic<int> wrong{0};
  std::vector<std::thread> readers;
  for (std::size_t r = 0; r < Readers; ++r)
  {
    readers.emplace_back(
        [&, r]
        {
          std::mt19937_64 own(r);
          while (!isOver)
          {
            if (given[r].load(std::memory_order_acquire) == 0)
            {
              std::this_thread::yield();
              continue;
            }
            const std::shared_ptr<const ScalarField> version = std::move(newest[r]);
            given[r].store(0, std::memory_order_release);
            const FieldSampler sampler(version);
            for (int n = 0; n < 200; ++n)
            {
              const Vector3 p = RandomPointNear(grid, own);
              const FieldSample sample = sampler.ValueIndex(0, p);
              const bool isRight = sample.Kind == SampleKind::Outside ||
                                   sample.Value == expected.ValueIndex(0, p).Value;
              wrong += isRight ? 0 : 1;
            }
          }
        });
  }
  for (int round = 0; round < 300; ++round)
  {
    const auto reader = static_cast<std::size_t>(round % Readers);
    const int first = static_cast<int>(random() % 10);
    std::shared_ptr<const ScalarField> version;
    if (versions->MakeVersion({{first, 0, 0}, {first + 1, 1, 1}}, version).IsOk())
    {
      while (given[reader].load(std::memory_order_acquire) != 0)
      {
        std::this_thread::yield();
      }
      newest[reader] = std::move(version);
      given[reader].store(1, std::memory_order_release);
    }
  }
  isOver = true;
  for (std::thread& reader : readers)
  {
    reader.join();
  }
  EXPECT_EQ(wrong, 0);
}
} // namespace
} // namespace palpate
