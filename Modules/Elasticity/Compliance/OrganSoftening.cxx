#include "OrganSoftening.h"

#include "HexElasticity.h"
#include "ReducedCompliance.h"
#include "StarMesh.h"

namespace palpate
{
Status OrganSoftening::Make(const SphericalHarmonicModel& model, const ElasticSolid& solid,
                            const KernelProgress& progress, ComplianceMaps& maps,
                            Account& account) const
{
  // Parts of the time, measured with the defaults.
  constexpr double Assembled = 0.03;
  constexpr double Reduced = 0.85;
  const auto between = [&](double from, double to)
  {
    return [&progress, from, to](double fraction)
    { return !progress || progress(from + fraction * (to - from)); };
  };
  StarMesh mesh;
  StiffnessMatrix stiffness;
  Status status = StarMesh::Make(model, this->ElementsAcross, mesh);
  if (status.IsOk())
  {
    status = AssembleStiffness(mesh, model.CenterWorld(), solid, stiffness);
  }
  ReducedCompliance reduced;
  if (status.IsOk())
  {
    account.ElementEdge = mesh.SurfaceEdge();
    account.Unknowns = static_cast<std::size_t>(stiffness.rows());
    status = ReducedCompliance::Make(mesh, stiffness, this->Degree, between(Assembled, Reduced),
                                     reduced);
  }
  return status.IsOk()
             ? ComplianceMaps::Fit(model, solid, reduced, this->Maps, between(Reduced, 1.0), maps)
             : status;
}
} // namespace palpate
