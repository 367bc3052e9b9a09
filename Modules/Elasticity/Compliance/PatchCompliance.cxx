#include "PatchCompliance.h"

#include "Units.h"

#include <cmath>

namespace palpate
{
namespace
{
double AngleOf(std::size_t node) noexcept
{
  return Pi * (static_cast<double>(node) + 0.5) / PatchCompliance::Terms;
}
} // namespace

PatchCompliance::Polynomials PatchCompliance::PolynomialsAt(double radius,
                                                            double largestRadius) noexcept
{
  const double scale = 2.0 / largestRadius;
  const double x = scale * radius - 1.0;
  Polynomials p{};
  p.Value[0] = 1.0;
  p.Value[1] = x;
  p.First[1] = scale;
  for (std::size_t i = 2; i < Terms; ++i)
  {
    p.Value[i] = 2.0 * x * p.Value[i - 1] - p.Value[i - 2];
    p.First[i] = 2.0 * (scale * p.Value[i - 1] + x * p.First[i - 1]) - p.First[i - 2];
    p.Second[i] = 2.0 * (2.0 * scale * p.First[i - 1] + x * p.Second[i - 1]) - p.Second[i - 2];
  }
  return p;
}

PatchCompliance::Value PatchCompliance::At(double radius) const noexcept
{
  const Polynomials p = PolynomialsAt(radius, this->LargestRadius);
  double y = 0.0;
  double first = 0.0;
  double second = 0.0;
  for (std::size_t i = 0; i < Terms; ++i)
  {
    y += this->Coefficients[i] * p.Value[i];
    first += this->Coefficients[i] * p.First[i];
    second += this->Coefficients[i] * p.Second[i];
  }
  const double c = y / radius;
  const double slope = (first - c) / radius;
  return {c, slope, (second - 2.0 * slope) / radius};
}

std::array<double, PatchCompliance::Terms> PatchCompliance::Nodes(double largestRadius) noexcept
{
  std::array<double, Terms> nodes{};
  for (std::size_t i = 0; i < Terms; ++i)
  {
    nodes[i] = 0.5 * largestRadius * (1.0 + std::cos(AngleOf(i)));
  }
  return nodes;
}

std::array<double, PatchCompliance::Terms>
PatchCompliance::Interpolate(const std::array<double, Terms>& atNodes) noexcept
{
  std::array<double, Terms> coefficients{};
  for (std::size_t j = 0; j < Terms; ++j)
  {
    for (std::size_t i = 0; i < Terms; ++i)
    {
      coefficients[j] +=
          (j == 0 ? 1.0 : 2.0) / Terms * atNodes[i] * std::cos(static_cast<double>(j) * AngleOf(i));
    }
  }
  return coefficients;
}
} // namespace palpate
