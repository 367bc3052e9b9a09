#include "SharpGrid.h"

#include "GaussLegendre.h"
#include "SphericalHarmonicBasis.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <libsharp/sharp_almhelpers.h>
#include <libsharp/sharp_geomhelpers.h>
#include <omp.h>

namespace palpate::bench
{
struct SharpGrid::Plan
{
  sharp_alm_info* Order = nullptr;
  sharp_geom_info* Geometry = nullptr;
  std::vector<std::complex<double>> Coefficients;

  Plan() = default;
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;
  ~Plan()
  {
    sharp_destroy_alm_info(this->Order);
    sharp_destroy_geom_info(this->Geometry);
  }
};

namespace
{
// The coefficient of the complex orthonormal harmonic with the Condon-Shortley phase, m >= 0.
std::complex<double> Complex(const std::vector<double>& coefficients, int l, int m)
{
  const double real = coefficients[SphericalHarmonicBasis::Index(l, m)];
  if (m == 0)
  {
    return {real, 0.0};
  }
  const double scale = (m % 2 == 0 ? 1.0 : -1.0) / std::sqrt(2.0);
  return {scale * real, -scale * coefficients[SphericalHarmonicBasis::Index(l, -m)]};
}
} // namespace

SharpGrid::SharpGrid(int degree, const std::vector<double>& coefficients, int rings, int columns)
    : Work(std::make_unique<Plan>())
{
  omp_set_num_threads(1); // the comparison is on one core
  sharp_make_triangular_alm_info(degree, degree, 1, &this->Work->Order);
  sharp_make_gauss_geom_info(rings, columns, 0.0, 1, columns, &this->Work->Geometry);
  this->Work->Coefficients.resize(static_cast<std::size_t>((degree + 1) * (degree + 2) / 2));
  for (int l = 0; l <= degree; ++l)
  {
    for (int m = 0; m <= l; ++m)
    {
      const auto place = static_cast<std::size_t>(sharp_alm_index(this->Work->Order, l, m));
      this->Work->Coefficients[place] = Complex(coefficients, l, m);
    }
  }
  std::vector<double> nodes = GaussLegendre(rings).Nodes;
  std::reverse(nodes.begin(), nodes.end()); // from north to south
  for (const double z : nodes)
  {
    for (int i = 0; i < columns; ++i)
    {
      const double phi = 2.0 * M_PI * i / columns;
      const double sine = std::sqrt((1.0 - z) * (1.0 + z));
      this->Nodes.emplace_back(sine * std::cos(phi), sine * std::sin(phi), z);
    }
  }
  for (std::vector<double>* map : {&this->Radii, &this->AlongTheta, &this->AlongPhi})
  {
    map->resize(this->Nodes.size());
  }
}

SharpGrid::~SharpGrid() = default;

void SharpGrid::Run()
{
  void* alm = this->Work->Coefficients.data();
  void* radii = this->Radii.data();
  void* slopes[2] = {this->AlongTheta.data(), this->AlongPhi.data()};
  constexpr int Flags = SHARP_DP;
  sharp_execute(SHARP_ALM2MAP, 0, &alm, &radii, this->Work->Geometry, this->Work->Order, Flags,
                nullptr, nullptr);
  sharp_execute(SHARP_ALM2MAP_DERIV1, 1, &alm, slopes, this->Work->Geometry, this->Work->Order,
                Flags, nullptr, nullptr);
}

RadialModel::Sample SharpGrid::At(std::size_t node) const
{
  const Vector3& u = this->Nodes[node];
  const Vector3 across(u.x(), u.y(), 0.0);
  const double sine = across.norm();
  const Vector3 theta = u.z() / sine * across - sine * Vector3::UnitZ();
  const Vector3 phi = Vector3::UnitZ().cross(across) / sine;
  return {this->Radii[node], this->AlongTheta[node] * theta + this->AlongPhi[node] * phi};
}
} // namespace palpate::bench
