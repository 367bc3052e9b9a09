#include "TouchContact.h"

#include "FacetContactModel.h"
#include "FieldContactModel.h"
#include "Refusal.h"
#include "SceneField.h"
#include "TriangleMesh.h"

namespace palpate
{
std::string HarmonicText(const SphericalHarmonicModel& model, HarmonicContactMode mode,
                         EvaluationPrecision precision)
{
  return "harmonics of degree " + std::to_string(model.Degree()) +
         (mode == HarmonicContactMode::Nearest ? ", nearest point" : ", radial") +
         (precision == EvaluationPrecision::Float ? ", in float" : "");
}

TouchContact MakeHarmonicContact(const SphericalHarmonicModel& model, HarmonicContactMode mode,
                                 EvaluationPrecision precision, const std::filesystem::path& file)
{
  TouchContact made;
  made.Looks.Model = std::make_shared<const SphericalHarmonicModel>(model);
  made.Mode = mode;
  made.Precision = precision;
  RequireInput(HarmonicContactModel::Make(made.Looks.Model, mode, made.Model, precision),
               file.string());
  made.Represented = HarmonicText(model, mode, precision);
  return made;
}

TouchContact MakeFacetContact(vtkPolyData* surface, const std::filesystem::path& file)
{
  const TriangleMesh mesh = TrianglesOf(surface, file);
  TouchContact made;
  made.Looks.Surface = surface;
  RequireInput(FacetContactModel::Make(mesh.PointsWorld, mesh.Triangles, made.Model),
               file.string());
  made.Represented = std::to_string(mesh.Triangles.size()) + " facets";
  return made;
}

TouchContact MakeFieldContact(const std::shared_ptr<const ScalarField>& field, int material,
                              const std::filesystem::path& file)
{
  TouchContact made;
  made.Looks.Field = field;
  RequireInput(FieldContactModel::Make(field, material, FieldContactMode::Proxy, made.Model),
               file.string());
  const bool isLinear = field->Interpolation() == FieldInterpolation::Trilinear;
  const std::string cells = std::to_string(field->Layout().Cells);
  made.Represented = std::string("sub-voxel field, ") + (isLinear ? "trilinear" : "tricubic") +
                     ", bricks of " + cells + "\u00b3 cells, " + MemoryText(*field);
  return made;
}
} // namespace palpate
