#include "UnilateralSphere.h"

#include "GaussLegendre.h"
#include "Units.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <vector>

namespace palpate::test
{
namespace
{
// Mean of a function of the square of the distance from the axis over a ring.
template <typename Function>
double MeanOver(double inner, double outer, const Function& function)
{
  static const GaussLegendre gauss(4);
  double sum = 0.0;
  for (std::size_t i = 0; i < gauss.Nodes.size(); ++i)
  {
    const double part = 0.5 * (1.0 + gauss.Nodes[i]);
    sum +=
        0.5 * gauss.Weights[i] * function(inner * inner + part * (outer * outer - inner * inner));
  }
  return sum;
}
} // namespace

UnilateralSphere::UnilateralSphere(const LayeredSphere& sphere, double reach, int rings)
    : SphereRadius(sphere.Radius()), Edges(Eigen::VectorXd::LinSpaced(rings + 1, 0.0, reach)),
      Softness(Eigen::MatrixXd::Zero(rings, rings))
{
  static const GaussLegendre gauss(4);
  const int degrees = static_cast<int>(12.0 * rings * this->SphereRadius / reach);
  const std::size_t nodes = gauss.Nodes.size();
  const std::size_t places = nodes * static_cast<std::size_t>(rings);
  // Legendre's recurrence at all places at once.
  std::vector<double> cosine(places);
  std::vector<double> sine(places);
  std::vector<double> weight(places);
  std::vector<double> previous(places, 0.0);
  std::vector<double> current(places, 1.0);
  for (std::size_t i = 0; i < places; ++i)
  {
    const auto ring = static_cast<Eigen::Index>(i / nodes);
    const double inner = this->Edges[ring] * this->Edges[ring];
    const double outer = this->Edges[ring + 1] * this->Edges[ring + 1];
    const double part = 0.5 * (1.0 + gauss.Nodes[i % nodes]);
    sine[i] = std::sqrt(inner + part * (outer - inner)) / this->SphereRadius;
    cosine[i] = std::sqrt(1.0 - sine[i] * sine[i]);
    weight[i] = 0.5 * gauss.Weights[i % nodes];
  }
  Eigen::MatrixXd traction(2, rings);
  for (int l = 0; l <= degrees; ++l)
  {
    const double norm = std::sqrt((2.0 * l + 1.0) / (4.0 * Pi));
    traction.setZero();
    for (std::size_t i = 0; i < places; ++i)
    {
      const auto ring = static_cast<Eigen::Index>(i / nodes);
      const double slope = l * (cosine[i] * current[i] - previous[i]) / sine[i];
      traction(0, ring) += weight[i] * norm * cosine[i] * current[i];
      traction(1, ring) -= weight[i] * norm * sine[i] * slope;
      const double next = ((2.0 * l + 1.0) * cosine[i] * current[i] - l * previous[i]) / (l + 1.0);
      previous[i] = current[i];
      current[i] = next;
    }
    const double product = static_cast<double>(l) * (l + 1);
    Eigen::Matrix2d response = sphere.Response(l);
    response.col(1) *= product > 0.0 ? 1.0 / product : 0.0;
    this->Softness += traction.transpose() * response * traction;
  }
  this->Softness /= this->SphereRadius * this->SphereRadius;
}

double UnilateralSphere::Force(double ballRadius, double depth) const
{
  const Eigen::Index rings = this->Softness.rows();
  Eigen::VectorXd overlap(rings);
  for (Eigen::Index i = 0; i < rings; ++i)
  {
    const auto drop = [](double radius, double square)
    { return square < radius * radius ? radius - std::sqrt(radius * radius - square) : radius; };
    overlap[i] =
        MeanOver(this->Edges[i], this->Edges[i + 1],
                 [&](double square)
                 { return depth - drop(ballRadius, square) - drop(this->SphereRadius, square); });
  }
  // The patch is a disc: its last ring is the last with a positive force.
  Eigen::Index count = rings;
  Eigen::VectorXd forces;
  bool isPositive = false;
  while (count > 0 && !isPositive)
  {
    forces = this->Softness.topLeftCorner(count, count).ldlt().solve(overlap.head(count));
    isPositive = forces[count - 1] > 0.0;
    count -= isPositive ? 0 : 1;
  }
  return isPositive ? forces.sum() : 0.0;
}
} // namespace palpate::test
