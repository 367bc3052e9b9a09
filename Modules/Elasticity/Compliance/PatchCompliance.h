#pragma once

#include <array>
#include <cstddef>

namespace palpate
{
/// The compliance c(a) (mm/N) of a place to Hertz bumps of radius a (mm) up to a largest one: a
/// c(a) is smooth, and kept as a sum of Chebyshev polynomials.
struct PatchCompliance
{
  static constexpr std::size_t Terms = 7;
  /// Values of the polynomials, and their first two derivatives by a.
  struct Polynomials
  {
    std::array<double, Terms> Value;
    std::array<double, Terms> First;
    std::array<double, Terms> Second;
  };
  /// c and its derivatives: mm/N, 1/N, 1/(N mm).
  struct Value
  {
    double Compliance;
    double First;
    double Second;
  };

  std::array<double, Terms> Coefficients; ///< of a c(a), mm^2/N
  double LargestRadius;                   ///< mm

  Value At(double radius) const noexcept;
  static Polynomials PolynomialsAt(double radius, double largestRadius) noexcept;
  /// The radii (mm) at which values of a c(a) determine the coefficients, and these from those.
  static std::array<double, Terms> Nodes(double largestRadius) noexcept;
  static std::array<double, Terms> Interpolate(const std::array<double, Terms>& atNodes) noexcept;
};
} // namespace palpate
