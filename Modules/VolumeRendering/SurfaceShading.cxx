#include "SurfaceShading.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
SurfaceShading::SurfaceShading(const SurfaceFinish& finish, const std::vector<SurfaceLight>& lights)
    : Finish(finish), Lights(lights),
      HasPlaces(std::any_of(lights.begin(), lights.end(),
                            [](const SurfaceLight& light) { return light.IsPositional; }))
{
  for (SurfaceLight& light : this->Lights)
  {
    light.Diffuse *= finish.Diffuse;
    light.Specular *= finish.Specular;
  }
  constexpr double MostFactors = 256.0;
  const double power = finish.SpecularPower;
  this->IsWholePower = power >= 0.0 && power <= MostFactors && std::floor(power) == power;
  if (this->IsWholePower)
  {
    this->WholePower = static_cast<unsigned int>(power);
  }
}

double SurfaceShading::BrokenPower(double base) const noexcept
{
  return std::pow(base, this->Finish.SpecularPower);
}
} // namespace palpate
