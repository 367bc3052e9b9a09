#include "TouchContact.h"

#include "ElasticContactModel.h"
#include "FacetContactModel.h"
#include "FieldContactModel.h"
#include "OrganContact.h"
#include "Refusal.h"
#include "TriangleMesh.h"

namespace palpate
{
namespace
{
Status MakeModel(const RadialModel& model, RadialContactMode mode,
                 std::shared_ptr<const ContactModel>& contact)
{
  return MakeOrganContact(std::make_shared<const RadialModel>(model), mode, contact);
}

Status MakeModel(const SurfaceModel& surface, RadialContactMode mode,
                 std::shared_ptr<const ContactModel>& contact)
{
  return mode == RadialContactMode::Nearest
             ? MakeOrganContact(surface, contact)
             : Status::Failure("A surface model has no radius in each direction, so it cannot be "
                               "touched radially; choose the nearest point.");
}
} // namespace

TouchContact MakeModelContact(const OrganModel& model, RadialContactMode mode,
                              const std::filesystem::path& file)
{
  TouchContact made;
  RequireInput(std::visit([&](const auto& one) { return MakeModel(one, mode, made.Model); }, model),
               file.string());
  const bool isRadial = std::holds_alternative<RadialModel>(model);
  made.Represented = (isRadial ? "harmonics of degree " : "surface harmonics of degree ") +
                     std::to_string(DegreeOf(model)) +
                     (mode == RadialContactMode::Nearest ? ", nearest point" : ", radial");
  return made;
}

TouchContact MakeElasticContact(const OrganModel& model, const ComplianceMaps& maps,
                                const std::string& tissue, const std::filesystem::path& file)
{
  const auto* radial = std::get_if<RadialModel>(&model);
  if (radial == nullptr)
  {
    Refuse(file, "is a surface model, and only a radial one can yield",
           "fit it with --model radial");
  }
  TouchContact made;
  RequireInput(
      ElasticContactModel::Make(std::make_shared<const RadialModel>(*radial), maps, made.Model),
      file.string());
  made.Represented = "elastic, " + (tissue.empty() ? tissue : tissue + ", ") +
                     "harmonics of degree " + std::to_string(radial->Degree());
  made.Yields = true;
  return made;
}

TouchContact MakeFacetContact(vtkPolyData* surface, const std::filesystem::path& file)
{
  const TriangleMesh mesh = TrianglesOf(surface, file);
  TouchContact made;
  RequireInput(FacetContactModel::Make(mesh.PointsWorld, mesh.Triangles, made.Model),
               file.string());
  made.Represented = std::to_string(mesh.Triangles.size()) + " facets";
  return made;
}

TouchContact MakeFieldContact(const std::shared_ptr<const ScalarField>& field, int material,
                              const std::filesystem::path& file)
{
  TouchContact made;
  made.Field = field;
  RequireInput(FieldContactModel::Make(field, material, made.Model), file.string());
  const bool isLinear = field->Interpolation() == FieldInterpolation::Trilinear;
  made.Represented = std::string("sub-voxel field, ") + (isLinear ? "trilinear" : "tricubic");
  return made;
}
} // namespace palpate
