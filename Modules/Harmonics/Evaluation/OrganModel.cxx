#include "OrganModel.h"

#include "SphericalHarmonicBasis.h"

#include <cmath>
#include <numeric>

namespace palpate
{
int DegreeOf(const OrganModel& model) noexcept
{
  const auto* radial = std::get_if<RadialModel>(&model);
  return radial != nullptr ? radial->Degree() : std::get_if<SurfaceModel>(&model)->Degree();
}

std::size_t CoefficientCountOf(const OrganModel& model) noexcept
{
  const std::size_t harmonics = SphericalHarmonicBasis::CoefficientCount(DegreeOf(model));
  return std::holds_alternative<RadialModel>(model) ? harmonics : 3 * harmonics;
}

Vector3 CenterOf(const OrganModel& model) noexcept
{
  if (const auto* radial = std::get_if<RadialModel>(&model))
  {
    return radial->CenterWorld();
  }
  const auto* surface = std::get_if<SurfaceModel>(&model);
  Vector3 sums;
  for (int axis = 0; axis < 3; ++axis)
  {
    sums[axis] = surface->Coefficients(axis).front();
  }
  return sums / std::sqrt(4.0 * M_PI);
}

std::vector<double> PowerSpectrumOf(const OrganModel& model)
{
  if (const auto* radial = std::get_if<RadialModel>(&model))
  {
    return radial->PowerSpectrum();
  }
  const auto& surface = std::get<SurfaceModel>(model);
  std::vector<double> power(static_cast<std::size_t>(surface.Degree()) + 1, 0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double* entry = surface.Coefficients(axis).data();
    for (std::size_t l = 0; l < power.size(); ++l)
    {
      const double* end = entry + 2 * l + 1;
      power[l] = std::inner_product(entry, end, entry, power[l]);
      entry = end;
    }
  }
  return power;
}
} // namespace palpate
