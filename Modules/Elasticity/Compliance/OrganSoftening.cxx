#include "OrganSoftening.h"

#include "HexElasticity.h"
#include "ReducedCompliance.h"
#include "SphereQuadrature.h"
#include "StarMesh.h"
#include "SurfaceCurvature.h"

#include <algorithm>
#include <string>

namespace palpate
{
namespace
{
bool IsHeld(const StarMesh& mesh, const ElasticBed& bed)
{
  return std::any_of(mesh.Faces().begin(), mesh.Faces().end(),
                     [&bed](const StarMesh::Face& face)
                     { return bed.At(StarMesh::At(face, 0.0, 0.0).Direction) > 0.0; });
}
} // namespace

double OrganSoftening::SharpestHollow(const RadialModel& model)
{
  constexpr int LeastDegree = 30;
  double sharpest = 0.0;
  for (const Vector3& direction :
       SphereQuadrature(std::max(LeastDegree, 3 * model.Degree())).Directions)
  {
    const auto sample = model.EvaluateSecondOrder(direction);
    sharpest = std::max(sharpest, -CurvatureAt(direction, sample).Principal[1]);
  }
  return 1.0 / sharpest;
}

int OrganSoftening::DegreeFor(const RadialModel& model) const
{
  const int carried = MostDegreePerElement * this->ElementsAcross;
  if (this->Degree > 0)
  {
    return std::min(this->Degree, carried);
  }
  // Elements cannot bend in waves of fewer than four along a great circle's quarter. Where nothing
  // is sharp a higher degree takes time (1323 right sides instead of 507) that no hand notices.
  return SharpestHollow(model) < SharpHollow ? std::min(DegreeInHollows, carried)
                                             : std::min(UsualDegree, this->ElementsAcross);
}

Status OrganSoftening::Make(const RadialModel& model, const ElasticSolid& solid,
                            const KernelProgress& progress, ComplianceMaps& maps,
                            Account& account) const
{
  // Parts of the time, measured with the defaults.
  constexpr double Assembled = 0.07;
  constexpr double Reduced = 0.8;
  StarMesh mesh;
  StiffnessMatrix stiffness;
  Status status = StarMesh::Make(model, this->ElementsAcross, mesh);
  if (status.IsOk())
  {
    status = AssembleStiffness(mesh, model.CenterWorld(), solid, stiffness);
  }
  if (status.IsOk() && !IsHeld(mesh, solid.Bed))
  {
    status = Status::Failure("Nothing holds the organ: its support is zero on all sides.");
  }
  ReducedCompliance reduced;
  if (status.IsOk())
  {
    account.ElementEdge = mesh.SurfaceEdge();
    account.Unknowns = static_cast<std::size_t>(stiffness.rows());
    status = ReducedCompliance::Make(mesh, stiffness, this->DegreeFor(model),
                                     PartOf(progress, Assembled, Reduced), reduced);
  }
  if (status.IsOk())
  {
    status = ComplianceMaps::Fit(model, solid, reduced, this->Maps, PartOf(progress, Reduced, 1.0),
                                 maps);
  }
  return status.IsOk() && !maps.Check().IsOk()
             ? Status::Failure("The moduli differ too much from place to place, or the support is "
                               "too stiff for them, for maps of degree " +
                               std::to_string(maps.Degree) + "; another degree may help.")
             : status;
}
} // namespace palpate
