#include "PolynomialTable.h"

#include "SphericalHarmonicBasis.h"

#include <cmath>

namespace palpate
{
namespace
{
using Real = long double;

// E + z O with coefficients of rising powers of t.
struct ParityPolynomial
{
  std::vector<Real> Even;
  std::vector<Real> Odd;
};

void AddTo(std::vector<Real>& sum, const std::vector<Real>& terms, Real factor)
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
Real Diagonal(int order)
{
  Real value = 1.0L / std::sqrt(16.0L * std::atan(1.0L)); // 1 / sqrt(4 pi)
  for (int m = 1; m <= order; ++m)
  {
    value *= std::sqrt((2.0L * m + 1.0L) / (m == 1 ? 1.0L : 2.0L * m));
  }
  return value;
}

struct OrderPolynomials
{
  ParityPolynomial Cosine;
  ParityPolynomial Sine;
};

// Sums c_lm Q_lm(z) over the degrees of one order by the recurrence, on polynomials.
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
      const Real l2 = static_cast<Real>(l) * l;
      const Real m2 = static_cast<Real>(order) * order;
      const Real k2 = (l - 1.0L) * (l - 1.0L);
      const Real a = std::sqrt((4.0L * l2 - 1.0L) / (l2 - m2));
      const Real b = l == order + 1 ? 0.0L : std::sqrt((k2 - m2) / (4.0L * k2 - 1.0L));
      ParityPolynomial next = TimesZ(current);
      AddTo(next.Even, previous.Even, -b);
      AddTo(next.Odd, previous.Odd, -b);
      for (std::vector<Real>* part : {&next.Even, &next.Odd})
      {
        for (Real& value : *part)
        {
          value *= a;
        }
      }
      previous = std::move(current);
      current = std::move(next);
    }
    const Real cosine = coefficients[SphericalHarmonicBasis::Index(l, order)];
    const Real sine = order == 0 ? 0.0L : coefficients[SphericalHarmonicBasis::Index(l, -order)];
    AddTo(sums.Cosine.Even, current.Even, cosine);
    AddTo(sums.Cosine.Odd, current.Odd, cosine);
    AddTo(sums.Sine.Even, current.Even, sine);
    AddTo(sums.Sine.Odd, current.Odd, sine);
  }
  return sums;
}

double At(const std::vector<Real>& terms, int power)
{
  return static_cast<std::size_t>(power) < terms.size()
             ? static_cast<double>(terms[static_cast<std::size_t>(power)])
             : 0.0;
}
} // namespace

PolynomialTable::PolynomialTable(int degree, const std::vector<double>& coefficients, int lanes)
    : MaximumDegree(degree)
{
  const OrderPolynomials zero = SumOrder(degree, 0, coefficients);
  for (int power = EvenCount(degree, 0) - 1; power >= 0; --power)
  {
    this->Values.push_back(At(zero.Cosine.Even, power));
    this->Values.push_back(At(zero.Cosine.Odd, power));
  }
  // Blocks start on a multiple of their width.
  while (this->Values.size() % static_cast<std::size_t>(lanes) != 0)
  {
    this->Values.push_back(0.0);
  }
  for (int first = 1; first <= degree; first += lanes)
  {
    std::vector<OrderPolynomials> block;
    for (int m = first; m < first + lanes; ++m)
    {
      block.push_back(m <= degree ? SumOrder(degree, m, coefficients) : OrderPolynomials());
    }
    const auto store = [this, &block](std::vector<Real> ParityPolynomial::*part, int count)
    {
      for (int power = count - 1; power >= 0; --power)
      {
        for (const OrderPolynomials& order : block)
        {
          this->Values.push_back(At(order.Cosine.*part, power));
        }
        for (const OrderPolynomials& order : block)
        {
          this->Values.push_back(At(order.Sine.*part, power));
        }
      }
    };
    store(&ParityPolynomial::Even, EvenCount(degree, first));
    store(&ParityPolynomial::Odd, OddCount(degree, first));
  }
}
} // namespace palpate
