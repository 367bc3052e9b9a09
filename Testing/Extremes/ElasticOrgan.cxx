#include "ElasticOrgan.h"

#include <memory>
#include <stdexcept>

namespace palpate::test
{
ElasticOrgan::ElasticOrgan(const RadialModel& model, const ElasticSolid& solid,
                           const CoarseNumbers& numbers)
    : Search(std::make_shared<const RadialModel>(model))
{
  OrganSoftening softening;
  softening.ElementsAcross = numbers.ElementsAcross;
  softening.Degree = numbers.Degree;
  softening.Maps.Degree = numbers.MapDegree;
  OrganSoftening::Account account;
  for (const Status& status :
       {softening.Make(model, solid, {}, this->Values, account), this->Values.Check()})
  {
    if (!status.IsOk())
    {
      throw std::runtime_error(status.Message());
    }
  }
  this->Atlas.emplace(this->Values);
}

double ElasticOrgan::Compliance(const Vector3& direction, double patchRadius) const
{
  return this->Atlas->At(direction).Compliance.At(patchRadius).Compliance;
}

Vector3 ElasticOrgan::CenterAbove(const Vector3& direction, double ballRadius, double depth) const
{
  return this->Model().PointWorld(direction) +
         (ballRadius - depth) * this->Model().Normal(direction);
}

ElasticForce ElasticOrgan::ForceAt(const Vector3& centerWorld, double ballRadius) const
{
  const ClosestPoint foot = this->Search.Nearest(centerWorld);
  return ElasticForce::Of(*this->Atlas, this->Model(), foot.Direction,
                          ballRadius - foot.SignedDistance, ballRadius);
}

ElasticForce ElasticOrgan::Press(const Vector3& direction, double ballRadius, double depth) const
{
  return ElasticForce::Of(*this->Atlas, this->Model(), direction, depth, ballRadius);
}
} // namespace palpate::test
