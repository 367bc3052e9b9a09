#include "ClearanceProof.h"

#include "CenteredSurface.h"
#include "SurfacePhantoms.h"
#include "WanderingDirection.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <memory>
#include <vector>

namespace palpate::parametric_clearance_proof_test
{
namespace
{
using test::Random;
using Proof = ClearanceProofOf<CenteredSurface>;
using Search = ClosestPointSearchOf<CenteredSurface>;
using Finding = Proof::Finding;

constexpr int ProvingEvaluations = 20000;
constexpr double Distance = 3.0; // mm
constexpr double Tolerance = 0.01;

std::vector<SurfaceModel> Phantoms()
{
  Random random(5);
  return {test::CleftBlob(), test::BumpyTube(random), test::CrossingRing()};
}

// A place next to the surface that moves by up to 0.1 mm.
class Stroke
{
public:
  Stroke(const SurfaceModel& surface, Random& random) : Surface(surface), Parameter(random) {}
  Vector3 Next(double height)
  {
    const Vector3& u = this->Parameter.Next(0.004);
    return this->Surface.Point(u) + height * this->Surface.Normal(u);
  }

private:
  const SurfaceModel& Surface;
  test::WanderingDirection Parameter;
};

// What a limited proof leaves open does not count as clear.
TEST(SurfaceClearanceProof, BoundsHoldWithAnyLimitOfWork)
{
  for (const SurfaceModel& surface : Phantoms())
  {
    const Search search(std::make_shared<const CenteredSurface>(surface));
    Proof proof(search, Distance, Tolerance);
    Random random(9421);
    Stroke stroke(surface, random);
    int open = 0;
    for (int step = 0; step < 600; ++step)
    {
      const Vector3 query = stroke.Next(Distance + 1.5 * std::sin(0.05 * step));
      const double nearest = std::abs(search.Nearest(query, ProvingEvaluations).SignedDistance);
      const double asked = Distance + (step % 3 == 0 ? 0.5 : 0.0);
      const auto limit = static_cast<int>(random() % 24);
      const Proof::Answer answer = proof.AskWithin(asked, query, nullptr, 0, limit);
      if (answer.State == Finding::Nearer)
      {
        ASSERT_LT(std::abs(answer.Minimum.SignedDistance), asked);
        continue;
      }
      open += answer.State == Finding::Open ? 1 : 0;
      ASSERT_LE(answer.LowerDistance, nearest + 1e-9) << step; // rounding
    }
    EXPECT_GT(open, 20);
  }
}

// A tick that has not finished its proof carries it on in the next one.
TEST(SurfaceClearanceProof, LittleWorkAtATimeEndsWhereMuchWorkDoes)
{
  constexpr int Little = 8;
  constexpr int Most = 400; // times
  for (const SurfaceModel& surface : Phantoms())
  {
    const Search search(std::make_shared<const CenteredSurface>(surface));
    Random random(9422);
    int clear = 0;
    int nearer = 0;
    for (int trial = 0; trial < 30; ++trial)
    {
      Proof proof(search, Distance, Tolerance);
      Stroke stroke(surface, random);
      const Vector3 query = stroke.Next(Distance + 0.5 * (trial % 2 == 0 ? 1.0 : -1.0));
      const double nearest = std::abs(search.Nearest(query, ProvingEvaluations).SignedDistance);
      Proof::Answer answer = proof.Ask(query, nullptr, 0, Little);
      for (int again = 0; again < Most && answer.State == Finding::Open; ++again)
      {
        answer = proof.Ask(query, nullptr, 0, Little);
      }
      ASSERT_EQ(answer.State, nearest < Distance - Tolerance ? Finding::Nearer : Finding::Clear);
      clear += answer.State == Finding::Clear ? 1 : 0;
      nearer += answer.State == Finding::Nearer ? 1 : 0;
    }
    EXPECT_GT(clear, 3);
    EXPECT_GT(nearer, 3);
  }
}

// Parts that were evaluated before are bounded again first, and must leave work for the others.
TEST(SurfaceClearanceProof, LittleWorkEndsAfterAStepBesideAKnownMinimum)
{
  constexpr int Little = 8; // no tick takes less
  constexpr int Most = 400; // times
  constexpr int Steps = 40;
  for (const SurfaceModel& surface : Phantoms())
  {
    const Search search(std::make_shared<const CenteredSurface>(surface));
    Random random(9424);
    for (int trial = 0; trial < 20; ++trial)
    {
      Proof proof(search, Distance, Tolerance);
      Stroke stroke(surface, random);
      for (int step = 0; step < Steps; ++step)
      {
        const Vector3 query = stroke.Next(Distance);
        const auto known = search.Nearest(query, ProvingEvaluations);
        Proof fresh(search, Distance, Tolerance);
        const Finding expected = fresh.Ask(query, &known, 1, ProvingEvaluations).State;
        Finding found = Finding::Open;
        for (int again = 0; again < Most && found == Finding::Open; ++again)
        {
          found = proof.Ask(query, &known, 1, Little).State;
        }
        ASSERT_EQ(found, expected) << trial << " " << step;
      }
    }
  }
}
} // namespace
} // namespace palpate::parametric_clearance_proof_test
