#include "LatitudeSynthesis.h"

#include "SphericalHarmonicBasis.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
LatitudeSynthesis::LatitudeSynthesis(const SphericalHarmonicModel& model, int longitudeCount)
    : Recurrence(model.Degree()), Coefficients(model.Coefficients())
{
  const auto count = static_cast<std::size_t>(longitudeCount);
  for (std::size_t j = 0; j < count; ++j)
  {
    const double angle = 2.0 * M_PI * static_cast<double>(j) / longitudeCount;
    this->StepCosine.push_back(std::cos(angle));
    this->StepSine.push_back(std::sin(angle));
  }
  for (std::vector<double>* const column :
       {&this->Cosine, &this->Sine, &this->LowerCosine, &this->LowerSine, &this->Radius,
        &this->SlopeX, &this->SlopeY, &this->SlopeZ})
  {
    column->resize(count);
  }
  this->Samples.resize(count);
}

Vector3 LatitudeSynthesis::Direction(double z, std::size_t j) const noexcept
{
  const double s = std::sqrt((1.0 - z) * (1.0 + z));
  return {s * this->StepCosine[j], s * this->StepSine[j], z};
}

const std::vector<SphericalHarmonicModel::Sample>& LatitudeSynthesis::Evaluate(double z)
{
  const double s = std::sqrt((1.0 - z) * (1.0 + z));
  std::fill(this->Cosine.begin(), this->Cosine.end(), 1.0);
  for (std::vector<double>* const column :
       {&this->Sine, &this->LowerCosine, &this->LowerSine, &this->Radius, &this->SlopeX,
        &this->SlopeY, &this->SlopeZ})
  {
    std::fill(column->begin(), column->end(), 0.0);
  }
  double power = 1.0; // s^m
  double lowerPower = 0.0;
  for (int m = 0; m <= this->Recurrence.Degree(); ++m)
  {
    this->AddOrder(this->SumDegrees(m, z, power, lowerPower));
    this->Turn();
    lowerPower = power;
    power *= s;
  }
  this->Store(z);
  return this->Samples;
}

// As in SphericalHarmonicModel: Q_lm and dQ_lm/dz by the recurrence, times the coefficients.
LatitudeSynthesis::OrderSums LatitudeSynthesis::SumDegrees(int order, double z, double power,
                                                           double lowerPower) const noexcept
{
  double previous = 0.0;
  double current = this->Recurrence.Diagonal(order);
  double previousSlope = 0.0;
  double slope = 0.0;
  OrderSums sums{};
  const SphericalHarmonicRecurrence::Term* term = this->Recurrence.Column(order);
  for (int l = order; l <= this->Recurrence.Degree(); ++l)
  {
    if (l > order)
    {
      const double nextSlope = term->A * (current + z * slope - term->B * previousSlope);
      const double next = term->A * (z * current - term->B * previous);
      previous = current;
      current = next;
      previousSlope = slope;
      slope = nextSlope;
      ++term;
    }
    const double cosine = this->Coefficients[SphericalHarmonicBasis::Index(l, order)];
    const double sine =
        order == 0 ? 0.0 : this->Coefficients[SphericalHarmonicBasis::Index(l, -order)];
    sums.Cosine += current * cosine;
    sums.Sine += current * sine;
    sums.CosineSlope += slope * cosine;
    sums.SineSlope += slope * sine;
  }
  sums.LowerCosine = sums.Cosine * order * lowerPower;
  sums.LowerSine = sums.Sine * order * lowerPower;
  sums.Cosine *= power;
  sums.Sine *= power;
  sums.CosineSlope *= power;
  sums.SineSlope *= power;
  return sums;
}

// Adds Re D w^m with w = s (cos a + i sin a), its slope in z, and m D w^(m-1) (1, i).
void LatitudeSynthesis::AddOrder(const OrderSums& sums) noexcept
{
  for (std::size_t j = 0; j < this->Samples.size(); ++j)
  {
    const double cosine = this->Cosine[j];
    const double sine = this->Sine[j];
    const double lowerCosine = this->LowerCosine[j];
    const double lowerSine = this->LowerSine[j];
    this->Radius[j] += sums.Cosine * cosine + sums.Sine * sine;
    this->SlopeX[j] += sums.LowerCosine * lowerCosine + sums.LowerSine * lowerSine;
    this->SlopeY[j] += sums.LowerSine * lowerCosine - sums.LowerCosine * lowerSine;
    this->SlopeZ[j] += sums.CosineSlope * cosine + sums.SineSlope * sine;
  }
}

// From order m to m + 1.
void LatitudeSynthesis::Turn() noexcept
{
  this->LowerCosine.swap(this->Cosine);
  this->LowerSine.swap(this->Sine);
  for (std::size_t j = 0; j < this->Samples.size(); ++j)
  {
    this->Cosine[j] =
        this->LowerCosine[j] * this->StepCosine[j] - this->LowerSine[j] * this->StepSine[j];
    this->Sine[j] =
        this->LowerCosine[j] * this->StepSine[j] + this->LowerSine[j] * this->StepCosine[j];
  }
}

void LatitudeSynthesis::Store(double z) noexcept
{
  for (std::size_t j = 0; j < this->Samples.size(); ++j)
  {
    const Vector3 direction = this->Direction(z, j);
    const Vector3 gradient(this->SlopeX[j], this->SlopeY[j], this->SlopeZ[j]);
    this->Samples[j] = {this->Radius[j], gradient - gradient.dot(direction) * direction};
  }
}
} // namespace palpate
