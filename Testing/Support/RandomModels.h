#pragma once

#include "ModelDocument.h"
#include "SphericalHarmonicBasis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

namespace palpate::test
{
inline std::vector<double> RandomNumbers(std::mt19937_64& random, std::size_t count, double scale)
{
  std::normal_distribution<double> normal(0.0, scale);
  std::vector<double> values(count);
  for (double& value : values)
  {
    value = normal(random);
  }
  return values;
}

/// Any finite bit pattern: subnormal, negative zero, huge.
inline std::vector<double> RandomBits(std::mt19937_64& random, std::size_t count)
{
  std::vector<double> values;
  while (values.size() < count)
  {
    const std::uint64_t bits = random();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value))
    {
      values.push_back(value);
    }
  }
  return values;
}

/// A star-shaped body of about 20 mm radius off the origin.
inline RadialModel RandomModel(std::mt19937_64& random, int degree)
{
  std::vector<double> values =
      RandomNumbers(random, SphericalHarmonicBasis::CoefficientCount(degree), 0.5);
  values[0] = 20.0 * std::sqrt(4.0 * 3.14159265358979323846);
  const std::vector<double> center = RandomNumbers(random, 3, 50.0);
  return {degree, values, Vector3(center[0], center[1], center[2])};
}

inline SurfaceModel RandomSurfaceModel(std::mt19937_64& random, int degree)
{
  std::array<std::vector<double>, 3> coordinates;
  for (auto& coordinate : coordinates)
  {
    coordinate = RandomNumbers(random, SphericalHarmonicBasis::CoefficientCount(degree), 5.0);
  }
  return {degree, coordinates};
}

inline bool SameBits(double a, double b)
{
  return a == b && std::signbit(a) == std::signbit(b);
}

inline bool SameBits(const std::vector<double>& a, const std::vector<double>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return SameBits(x, y); });
}

inline bool SameBits(const Vector3& a, const Vector3& b)
{
  return SameBits(a.x(), b.x()) && SameBits(a.y(), b.y()) && SameBits(a.z(), b.z());
}
} // namespace palpate::test
