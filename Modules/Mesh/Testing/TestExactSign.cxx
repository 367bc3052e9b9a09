#include "ExactSign.h"

#include "RandomShapes.h"

#include <gtest/gtest.h>

namespace palpate::exact_sign_test
{
namespace
{
using Integer = __int128;
using IntegerPoint = std::array<std::int64_t, 3>;

int SignOf(Integer x)
{
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

int VolumeSignOfIntegers(const std::array<IntegerPoint, 4>& p)
{
  const auto at = [&p](std::size_t row, std::size_t axis)
  { return static_cast<Integer>(p[row + 1][axis] - p[0][axis]); };
  Integer sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    sum += at(0, i) * (at(1, j) * at(2, k) - at(1, k) * at(2, j));
  }
  return SignOf(sum);
}

Vector3 ToPoint(const IntegerPoint& p, double scale)
{
  return scale *
         Vector3(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
}

IntegerPoint RandomPoint(test::Random& random, std::int64_t size)
{
  std::uniform_int_distribution<std::int64_t> coordinate(-size, size);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

// Almost in the plane of the other three: a combination of them, moved by at most one step.
IntegerPoint NearlyCoplanar(test::Random& random, const std::array<IntegerPoint, 4>& p)
{
  const auto part = [&random] { return static_cast<std::int64_t>(random() % 5) - 2; };
  const IntegerPoint offset = RandomPoint(random, 1);
  const std::int64_t u = part();
  const std::int64_t v = part();
  IntegerPoint point{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    point[i] = p[0][i] + u * (p[1][i] - p[0][i]) + v * (p[2][i] - p[0][i]) + offset[i];
  }
  return point;
}

TEST(ExactSign, OfVolumeEqualsIntegerArithmetic)
{
  test::Random random(31);
  int zeros = 0;
  for (int i = 0; i < 20'000; ++i)
  {
    const std::int64_t size = std::int64_t{1} << (1 + i % 36);
    std::array<IntegerPoint, 4> p{};
    for (IntegerPoint& point : p)
    {
      point = RandomPoint(random, size);
    }
    p[3] = NearlyCoplanar(random, p);
    const int expected = VolumeSignOfIntegers(p);
    zeros += expected == 0 ? 1 : 0;
    // Integers times powers of two are exact.
    const double scale = std::ldexp(1.0, i % 200 - 100);
    const Vector3 a = ToPoint(p[0], scale);
    const Vector3 b = ToPoint(p[1], scale);
    const Vector3 c = ToPoint(p[2], scale);
    const Vector3 d = ToPoint(p[3], scale);
    ASSERT_EQ(exact::VolumeSign(a, b, c, d), expected) << i;
    ASSERT_EQ(exact::VolumeSignByExpansion(a, b, c, d), expected) << i;
    ASSERT_EQ(exact::VolumeSign(b, a, c, d), -expected) << i;
  }
  EXPECT_GT(zeros, 500);
}

TEST(ExactSign, OfVolumeSeesLastBitOfRoundedDifferences)
{
  // The differences are not representable: 1 and 2^-60 next to coordinates of 3.
  const double tiny = std::ldexp(1.0, -60);
  const Vector3 a(3.0, 0.0, 0.0);
  const Vector3 b(0.0, 3.0, 0.0);
  const Vector3 c(0.0, 0.0, 3.0);
  EXPECT_EQ(exact::VolumeSign(a, b, c, {1.0 - tiny, 1.0, 1.0}), 0); // rounds to 1
  EXPECT_EQ(exact::VolumeSign(a, b, c, {tiny, 3.0, 0.0}), 1);
  EXPECT_EQ(exact::VolumeSign(a, b, c, {-tiny, 3.0, 0.0}), -1);
}

TEST(ExactSign, OfAreaEqualsIntegerArithmetic)
{
  test::Random random(32);
  for (int i = 0; i < 20'000; ++i)
  {
    const std::int64_t size = std::int64_t{1} << (1 + i % 50);
    const IntegerPoint a = RandomPoint(random, size);
    const IntegerPoint b = RandomPoint(random, size);
    const IntegerPoint near = RandomPoint(random, 1);
    const IntegerPoint c{2 * b[0] - a[0] + near[0], 2 * b[1] - a[1] + near[1], 0};
    const Integer area = static_cast<Integer>(b[0] - a[0]) * (c[1] - a[1]) -
                         static_cast<Integer>(b[1] - a[1]) * (c[0] - a[0]);
    const auto plane = [](const IntegerPoint& p) {
      return exact::Point2{static_cast<double>(p[0]), static_cast<double>(p[1])};
    };
    ASSERT_EQ(exact::AreaSign(plane(a), plane(b), plane(c)), SignOf(area)) << i;
  }
}
} // namespace
} // namespace palpate::exact_sign_test
