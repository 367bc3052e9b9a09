#include "ClearanceProof.h"

#include "NearestByBruteForce.h"
#include "RandomShapes.h"
#include "WanderingDirection.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <memory>

namespace palpate::clearance_proof_test
{
namespace
{
using test::Random;
using Finding = ClearanceProof::Finding;

constexpr int Evaluations = 640;
constexpr int ProvingEvaluations = 20000;

// Moves over a rough body, at a height that varies from within `distance` to beyond.
class Glide
{
public:
  Glide(const RadialModel& model, Random& random) : Model(model), Direction(random) {}
  Vector3 Next(double height)
  {
    const Vector3& u = this->Direction.Next(0.004);
    return this->Model.PointWorld(u) + height * this->Model.Normal(u);
  }

private:
  const RadialModel& Model;
  test::WanderingDirection Direction;
};

class ClearanceProofOfDegree : public testing::TestWithParam<int>
{
protected:
  Random Source{static_cast<unsigned>(1600 + GetParam())};
  const RadialModel Rough = test::RandomRough(Source, GetParam(), 20.0);
  const ClosestPointSearch Search{std::make_shared<const RadialModel>(Rough)};
};

TEST_P(ClearanceProofOfDegree, AgreesWithGlobalSearch)
{
  constexpr double Distance = 3.0;
  constexpr double Tolerance = 1e-4;
  ClearanceProof proof(this->Search, Distance, Tolerance);
  Glide glide(this->Rough, this->Source);
  int clear = 0;
  int nearer = 0;
  for (int step = 0; step < 400; ++step)
  {
    const Vector3 query = glide.Next(Distance + 1.5 * std::sin(0.05 * step));
    const double nearest = std::abs(this->Search.Nearest(query, ProvingEvaluations).SignedDistance);
    const ClearanceProof::Answer answer = proof.Ask(query, nullptr, 0, Evaluations);
    if (answer.State == Finding::Nearer)
    {
      ++nearer;
      const double found = std::abs(answer.Minimum.SignedDistance);
      ASSERT_LT(found, Distance);
      ASSERT_NEAR((answer.Minimum.PointWorld - query).norm(), found, 1e-9); // rounding
    }
    else
    {
      clear += answer.State == Finding::Clear ? 1 : 0;
      ASSERT_LE(answer.LowerDistance, nearest + 1e-9) << step; // rounding
      ASSERT_GE(answer.State == Finding::Open ? Distance : nearest, Distance - Tolerance) << step;
    }
  }
  EXPECT_GT(clear, 50);
  EXPECT_GT(nearer, 50);
}

TEST_P(ClearanceProofOfDegree, KnownMinimaHideNoOthers)
{
  constexpr double Distance = 4.0;
  constexpr double Tolerance = 1e-4;
  ClearanceProof proof(this->Search, Distance, Tolerance);
  const IcosahedronDirections sphere(40);
  Glide glide(this->Rough, this->Source);
  int open = 0;
  for (int step = 0; step < 200; ++step)
  {
    // Where the tool just touches, as it does in use.
    const ToolContact touch = this->Search.TouchAnywhere(glide.Next(Distance), Distance);
    const Vector3 query = touch.ToolCenterWorld;
    std::vector<ClosestPoint> known{this->Search.Nearest(query, ProvingEvaluations)};
    ClearanceProof::Answer answer = proof.Ask(query, known.data(), known.size(), Evaluations);
    while (answer.State == Finding::Nearer && known.size() < ClearanceProof::MostKnown)
    {
      for (const ClosestPoint& other : known)
      {
        ASSERT_GT((other.Direction - answer.Minimum.Direction).norm(), ClearanceProof::Apart);
      }
      known.push_back(answer.Minimum);
      answer = proof.Ask(query, known.data(), known.size(), Evaluations);
    }
    open += answer.State == Finding::Clear ? 0 : 1;
    if (answer.State != Finding::Clear)
    {
      continue;
    }
    // Descents from closer places must end in a known minimum.
    for (const Vector3& u : sphere.Directions())
    {
      if ((this->Rough.PointWorld(u) - query).norm() < Distance - Tolerance)
      {
        const ClosestPoint end = this->Search.Descent().Run(
            query - this->Rough.CenterWorld(), u, this->Rough.EvaluateSecondOrder(u), 1e-9, 200);
        ASSERT_TRUE(std::any_of(known.begin(), known.end(),
                                [&](const ClosestPoint& minimum) {
                                  return (minimum.Direction - end.Direction).norm() <
                                         ClearanceProof::Apart;
                                }))
            << step;
      }
    }
  }
  EXPECT_LE(open, 50); // of 200: where minima are about to appear
}

TEST_P(ClearanceProofOfDegree, BoundsHoldWithLittleWork)
{
  constexpr double Distance = 3.0;
  ClearanceProof proof(this->Search, Distance, 1e-4);
  Glide glide(this->Rough, this->Source);
  for (int step = 0; step < 200; ++step)
  {
    const Vector3 query = glide.Next(Distance + 0.02 * step);
    const double nearest = std::abs(this->Search.Nearest(query, ProvingEvaluations).SignedDistance);
    const ClearanceProof::Answer answer = proof.Ask(query, nullptr, 0, 4);
    ASSERT_NE(answer.State, Finding::Nearer);                // a descent takes more
    ASSERT_LE(answer.LowerDistance, nearest + 1e-9) << step; // rounding
  }
}

TEST_P(ClearanceProofOfDegree, GoesOnWhereWorkEnded)
{
  constexpr double Distance = 3.0;
  constexpr int Little = 12;
  constexpr int MostQueries = 200;
  Glide glide(this->Rough, this->Source);
  for (int place = 0; place < 40; ++place)
  {
    const Vector3 query = glide.Next(place % 2 == 0 ? 2.0 * Distance : 0.5 * Distance);
    ClearanceProof proof(this->Search, Distance, 1e-4);
    ClearanceProof whole(this->Search, Distance, 1e-4);
    int queries = 1;
    ClearanceProof::Answer answer = proof.Ask(query, nullptr, 0, Little);
    for (; answer.State == Finding::Open && queries < MostQueries; ++queries)
    {
      ASSERT_LE(answer.Evaluations, Little + 1);
      answer = proof.Ask(query, nullptr, 0, Little);
    }
    ASSERT_LT(queries, MostQueries) << place;
    ASSERT_EQ(answer.State, whole.Ask(query, nullptr, 0, ProvingEvaluations).State) << place;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, ClearanceProofOfDegree, testing::Values(4, 8, 12, 20, 33));

// Work for a descent is left, whatever the limit is.
TEST(ClearanceProof, AnyLittleWorkEnds)
{
  constexpr int Most = 2000; // times
  Random random(947);
  const RadialModel rough = test::RandomRough(random, 12, 20.0);
  const ClosestPointSearch search(std::make_shared<const RadialModel>(rough));
  for (int little = 8; little <= 16; ++little)
  {
    for (int trial = 0; trial < 10; ++trial)
    {
      const Vector3 direction = test::RandomDirection(random);
      const Vector3 query = rough.PointWorld(direction) + 1.5 * direction;
      ClearanceProof proof(search, 2.0, 0.01);
      ClearanceProof::Answer answer = proof.Ask(query, nullptr, 0, little);
      for (int again = 0; again < Most && answer.State == ClearanceProof::Finding::Open; ++again)
      {
        answer = proof.Ask(query, nullptr, 0, little);
      }
      ASSERT_NE(answer.State, ClearanceProof::Finding::Open) << little << " " << trial;
    }
  }
}

TEST(ClearanceProof, IsDeterministic)
{
  Random random(1649);
  const RadialModel rough = test::RandomRough(random, 12, 20.0);
  const ClosestPointSearch search(std::make_shared<const RadialModel>(rough));
  ClearanceProof one(search, 3.0, 1e-4);
  ClearanceProof other(search, 3.0, 1e-4);
  Glide glide(rough, random);
  for (int step = 0; step < 500; ++step)
  {
    const Vector3 query = glide.Next(3.1);
    const ClearanceProof::Answer first = one.Ask(query, nullptr, 0, Evaluations);
    const ClearanceProof::Answer second = other.Ask(query, nullptr, 0, Evaluations);
    ASSERT_EQ(first.State, second.State);
    if (first.State == Finding::Nearer)
    {
      ASSERT_EQ(first.Minimum.PointWorld, second.Minimum.PointWorld);
    }
    else
    {
      ASSERT_EQ(first.LowerDistance, second.LowerDistance);
    }
  }
}

TEST(ClearanceProof, LongPathsKeepBoundsValid)
{
  Random random(1650);
  const RadialModel rough = test::RandomRough(random, 12, 20.0);
  const ClosestPointSearch search(std::make_shared<const RadialModel>(rough));
  ClearanceProof proof(search, 2.0, 1e-4);
  for (int step = 0; step < 200; ++step)
  {
    const bool isFar = step % 2 == 1;
    const double height = isFar ? std::pow(10.0, 2.0 + 0.4 * step) : 1.0;
    const Vector3 u = test::RandomDirection(random);
    const ClearanceProof::Answer answer =
        proof.Ask(rough.PointWorld(u) + height * rough.Normal(u), nullptr, 0, Evaluations);
    EXPECT_EQ(answer.State, isFar ? Finding::Clear : Finding::Nearer) << step;
  }
}
} // namespace
} // namespace palpate::clearance_proof_test
