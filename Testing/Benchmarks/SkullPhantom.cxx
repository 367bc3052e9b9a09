#include "SkullPhantom.h"

#include "FieldBuilder.h"

#include <cmath>
#include <random>
#include <stdexcept>

namespace palpate::bench
{
SkullPhantom::SkullPhantom(int nodes)
    : Grid({nodes, nodes, nodes}, {-70.0, -80.0, 25.0}, Vector3::Constant(0.8),
           Matrix3::Identity()),
      CenterWorld(Grid.PointWorld(Vector3::Constant(0.5 * (nodes - 1))))
{
  std::mt19937 random(5);
  const Vector3 halfAxes = this->HalfAxes();
  this->Samples.reserve(this->Grid.NodeCount());
  for (int k = 0; k < nodes; ++k)
  {
    for (int j = 0; j < nodes; ++j)
    {
      for (int i = 0; i < nodes; ++i)
      {
        const Vector3 p = this->Grid.PointWorld(Vector3(i, j, k)) - this->CenterWorld;
        const double depth = (1.0 - p.cwiseQuotient(halfAxes).norm()) * halfAxes.minCoeff();
        const double bone = 1200.0 * std::exp(-0.5 * depth * depth / (1.6 * 1.6));
        const double rest = depth < -5.0 ? -1000.0 : 30.0;
        this->Samples.push_back(
            static_cast<std::int16_t>(rest + bone + static_cast<double>(random() % 17) - 8.0));
      }
    }
  }
}

std::shared_ptr<const ScalarField> SkullPhantom::MakeField(FieldInterpolation interpolation) const
{
  FieldBuilder builder(this->Grid);
  builder.AddMaterial(
      {builder.AddChannel(SamplesOfGrid(this->Samples.data(), this->Grid)), BoneIso});
  builder.SetInterpolation(interpolation);
  std::shared_ptr<const ScalarField> field;
  const Status status = builder.Build(field);
  if (!status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
  return field;
}

Vector3 SkullPhantom::HalfAxes() const
{
  return 0.4 * this->Grid.Spacing().cwiseProduct(Vector3(
                   this->Grid.Size()[0], 1.1 * this->Grid.Size()[1], 0.95 * this->Grid.Size()[2]));
}

Vector3 SkullPhantom::PointInBoneWorld(const Vector3& direction) const
{
  return this->CenterWorld + direction / direction.cwiseQuotient(this->HalfAxes()).norm();
}
} // namespace palpate::bench
