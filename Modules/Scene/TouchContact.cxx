#include "TouchContact.h"

#include "FacetContactModel.h"
#include "FieldContactModel.h"
#include "Refusal.h"
#include "TriangleMesh.h"

namespace palpate
{
TouchContact MakeHarmonicContact(const SphericalHarmonicModel& model, HarmonicContactMode mode,
                                 const std::filesystem::path& file)
{
  TouchContact made;
  RequireInput(HarmonicContactModel::Make(std::make_shared<const SphericalHarmonicModel>(model),
                                          mode, made.Model),
               file.string());
  made.Represented = "harmonics of degree " + std::to_string(model.Degree()) +
                     (mode == HarmonicContactMode::Nearest ? ", nearest point" : ", radial");
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
