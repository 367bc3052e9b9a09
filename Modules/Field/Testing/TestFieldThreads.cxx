#include "FieldCases.h"
#include "FieldSampler.h"
#include "RandomRays.h"
#include "RayCaster.h"

#include <thread>

namespace palpate::field_threads_test
{
namespace
{
TEST(FieldThreads, ManyThreadsGetTheSameResults)
{
  std::mt19937_64 random(81);
  const FieldGrid grid = test::ObliqueGrid({30, 25, 20}, random);
  const auto samples = test::RandomSteps<std::int16_t>(grid, random, 20);
  const auto field = test::MakeField(grid, samples, 12.0);
  std::vector<FieldRay> rays;
  std::vector<Vector3> points;
  for (int n = 0; n < 2000; ++n)
  {
    rays.push_back(test::RandomRay(grid, random));
    points.push_back(grid.PointWorld(rays.back().Origin));
  }
  const std::vector<RayInterval> intervals(rays.size(), {0.0, 1e3});
  struct Answers
  {
    std::vector<FieldHit> Hits;
    std::vector<unsigned char> Inside;
  };
  const auto ask = [&](Answers& answers)
  {
    answers.Hits.resize(rays.size());
    answers.Inside.resize(points.size());
    RayCaster(field).CastAllWorld(rays.data(), intervals.data(), rays.size(), answers.Hits.data());
    FieldSampler(field).AreInsideWorld(0, points.data(), points.size(), answers.Inside.data());
  };
  Answers expected;
  ask(expected);
  std::vector<Answers> answers(4);
  std::vector<std::thread> threads;
  threads.reserve(answers.size());
  for (Answers& a : answers)
  {
    threads.emplace_back([&ask, &a] { ask(a); });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const Answers& a : answers)
  {
    EXPECT_EQ(a.Inside, expected.Inside);
    for (std::size_t r = 0; r < rays.size(); ++r)
    {
      ASSERT_EQ(a.Hits[r].T, expected.Hits[r].T);
      ASSERT_EQ(a.Hits[r].Kind, expected.Hits[r].Kind);
    }
  }
}
} // namespace
} // namespace palpate::field_threads_test
