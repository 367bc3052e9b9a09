#include "OrganSoftening.h"

#include "HexElasticity.h"
#include "ReducedCompliance.h"
#include "StarMesh.h"

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

// What is known before the long part.
Status CheckTask(const OrganSoftening& task, const StarMesh& mesh, const ElasticSolid& solid)
{
  const int most = OrganSoftening::MostDegreePerElement * task.ElementsAcross;
  if (task.Degree > most)
  {
    return Status::Failure(std::to_string(task.ElementsAcross) +
                           " elements across carry harmonics up to degree " + std::to_string(most) +
                           ": use more elements or a lower degree.");
  }
  return IsHeld(mesh, solid.Bed)
             ? Status::Success()
             : Status::Failure("Nothing holds the organ: its support is zero on all sides.");
}
} // namespace

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
  if (status.IsOk())
  {
    status = CheckTask(*this, mesh, solid);
  }
  ReducedCompliance reduced;
  if (status.IsOk())
  {
    account.ElementEdge = mesh.SurfaceEdge();
    account.Unknowns = static_cast<std::size_t>(stiffness.rows());
    status = ReducedCompliance::Make(mesh, stiffness, this->Degree, between(Assembled, Reduced),
                                     reduced);
  }
  if (status.IsOk())
  {
    status = ComplianceMaps::Fit(model, solid, reduced, this->Maps, between(Reduced, 1.0), maps);
  }
  return status.IsOk() && !maps.Check().IsOk()
             ? Status::Failure("The moduli differ too much from place to place, or the support is "
                               "too soft or too stiff for them, for maps of degree " +
                               std::to_string(maps.Degree) + "; another degree may help.")
             : status;
}
} // namespace palpate
