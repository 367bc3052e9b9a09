#include "LatitudeSynthesis.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
LatitudeSynthesis::LatitudeSynthesis(const RadialModel& model, int longitudeCount)
    : Basis(model.Degree()), Coefficients(model.Coefficients()), Harmonics(Basis.Size()),
      Sums(static_cast<std::size_t>(model.Degree()) + 1)
{
  for (int l = 0; l <= model.Degree(); ++l)
  {
    for (int m = 0; m <= l; ++m)
    {
      this->Ladder.push_back(std::sqrt(static_cast<double>(l - m) * (l + m + 1)));
    }
  }
  const auto count = static_cast<std::size_t>(longitudeCount);
  for (std::size_t j = 0; j < count; ++j)
  {
    const double angle = 2.0 * M_PI * static_cast<double>(j) / longitudeCount;
    this->StepCosine.push_back(std::cos(angle));
    this->StepSine.push_back(std::sin(angle));
  }
  for (std::vector<double>* const column :
       {&this->Cosine, &this->Sine, &this->Radius, &this->SouthSlope, &this->EastSlope})
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

const std::vector<RadialModel::Sample>& LatitudeSynthesis::Evaluate(double z)
{
  const double s = std::sqrt((1.0 - z) * (1.0 + z));
  this->SumDegrees(z, s);
  std::fill(this->Cosine.begin(), this->Cosine.end(), 1.0);
  for (std::vector<double>* const column :
       {&this->Sine, &this->Radius, &this->SouthSlope, &this->EastSlope})
  {
    std::fill(column->begin(), column->end(), 0.0);
  }
  for (int m = 0; m <= this->Basis.Degree(); ++m)
  {
    this->AddOrder(m, this->Sums[static_cast<std::size_t>(m)]);
    this->Turn();
  }
  this->Store(z, s);
  return this->Samples;
}

// At longitude 0 the harmonics are those of the cosines, B_m, and by the angle from +z
//   B_m' = (Ladder_(m-1) B_(m-1) - Ladder_m B_(m+1)) / 2,
// where B_0 has a factor sqrt(2) in B_1' and B_0' = -Ladder_0 B_1 / sqrt(2): the relation of
// the associated Legendre functions, normalised.
void LatitudeSynthesis::SumDegrees(double z, double s)
{
  this->Basis.Evaluate({s, 0.0, z}, this->Harmonics.data());
  std::fill(this->Sums.begin(), this->Sums.end(), OrderSums());
  const double root2 = std::sqrt(2.0);
  const double* ladder = this->Ladder.data();
  for (int l = 0; l <= this->Basis.Degree(); ++l)
  {
    const double* const b = this->Harmonics.data() + SphericalHarmonicBasis::Index(l, 0);
    const double* const c = this->Coefficients.data() + SphericalHarmonicBasis::Index(l, 0);
    this->Sums[0].Cosine += c[0] * b[0];
    this->Sums[0].CosineSlope -= l == 0 ? 0.0 : c[0] * ladder[0] * b[1] / root2;
    for (int m = 1; m <= l; ++m)
    {
      const double lower = ladder[m - 1] * (m == 1 ? root2 * b[0] : b[m - 1]);
      const double upper = m == l ? 0.0 : ladder[m] * b[m + 1];
      const double slope = 0.5 * (lower - upper);
      OrderSums& sums = this->Sums[static_cast<std::size_t>(m)];
      sums.Cosine += c[m] * b[m];
      sums.Sine += c[-m] * b[m];
      sums.CosineSlope += c[m] * slope;
      sums.SineSlope += c[-m] * slope;
    }
    ladder += l + 1;
  }
}

void LatitudeSynthesis::AddOrder(int order, const OrderSums& sums) noexcept
{
  const double east = order * sums.Sine;
  const double west = order * sums.Cosine;
  for (std::size_t j = 0; j < this->Samples.size(); ++j)
  {
    const double cosine = this->Cosine[j];
    const double sine = this->Sine[j];
    this->Radius[j] += sums.Cosine * cosine + sums.Sine * sine;
    this->SouthSlope[j] += sums.CosineSlope * cosine + sums.SineSlope * sine;
    this->EastSlope[j] += east * cosine - west * sine;
  }
}

// Advances from order m to m + 1.
void LatitudeSynthesis::Turn() noexcept
{
  for (std::size_t j = 0; j < this->Samples.size(); ++j)
  {
    const double cosine = this->Cosine[j];
    const double sine = this->Sine[j];
    this->Cosine[j] = cosine * this->StepCosine[j] - sine * this->StepSine[j];
    this->Sine[j] = cosine * this->StepSine[j] + sine * this->StepCosine[j];
  }
}

void LatitudeSynthesis::Store(double z, double s) noexcept
{
  for (std::size_t j = 0; j < this->Samples.size(); ++j)
  {
    const Vector3 south(z * this->StepCosine[j], z * this->StepSine[j], -s);
    const Vector3 east(-this->StepSine[j], this->StepCosine[j], 0.0);
    this->Samples[j] = {this->Radius[j],
                        this->SouthSlope[j] * south + this->EastSlope[j] / s * east};
  }
}
} // namespace palpate
