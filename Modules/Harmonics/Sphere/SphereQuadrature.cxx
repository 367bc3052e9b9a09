#include "SphereQuadrature.h"

#include "GaussLegendre.h"

#include <cmath>

namespace palpate
{
SphereQuadrature::SphereQuadrature(int degree)
{
  const GaussLegendre latitude(degree / 2 + 1);
  const int longitudes = degree + 1;
  const double step = 2.0 * M_PI / longitudes;
  this->Directions.reserve(latitude.Nodes.size() * static_cast<std::size_t>(longitudes));
  this->Weights.reserve(this->Directions.capacity());
  for (std::size_t i = 0; i < latitude.Nodes.size(); ++i)
  {
    const double z = latitude.Nodes[i];
    const double s = std::sqrt((1.0 - z) * (1.0 + z));
    for (int j = 0; j < longitudes; ++j)
    {
      this->Directions.emplace_back(s * std::cos(j * step), s * std::sin(j * step), z);
      this->Weights.push_back(latitude.Weights[i] * step);
    }
  }
}
} // namespace palpate
