#include "RingKernel.h"
#include "VertexRelaxation.h"

#include "RandomShapes.h"
#include "WorstCase.h"

#include <gtest/gtest.h>
#include <numeric>

namespace palpate::vertex_relaxation_test
{
namespace
{
using test::Random;
using test::WorstCase;

double Determinant(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return a.dot(b.cross(c));
}

// A fan: vertex 0, then its ring. The ring is star-shaped as seen from vertex 0.
struct Fan
{
  std::vector<MappedVertex> Vertices;
  std::vector<int> Entries;

  Ring Neighbours() const { return {this->Entries.data(), static_cast<int>(this->Entries.size())}; }
};

Fan RandomFan(Random& random, int count)
{
  std::uniform_real_distribution<double> uniform(0.3, 1.0);
  const Vector3 centre = test::RandomDirection(random);
  const Vector3 across = centre.unitOrthogonal();
  Fan fan;
  fan.Vertices.push_back({Vector3::Zero(), centre});
  for (int i = 0; i < count; ++i)
  {
    const double phi = 2.0 * M_PI * (i + 0.5 * uniform(random)) / count;
    const double far = uniform(random);
    const Vector3 tangent = std::cos(phi) * across + std::sin(phi) * centre.cross(across);
    fan.Vertices.push_back({{far * std::cos(phi), far * std::sin(phi), 0.2 * uniform(random)},
                            (centre + uniform(random) * tangent).normalized()});
    fan.Entries.push_back(i + 1);
  }
  return fan;
}

// The energy as the class documents it, from lengths and angles.
double EnergyOf(const Fan& fan)
{
  double energy = 0.0;
  const std::size_t count = fan.Entries.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::array<const MappedVertex*, 3> t = {&fan.Vertices[0], &fan.Vertices[1 + i],
                                                  &fan.Vertices[1 + (i + 1) % count]};
    std::array<double, 3> square; // of the edge opposite to each corner
    for (std::size_t k = 0; k < 3; ++k)
    {
      square[k] = (t[(k + 1) % 3]->Point - t[(k + 2) % 3]->Point).squaredNorm();
    }
    const double sum = std::accumulate(square.begin(), square.end(), 0.0);
    double numerator = 0.0;
    double pairs = 0.0; // 16 A^2 by Heron
    for (std::size_t k = 0; k < 3; ++k)
    {
      square[k] += 0.005 * sum;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double others = square[(k + 1) % 3] + square[(k + 2) % 3] - square[k];
      numerator += others * (1.0 - t[(k + 1) % 3]->Direction.dot(t[(k + 2) % 3]->Direction));
      pairs += 2.0 * square[k] * square[(k + 1) % 3] - square[k] * square[k];
    }
    const double determinant = Determinant(t[0]->Direction, t[1]->Direction, t[2]->Direction);
    energy += pairs * numerator / std::pow(determinant, 3);
  }
  return energy;
}

double LeastDeterminant(const Fan& fan)
{
  double least = 1.0;
  const std::size_t count = fan.Entries.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    least = std::min(least, Determinant(fan.Vertices[0].Direction, fan.Vertices[1 + i].Direction,
                                        fan.Vertices[1 + (i + 1) % count].Direction));
  }
  return least;
}

TEST(VertexRelaxation, StepsKeepEveryTrianglePositive)
{
  Random random(1);
  VertexRelaxation relaxation;
  for (int trial = 0; trial < 1000; ++trial)
  {
    Fan fan = RandomFan(random, 3 + trial % 9);
    ASSERT_GT(LeastDeterminant(fan), 0.0);
    for (int i = 0; i < 5; ++i)
    {
      relaxation.Step(fan.Vertices, 0, fan.Neighbours());
      ASSERT_GT(LeastDeterminant(fan), 0.0) << trial;
    }
  }
}

TEST(VertexRelaxation, LongStepsLowerTheEnergy)
{
  Random random(2);
  VertexRelaxation relaxation;
  for (int trial = 0; trial < 500; ++trial)
  {
    Fan fan = RandomFan(random, 4 + trial % 7);
    const double before = EnergyOf(fan);
    // Steps that change determinants by at most 10 % are trusted.
    if (LeastDeterminant(fan) > 0.0 && relaxation.Step(fan.Vertices, 0, fan.Neighbours()) > 0.1)
    {
      EXPECT_LE(EnergyOf(fan), before * (1.0 + 1e-12)) << trial; // rounding
    }
  }
}

TEST(VertexRelaxation, StepsConvergeToAMinimumOfTheEnergy)
{
  Random random(3);
  VertexRelaxation relaxation;
  for (int trial = 0; trial < 100; ++trial)
  {
    Fan fan = RandomFan(random, 5 + trial % 4);
    ASSERT_GT(LeastDeterminant(fan), 0.0);
    for (int i = 0; i < 100; ++i)
    {
      relaxation.Step(fan.Vertices, 0, fan.Neighbours());
    }
    const double least = EnergyOf(fan);
    const Vector3 q = fan.Vertices[0].Direction;
    const double apart = 1e-3;
    for (int k = 0; k < 8; ++k)
    {
      const Vector3 e = q.unitOrthogonal();
      const double phi = 0.25 * M_PI * k;
      fan.Vertices[0].Direction =
          (q + apart * (std::cos(phi) * e + std::sin(phi) * q.cross(e))).normalized();
      EXPECT_GT(EnergyOf(fan), least) << trial;
    }
  }
}

TEST(RingKernel, SeesEverySideOfRandomPolygons)
{
  Random random(4);
  std::uniform_real_distribution<double> uniform(0.05, 1.0);
  int tested = 0;
  for (int trial = 0; trial < 5000; ++trial)
  {
    // Star-shaped as seen from the first corner: distances vary, angles grow within its corner,
    // which is reflex in a third of the cases.
    const int count = 3 + trial % 10;
    const double corner = M_PI * (0.2 + 1.3 * uniform(random));
    const Vector3 first = test::RandomDirection(random);
    const Vector3 across = first.unitOrthogonal();
    std::vector<Vector3> polygon = {first};
    for (int i = 0; i + 1 < count; ++i)
    {
      const double phi = corner * i / (count - 2.0);
      const double far = 1.5 * uniform(random);
      polygon.emplace_back(std::cos(far) * first +
                           std::sin(far) *
                               (std::cos(phi) * across + std::sin(phi) * first.cross(across)));
    }
    bool isStar = true;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    {
      isStar = isStar && Determinant(first, polygon[i], polygon[i + 1]) > 1e-9;
    }
    if (!isStar)
    {
      continue; // an angle above pi between two neighbours
    }
    ++tested;
    const Vector3 seen = KernelDirection(polygon.data(), count);
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      EXPECT_GT(Determinant(seen, polygon[i], polygon[(i + 1) % polygon.size()]), 0.0) << trial;
    }
  }
  EXPECT_GE(tested, 4000);
}
} // namespace
} // namespace palpate::vertex_relaxation_test
