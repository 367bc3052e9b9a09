#include "LocalCompliance.h"

#include "GaussLegendre.h"
#include "ReducedCompliance.h"
#include "Units.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// Part of a wave's strain energy above the depth t/k.
double EnergyAbove(double t) noexcept
{
  return 1.0 - std::exp(-2.0 * t) * (1.0 + 2.0 * t + 2.0 * t * t);
}

// Of a layer that takes `part` of the energy, on a ground. A stiff ground stops the wave: the mean
// of the softness. Ground that is softer than the organ's tissue is bridged by tissue above it,
// which reaches far: the mean of the root of the modulus. A hard part, which ends soon, bridges
// nothing.
double Layered(double layer, double ground, double part, double tissue) noexcept
{
  const double bridge = std::max(layer, tissue);
  if (ground <= bridge)
  {
    return part * layer + (1.0 - part) * ground;
  }
  const double root = part / std::sqrt(bridge) + (1.0 - part) / std::sqrt(ground);
  return part * (layer - bridge) + 1.0 / (root * root);
}
} // namespace

LocalCompliance::LocalCompliance(const ElasticSolid& solid, const Vector3& centerWorld, int degree)
    : Solid(&solid), CenterWorld(centerWorld), Degree(degree)
{
  constexpr double First = 0.02; // mm
  constexpr double Growth = 1.15;
  double depth = First;
  for (std::size_t i = 0; i < Depths; ++i)
  {
    this->Nodes[i] = depth;
    this->Limits[i] = depth * std::sqrt(Growth);
    depth *= Growth;
  }
}

std::array<double, LocalCompliance::Depths>
LocalCompliance::SoftnessBelow(const HertzPatch& patch) const
{
  // Weights and radius of the mean were found by comparison with finite elements.
  constexpr double AtCenter = 0.15;
  constexpr double Ring = 0.45; // of the patch's radius
  constexpr int Places = 6;
  const double nu = this->Solid->PoissonRatio;
  const Vector3 first = patch.Normal.unitOrthogonal();
  const Vector3 second = patch.Normal.cross(first);
  std::array<double, Depths> softness{};
  for (std::size_t i = 0; i < Depths; ++i)
  {
    const Vector3 below = this->CenterWorld + patch.Point - this->Nodes[i] * patch.Normal;
    double modulus = AtCenter * this->Solid->Tissue.Modulus(below);
    for (int place = 0; place < Places; ++place)
    {
      const double angle = 2.0 * Pi * place / Places;
      const Vector3 aside = std::cos(angle) * first + std::sin(angle) * second;
      modulus += (1.0 - AtCenter) / Places *
                 this->Solid->Tissue.Modulus(below + Ring * patch.Radius * aside);
    }
    softness[i] = (1.0 - nu * nu) / modulus;
  }
  return softness;
}

// From the deepest layer up: each on what is below it.
double LocalCompliance::Softness(const std::array<double, Depths>& below, double waveNumber) const
{
  const double nu = this->Solid->PoissonRatio;
  const double tissue = (1.0 - nu * nu) / this->Solid->Tissue.OwnModulus();
  double softness = 0.0;
  double energy = 0.0; // of the layers that it is of
  double last = 1.0;
  for (std::size_t i = Depths; i-- > 0;)
  {
    const double above = i > 0 ? EnergyAbove(waveNumber * this->Limits[i - 1]) : 0.0;
    const double own = last - above;
    last = above;
    if (!(own > 0.0))
    {
      continue;
    }
    energy += own;
    softness = Layered(below[i], softness, own / energy, tissue);
  }
  return softness;
}

double LocalCompliance::At(const HertzPatch& patch) const
{
  constexpr double Last = 20.0; // k a; what is beyond has a closed form
  static const GaussLegendre gauss(16);
  const double distance = patch.Point.norm();
  const Vector3 direction = patch.Point / distance;
  const double radius = distance / (0.5 * (1.0 + patch.Normal.dot(direction)));
  const double bed = this->Solid->Bed.At(direction);
  const std::array<double, Depths> below = this->SoftnessBelow(patch);
  const auto stiffness = [&](double k) { return 0.5 * k / this->Softness(below, k) + bed; };
  const auto integral = [&](double from, double to)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < gauss.Nodes.size(); ++i)
    {
      const double k = 0.5 * (from + to + (to - from) * gauss.Nodes[i]);
      const double spectrum = HertzPatch::Spectrum(k * patch.Radius);
      const double window = ReducedCompliance::Window(k * radius - 0.5, this->Degree);
      sum += 0.5 * (to - from) * gauss.Weights[i] * k * spectrum * spectrum *
             (1.0 - window * window) / stiffness(k);
    }
    return sum;
  };
  const double first = (0.5 * this->Degree + 0.5) / radius;
  const double end = (this->Degree + 1.0) / radius;
  const double middle = std::max(end, 4.0 / patch.Radius);
  const double last = std::max(middle, Last / patch.Radius);
  // Beyond, P^2 is 9/(k a)^4 times a squared cosine, whose mean is a half.
  const double tail =
      1.5 / (std::pow(patch.Radius, 4) * std::pow(last, 3)) * last / stiffness(last);
  return (integral(first, end) + integral(end, middle) + integral(middle, last) + tail) /
         (2.0 * Pi);
}
} // namespace palpate
