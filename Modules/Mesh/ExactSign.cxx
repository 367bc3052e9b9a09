#include "ExactSign.h"

namespace palpate
{
namespace exact
{
namespace
{
// a + b = Value + Error exactly (Knuth).
struct TwoTerms
{
  double Value;
  double Error;
};

TwoTerms Sum(double a, double b) noexcept
{
  const double sum = a + b;
  const double bRounded = sum - a;
  const double aRounded = sum - bRounded;
  return {sum, (a - aRounded) + (b - bRounded)};
}

TwoTerms Product(double a, double b) noexcept
{
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

/// An exact sum: terms of ascending size whose bits do not overlap, so that the last one has the
/// sum's sign.
class Expansion
{
public:
  void Add(double term) noexcept
  {
    int count = 0;
    for (int i = 0; i < this->Count; ++i)
    {
      const TwoTerms sum = Sum(term, this->Terms[i]);
      term = sum.Value;
      if (sum.Error != 0.0)
      {
        this->Terms[count++] = sum.Error;
      }
    }
    if (term != 0.0)
    {
      this->Terms[count++] = term;
    }
    this->Count = count;
  }

  /// Adds a b, or a b c.
  void AddProduct(double a, double b) noexcept
  {
    const TwoTerms ab = Product(a, b);
    this->Add(ab.Error);
    this->Add(ab.Value);
  }
  void AddProduct(double a, double b, double c) noexcept
  {
    const TwoTerms ab = Product(a, b);
    this->AddProduct(ab.Error, c);
    this->AddProduct(ab.Value, c);
  }

  int Sign() const noexcept
  {
    return this->Count == 0 ? 0 : this->Terms[this->Count - 1] > 0.0 ? 1 : -1;
  }

private:
  // 6 products of 3 differences of 2 terms each, 4 terms for each product of 3 terms.
  double Terms[6 * 8 * 4];
  int Count = 0;
};

using Difference = std::array<double, 2>;

Difference Minus(double a, double b) noexcept
{
  const TwoTerms difference = Sum(a, -b);
  return {difference.Value, difference.Error};
}

// sign * u v w
void AddProducts(const Difference& u, const Difference& v, const Difference& w, double sign,
                 Expansion& sum) noexcept
{
  for (const double a : u)
  {
    for (const double b : v)
    {
      for (const double c : w)
      {
        if (a != 0.0 && b != 0.0 && c != 0.0)
        {
          sum.AddProduct(sign * a, b, c);
        }
      }
    }
  }
}

int ExactAreaSign(const Point2& a, const Point2& b, const Point2& c) noexcept
{
  Expansion sum;
  for (const double x : Minus(b[0], a[0]))
  {
    for (const double y : Minus(c[1], a[1]))
    {
      sum.AddProduct(x, y);
    }
  }
  for (const double x : Minus(c[0], a[0]))
  {
    for (const double y : Minus(b[1], a[1]))
    {
      sum.AddProduct(-x, y);
    }
  }
  return sum.Sign();
}
} // namespace

int VolumeSignByExpansion(const Vector3& a, const Vector3& b, const Vector3& c,
                          const Vector3& d) noexcept
{
  Expansion sum;
  std::array<std::array<Difference, 3>, 3> rows;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const int axis = static_cast<int>(i);
    rows[0][i] = Minus(b[axis], a[axis]);
    rows[1][i] = Minus(c[axis], a[axis]);
    rows[2][i] = Minus(d[axis], a[axis]);
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    AddProducts(rows[0][i], rows[1][j], rows[2][k], 1.0, sum);
    AddProducts(rows[0][i], rows[1][k], rows[2][j], -1.0, sum);
  }
  return sum.Sign();
}

int AreaSign(const Point2& a, const Point2& b, const Point2& c) noexcept
{
  const double one = (b[0] - a[0]) * (c[1] - a[1]);
  const double other = (c[0] - a[0]) * (b[1] - a[1]);
  const double area = one - other;
  const double size = std::abs(one) + std::abs(other);
  // Shewchuk's bound (3 + 16 e) e.
  if (size > 1e-200 && std::abs(area) > 3.3306690738754716e-16 * size)
  {
    return area > 0.0 ? 1 : -1;
  }
  return ExactAreaSign(a, b, c);
}
} // namespace exact
} // namespace palpate
