#include "SphereQuadrature.h"

#include "WorstCase.h"

#include <gtest/gtest.h>

namespace palpate::sphere_quadrature_test
{
namespace
{
// Integral of x^a y^b z^c over the unit sphere.
double ExactMonomial(int a, int b, int c)
{
  if (a % 2 != 0 || b % 2 != 0 || c % 2 != 0)
  {
    return 0.0;
  }
  const auto half = [](int n) { return std::lgamma((n + 1) / 2.0); };
  return 2.0 * std::exp(half(a) + half(b) + half(c) - std::lgamma((a + b + c + 3) / 2.0));
}

double Integrate(const SphereQuadrature& sphere, int a, int b, int c)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
  {
    const Vector3& u = sphere.Directions[i];
    sum += sphere.Weights[i] * std::pow(u.x(), a) * std::pow(u.y(), b) * std::pow(u.z(), c);
  }
  return sum;
}

TEST(SphereQuadrature, IsExactForMonomialsOfItsDegree)
{
  for (const int degree : {0, 1, 2, 3, 4, 7, 8, 12, 21})
  {
    const SphereQuadrature sphere(degree);
    test::WorstCase worst;
    for (int a = 0; a <= degree; ++a)
    {
      for (int b = 0; a + b <= degree; ++b)
      {
        for (int c = 0; a + b + c <= degree; ++c)
        {
          worst.Add(Integrate(sphere, a, b, c) - ExactMonomial(a, b, c));
        }
      }
    }
    // Total weight 4 pi = 12.6, a few hundred terms, lgamma in double: tens of roundings of 12.6.
    EXPECT_LE(worst.Value(), 1e-13) << degree;
  }
}

TEST(SphereQuadrature, IsInexactBeyondItsDegree)
{
  // Equal steps in longitude cannot distinguish x^(n) from its alias after n steps.
  EXPECT_GT(std::abs(Integrate(SphereQuadrature(5), 6, 0, 0) - ExactMonomial(6, 0, 0)), 1e-3);
}

TEST(SphereQuadrature, HasUnitDirectionsAndPositiveWeights)
{
  const SphereQuadrature sphere(33);
  ASSERT_EQ(sphere.Directions.size(), sphere.Weights.size());
  for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
  {
    EXPECT_NEAR(sphere.Directions[i].norm(), 1.0, 4e-16); // a few roundings
    EXPECT_GT(sphere.Weights[i], 0.0);
  }
}
} // namespace
} // namespace palpate::sphere_quadrature_test
