#include "PolynomialTable.h"

#include "OrderPolynomials.h"

#include <array>

namespace palpate
{
namespace
{
void AddZonal(int degree, const std::vector<double>& coefficients, CacheLineVector<double>& table)
{
  const ParityPolynomial zonal = SumOrder(degree, 0, coefficients).Cosine;
  for (int square = degree / 4; square >= 0; --square)
  {
    table.push_back(PolynomialTerm(zonal.Even, 2 * square));
    table.push_back(PolynomialTerm(zonal.Even, 2 * square + 1));
    table.push_back(PolynomialTerm(zonal.Odd, 2 * square));
    table.push_back(PolynomialTerm(zonal.Odd, 2 * square + 1));
  }
}

void AddBlock(int degree, int first, const std::vector<double>& coefficients,
              CacheLineVector<double>& table)
{
  std::array<OrderPolynomials, 4> block;
  for (int lane = 0; lane < 4 && first + lane <= degree; ++lane)
  {
    block[static_cast<std::size_t>(lane)] = SumOrder(degree, first + lane, coefficients);
  }
  const auto store = [&table, &block](std::vector<long double> ParityPolynomial::*part, int count)
  {
    for (int power = count - 1; power >= 0; --power)
    {
      for (const OrderPolynomials& order : block)
      {
        table.push_back(PolynomialTerm(order.Cosine.*part, power));
      }
      for (const OrderPolynomials& order : block)
      {
        table.push_back(PolynomialTerm(order.Sine.*part, power));
      }
    }
  };
  store(&ParityPolynomial::Even, (degree - first) / 2 + 1);
  store(&ParityPolynomial::Odd, (degree - first + 1) / 2);
}
} // namespace

CacheLineVector<double> MakePolynomialTable(int degree, const std::vector<double>& coefficients)
{
  CacheLineVector<double> table;
  AddZonal(degree, coefficients, table);
  for (int first = 1; first <= degree; first += 4)
  {
    AddBlock(degree, first, coefficients, table);
  }
  return table;
}

} // namespace palpate
