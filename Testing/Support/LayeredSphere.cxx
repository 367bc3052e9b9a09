#include "LayeredSphere.h"

#include "GaussLegendre.h"
#include "Units.h"

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace palpate
{
namespace
{
// One solution r^power of Navier's equation for a degree: displacement (U, V) and the traction
// (radial, tangential) on spheres, for the shear modulus 1 and radii as parts of a length.
struct PowerSolution
{
  double Power;
  double U;
  double V;
  double Radial;
  double Tangential;
};

PowerSolution SolutionOf(int degree, double power, double poissonRatio)
{
  const double product = static_cast<double>(degree) * (degree + 1);
  const double kappa = 1.0 / (1.0 - 2.0 * poissonRatio);
  // Rows of the equation's radial and tangential parts; the solution is orthogonal to both.
  const double spread = kappa * (power + 2.0);
  const Eigen::Vector2d radial(power * (power + 1.0) - product - 2.0 + (power - 1.0) * spread,
                               product * (2.0 - kappa * (power - 1.0)));
  const Eigen::Vector2d tangential(2.0 + spread, power * (power + 1.0) - product * (1.0 + kappa));
  const Eigen::Vector2d& row = radial.norm() > tangential.norm() ? radial : tangential;
  PowerSolution s{power, 1.0, 0.0, 0.0, 0.0};
  if (degree > 0)
  {
    s.U = -row[1] / row.norm();
    s.V = row[0] / row.norm();
  }
  const double lambda = 2.0 * poissonRatio * kappa;
  s.Radial = lambda * ((power + 2.0) * s.U - product * s.V) + 2.0 * power * s.U;
  s.Tangential = (power - 1.0) * s.V + s.U;
  return s;
}

// The solutions of one layer: those regular at the centre first.
std::vector<PowerSolution> SolutionsOf(int degree, bool isCore, double poissonRatio)
{
  std::vector<double> powers;
  if (degree > 0)
  {
    powers = {degree - 1.0, degree + 1.0, -static_cast<double>(degree), -degree - 2.0};
  }
  else
  {
    powers = {1.0, -2.0};
  }
  powers.resize(isCore ? powers.size() / 2 : powers.size());
  std::vector<PowerSolution> solutions;
  for (const double power : powers)
  {
    solutions.push_back(SolutionOf(degree, power, poissonRatio));
  }
  return solutions;
}

// U, V and tractions of a layer's solutions at a radius, scaled to 1 where they are largest.
Eigen::MatrixXd ValuesAt(const std::vector<PowerSolution>& solutions, double radius, double inner,
                         double outer, double shear)
{
  Eigen::MatrixXd values(4, static_cast<Eigen::Index>(solutions.size()));
  for (std::size_t i = 0; i < solutions.size(); ++i)
  {
    const PowerSolution& s = solutions[i];
    const double unit = s.Power >= 0.0 ? outer : inner;
    const double scale = std::pow(radius / unit, s.Power);
    values.col(static_cast<Eigen::Index>(i)) =
        scale * Eigen::Vector4d(s.U, s.V, shear / radius * s.Radial, shear / radius * s.Tangential);
  }
  return values;
}

// Y_l0 and its slope in the angle from the pole, for all degrees up to one.
void ZonalHarmonics(double angle, int degree, std::vector<double>& values,
                    std::vector<double>& slopes)
{
  const double x = std::cos(angle);
  const double sine = std::sin(angle);
  double previous = 0.0;
  double current = 1.0;
  for (int l = 0; l <= degree; ++l)
  {
    const double norm = std::sqrt((2.0 * l + 1.0) / (4.0 * Pi));
    const auto i = static_cast<std::size_t>(l);
    values[i] = norm * current;
    slopes[i] = norm * l * (x * current - previous) / sine;
    const double next = ((2.0 * l + 1.0) * x * current - l * previous) / (l + 1.0);
    previous = current;
    current = next;
  }
}
} // namespace

LayeredSphere::LayeredSphere(std::vector<Layer> layers, double poissonRatio, double bedStiffness)
    : Layers(std::move(layers)), PoissonRatio(poissonRatio), BedStiffness(bedStiffness)
{
}

Eigen::Matrix2d LayeredSphere::Response(int degree) const
{
  const int states = degree > 0 ? 2 : 1; // displacements
  const auto parts = static_cast<int>(this->Layers.size());
  const Eigen::Index size = Eigen::Index{states} * (2 * parts - 1);
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(size, size);
  Eigen::MatrixXd surface; // displacements at the surface by the outer layer's solutions
  Eigen::Index column = 0;
  double inner = 0.0;
  for (int part = 0; part < parts; ++part)
  {
    const Layer& layer = this->Layers[static_cast<std::size_t>(part)];
    const double shear = 0.5 * layer.Modulus / (1.0 + this->PoissonRatio);
    const auto solutions = SolutionsOf(degree, part == 0, this->PoissonRatio);
    const auto count = static_cast<Eigen::Index>(solutions.size());
    const auto rowsOf = [states](const Eigen::MatrixXd& all)
    {
      Eigen::MatrixXd rows(2 * states, all.cols());
      rows.topRows(states) = all.topRows(states);
      rows.bottomRows(states) = all.middleRows(2, states);
      return rows;
    };
    // Continuity at the inner and the outer side; the traction is given outside.
    if (part > 0)
    {
      system.block(Eigen::Index{2} * states * (part - 1), column, 2 * states, count) =
          -rowsOf(ValuesAt(solutions, inner, inner, layer.OuterRadius, shear));
    }
    const Eigen::MatrixXd outside =
        rowsOf(ValuesAt(solutions, layer.OuterRadius, inner, layer.OuterRadius, shear));
    if (part + 1 < parts)
    {
      system.block(Eigen::Index{2} * states * part, column, 2 * states, count) = outside;
    }
    else
    {
      surface = outside.topRows(states);
      system.block(size - states, column, states, count) =
          outside.bottomRows(states) + this->BedStiffness * surface;
    }
    column += count;
    inner = layer.OuterRadius;
  }
  Eigen::MatrixXd load = Eigen::MatrixXd::Zero(size, states);
  load.bottomRows(states).setIdentity();
  // Rows of tractions and of displacements have different units.
  for (Eigen::Index row = 0; row < size; ++row)
  {
    const double largest = system.row(row).cwiseAbs().maxCoeff();
    system.row(row) /= largest;
    load.row(row) /= largest;
  }
  const Eigen::MatrixXd amounts = system.fullPivLu().solve(load);
  Eigen::Matrix2d response = Eigen::Matrix2d::Zero();
  response.topLeftCorner(states, states) = surface * amounts.bottomRows(surface.cols());
  return response;
}

double LayeredSphere::Compliance(double patchRadius) const
{
  constexpr int Nodes = 400;
  constexpr double Reach = 40.0; // k a beyond which a bump has less than 1e-6 of its energy
  const double radius = this->Radius();
  const int degree = 20 + static_cast<int>(Reach * radius / patchRadius);
  const auto count = static_cast<std::size_t>(degree + 1);
  std::vector<double> radial(count, 0.0);
  std::vector<double> tangential(count, 0.0);
  std::vector<double> values(count);
  std::vector<double> slopes(count);
  const GaussLegendre gauss(Nodes);
  for (std::size_t i = 0; i < Nodes; ++i)
  {
    // With s = sqrt(1 - (rho/a)^2) the bump's force in a ring is 3 s^2 ds.
    const double s = 0.5 * (1.0 + gauss.Nodes[i]);
    const double force = 1.5 * gauss.Weights[i] * s * s;
    const double sine = patchRadius / radius * std::sqrt(1.0 - s * s);
    const double angle = std::asin(sine);
    ZonalHarmonics(angle, degree, values, slopes);
    for (std::size_t l = 0; l < count; ++l)
    {
      radial[l] += force * std::cos(angle) * values[l];
      tangential[l] -= force * sine * slopes[l];
    }
  }
  double sum = 0.0;
  for (int l = 0; l <= degree; ++l)
  {
    // Work of the traction on grad Y, whose squared norm is l (l + 1).
    const auto i = static_cast<std::size_t>(l);
    const double product = static_cast<double>(l) * (l + 1);
    const Eigen::Vector2d traction(radial[i], product > 0.0 ? tangential[i] / product : 0.0);
    const Eigen::Vector2d moved = this->Response(l) * traction;
    sum += radial[i] * moved[0] + tangential[i] * moved[1];
  }
  return sum / (radius * radius);
}
} // namespace palpate
