#include "ElasticPhantom.h"

#include "BallFraction.h"
#include "ElasticForce.h"
#include "OrganSoftening.h"
#include "SphericalHarmonicProjection.h"

#include <cmath>

namespace palpate::test
{
const Vector3 ElasticPhantom::SemiAxes(24.0, 20.0, 22.0);
const FreePlace ElasticPhantom::NodulePlace(4.0, 3.0);

namespace
{
// From the centre to a place of the free side, whose middle is behind (+y, patient LPS).
Vector3 DirectionOf(const FreePlace& place)
{
  const double length = place.norm();
  const double angle = length / ElasticPhantom::SemiAxes.y();
  const FreePlace aside = length > 0.0 ? FreePlace(std::sin(angle) / length * place) : place;
  return {aside.x(), std::cos(angle), aside.y()};
}

RadialModel Ellipsoid()
{
  // The harmonics above add up to less than 0.0001 mm.
  constexpr int Degree = 8;
  const auto radius = [](const Vector3& u)
  { return 1.0 / u.cwiseQuotient(ElasticPhantom::SemiAxes).norm(); };
  return {Degree, ProjectOnHarmonics(Degree, Degree + 40, radius), Vector3::Zero()};
}
} // namespace

Status ElasticPhantom::Make(const std::optional<HiddenNodule>& nodule, int elementsAcross,
                            int degree, ElasticPhantom& phantom)
{
  phantom.Hidden = nodule;
  phantom.Model = Ellipsoid();
  ElasticSolid solid{TissueMap(Tissue), Poisson, ElasticBed(Bed)};
  solid.Bed.Free(Vector3::UnitY(), FreeAngle);
  if (nodule)
  {
    const Vector3 direction = DirectionOf(NodulePlace);
    const double radius = 0.5 * nodule->Diameter;
    solid.Tissue.AddInclusion(
        BallFraction(phantom.Model.PointWorld(direction) -
                         (nodule->Depth + radius) * phantom.Model.Normal(direction),
                     radius),
        nodule->Ratio * Tissue);
  }
  OrganSoftening softening;
  softening.ElementsAcross = elementsAcross;
  softening.Degree = degree;
  ComplianceMaps maps;
  OrganSoftening::Account account;
  Status status = softening.Make(phantom.Model, solid, {}, maps, account);
  if (status.IsOk())
  {
    phantom.Atlas = std::make_shared<const ComplianceAtlas>(maps);
  }
  return status;
}

Vector3 ElasticPhantom::PointWorld(const FreePlace& place) const
{
  return this->Model.PointWorld(DirectionOf(place));
}

double ElasticPhantom::Force(const FreePlace& place, double depth) const
{
  const Vector3 direction = DirectionOf(place);
  const ElasticForce force = ElasticForce::Of(*this->Atlas, this->Model, direction, depth, Ball);
  return force.ForceWorld.dot(this->Model.Normal(direction));
}
} // namespace palpate::test
