#include "SphereFlow.h"

#include <cstddef>

namespace palpate
{
SphereFlow::SphereFlow(int degree) : Basis(degree) {}

void SphereFlow::Shorten(double share)
{
  for (Field& step : this->Steps)
  {
    step *= share;
  }
}

void SphereFlow::Map(std::vector<Vector3>& directions) const
{
  for (const Field& step : this->Steps)
  {
    Move(this->TangentsOf(step, directions), 1.0, directions);
  }
}

std::vector<Vector3> SphereFlow::TangentsOf(const Field& field,
                                            const std::vector<Vector3>& directions) const
{
  Eigen::VectorXd harmonics(static_cast<Eigen::Index>(this->Basis.Size()));
  std::vector<Vector3> tangents(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    const Vector3& u = directions[i];
    this->Basis.Evaluate(u, harmonics.data());
    const Vector3 vector = field * harmonics;
    tangents[i] = vector - vector.dot(u) * u;
  }
  return tangents;
}

void SphereFlow::Move(const std::vector<Vector3>& tangents, double share,
                      std::vector<Vector3>& directions)
{
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    directions[i] = (directions[i] + share * tangents[i]).normalized();
  }
}
} // namespace palpate
