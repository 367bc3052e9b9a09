#include "SurfacePolynomialTable.h"

#include "OrderPolynomials.h"

namespace palpate
{
namespace
{
using Coefficients = std::array<std::vector<double>, 3>;

// Of one order, for x, y and z.
using CoordinatePolynomials = std::array<OrderPolynomials, 3>;

CoordinatePolynomials SumOrders(int degree, int order, const Coefficients& coefficients)
{
  CoordinatePolynomials sums;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    sums[axis] = SumOrder(degree, order, coefficients[axis]);
  }
  return sums;
}

void AddZonal(int degree, const Coefficients& coefficients, CacheLineVector<double>& table)
{
  const CoordinatePolynomials zonal = SumOrders(degree, 0, coefficients);
  for (int power = degree / 2; power >= 0; --power)
  {
    for (const auto part : {&ParityPolynomial::Even, &ParityPolynomial::Odd})
    {
      for (const OrderPolynomials& coordinate : zonal)
      {
        table.push_back(PolynomialTerm(coordinate.Cosine.*part, power));
      }
      table.push_back(0.0);
    }
  }
}

void AddPair(int degree, int order, const Coefficients& coefficients,
             CacheLineVector<double>& table)
{
  const std::array<CoordinatePolynomials, 2> orders{SumOrders(degree, order, coefficients),
                                                    SumOrders(degree, order + 1, coefficients)};
  for (const auto part : {&ParityPolynomial::Even, &ParityPolynomial::Odd})
  {
    for (int power = (degree - order) / 2; power >= 0; --power)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        for (const CoordinatePolynomials& sums : orders)
        {
          table.push_back(PolynomialTerm(sums[axis].Cosine.*part, power));
          table.push_back(PolynomialTerm(sums[axis].Sine.*part, power));
        }
      }
    }
  }
}
} // namespace

CacheLineVector<double> MakeSurfacePolynomialTable(int degree, const Coefficients& coefficients)
{
  CacheLineVector<double> table;
  AddZonal(degree, coefficients, table);
  for (int order = degree - 1; order >= 1; order -= 2)
  {
    AddPair(degree, order, coefficients, table);
  }
  return table;
}
} // namespace palpate
