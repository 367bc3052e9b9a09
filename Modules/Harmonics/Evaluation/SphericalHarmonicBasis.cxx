#include "SphericalHarmonicBasis.h"

#include <cmath>

namespace palpate
{
namespace
{
// Columns of high order start far below the smallest number near the poles and grow back, so they
// are scaled by 2^(256 scale).
constexpr int ScaleBits = 256;
constexpr double ScaleUp = 0x1p256;

// (x + iy)^m, and its scale.
struct Power
{
  void Advance(double x, double y)
  {
    const double real = this->Real * x - this->Imaginary * y;
    this->Imaginary = this->Real * y + this->Imaginary * x;
    this->Real = real;
    if (std::abs(this->Real) + std::abs(this->Imaginary) < 1.0 / ScaleUp)
    {
      this->Real *= ScaleUp;
      this->Imaginary *= ScaleUp;
      ++this->Scale;
    }
  }

  double Real = 1.0;
  double Imaginary = 0.0;
  int Scale = 0;
};

// State of the recurrence over the degrees of one order; see SphericalHarmonicRecurrence.
struct Column
{
  void Advance(const SphericalHarmonicRecurrence::Term& term, double depth)
  {
    this->Difference = term.Carry * this->Difference - term.Slope * depth * this->Value;
    this->Value = term.Ratio * this->Value + this->Difference;
    if (this->Scale > 0 && std::abs(this->Value) > ScaleUp)
    {
      this->Value /= ScaleUp;
      this->Difference /= ScaleUp;
      --this->Scale;
    }
  }
  double Unscaled() const
  {
    return this->Scale == 0 ? this->Value : std::ldexp(this->Value, -this->Scale * ScaleBits);
  }

  double Value;
  int Scale;
  double Difference = 0.0;
};

// Writes Y_lm and Y_l,-m for all degrees of one order.
void StoreOrder(const SphericalHarmonicRecurrence& recurrence, int m, const Power& power,
                double depth, double pole, double* values)
{
  Column column{recurrence.Diagonal(m), power.Scale};
  const SphericalHarmonicRecurrence::Term* term = recurrence.Column(m);
  double sign = 1.0;
  for (int l = m;; ++l, ++term, sign *= pole)
  {
    const double q = sign * column.Unscaled();
    values[SphericalHarmonicBasis::Index(l, m)] = q * power.Real;
    if (m > 0)
    {
      values[SphericalHarmonicBasis::Index(l, -m)] = q * power.Imaginary;
    }
    if (l == recurrence.Degree())
    {
      return;
    }
    column.Advance(*term, depth);
  }
}
} // namespace

void SphericalHarmonicBasis::Evaluate(const Vector3& direction, double* values) const noexcept
{
  const double square = direction.x() * direction.x() + direction.y() * direction.y();
  const double squares = square + direction.z() * direction.z();
  const double length = std::sqrt(squares);
  // 1 - |z| of the exactly normalised direction, without the rounding of z.
  const double depth = square / (squares + std::abs(direction.z()) * length);
  const double pole = direction.z() < 0.0 ? -1.0 : 1.0;
  Power power;
  power.Real = length / length; // 1, or NaN for an invalid direction
  for (int m = 0; m <= this->Degree(); ++m)
  {
    StoreOrder(this->Recurrence, m, power, depth, pole, values);
    power.Advance(direction.x() / length, direction.y() / length);
  }
}
} // namespace palpate
