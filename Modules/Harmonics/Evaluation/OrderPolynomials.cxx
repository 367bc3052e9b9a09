#include "OrderPolynomials.h"

#include "SphericalHarmonicBasis.h"

#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
using Long = long double;

void AddTo(std::vector<Long>& sum, const std::vector<Long>& terms, Long factor)
{
  if (sum.size() < terms.size())
  {
    sum.resize(terms.size(), 0.0L);
  }
  for (std::size_t k = 0; k < terms.size(); ++k)
  {
    sum[k] += factor * terms[k];
  }
}

// z (E + z O) = z^2 O + z E, and z^2 = (t + 1) / 2.
ParityPolynomial TimesZ(const ParityPolynomial& p)
{
  ParityPolynomial result;
  result.Odd = p.Even;
  result.Even.assign(p.Odd.empty() ? 0 : p.Odd.size() + 1, 0.0L);
  for (std::size_t k = 0; k < p.Odd.size(); ++k)
  {
    result.Even[k] += p.Odd[k] / 2;
    result.Even[k + 1] += p.Odd[k] / 2;
  }
  return result;
}

// Q_mm of SphericalHarmonicRecurrence, in long double.
Long Diagonal(int order)
{
  Long value = 1.0L / std::sqrt(16.0L * std::atan(1.0L)); // 1 / sqrt(4 pi)
  for (int m = 1; m <= order; ++m)
  {
    value *= std::sqrt((2.0L * m + 1.0L) / (m == 1 ? 1.0L : 2.0L * m));
  }
  return value;
}

} // namespace

OrderPolynomials SumOrder(int degree, int order, const std::vector<double>& coefficients)
{
  OrderPolynomials sums;
  ParityPolynomial previous;
  ParityPolynomial current;
  current.Even = {Diagonal(order)};
  for (int l = order; l <= degree; ++l)
  {
    if (l > order)
    {
      const Long l2 = static_cast<Long>(l) * l;
      const Long m2 = static_cast<Long>(order) * order;
      const Long k2 = (l - 1.0L) * (l - 1.0L);
      const Long a = std::sqrt((4.0L * l2 - 1.0L) / (l2 - m2));
      const Long b = l == order + 1 ? 0.0L : std::sqrt((k2 - m2) / (4.0L * k2 - 1.0L));
      ParityPolynomial next = TimesZ(current);
      AddTo(next.Even, previous.Even, -b);
      AddTo(next.Odd, previous.Odd, -b);
      for (std::vector<Long>* part : {&next.Even, &next.Odd})
      {
        for (Long& value : *part)
        {
          value *= a;
        }
      }
      previous = std::move(current);
      current = std::move(next);
    }
    const Long cosine = coefficients[SphericalHarmonicBasis::Index(l, order)];
    const Long sine = order == 0 ? 0.0L : coefficients[SphericalHarmonicBasis::Index(l, -order)];
    AddTo(sums.Cosine.Even, current.Even, cosine);
    AddTo(sums.Cosine.Odd, current.Odd, cosine);
    AddTo(sums.Sine.Even, current.Even, sine);
    AddTo(sums.Sine.Odd, current.Odd, sine);
  }
  return sums;
}

double PolynomialTerm(const std::vector<long double>& polynomial, int power)
{
  return static_cast<std::size_t>(power) < polynomial.size()
             ? static_cast<double>(polynomial[static_cast<std::size_t>(power)])
             : 0.0;
}
} // namespace palpate
