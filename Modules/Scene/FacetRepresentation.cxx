#include "FacetRepresentation.h"

#include "StructurePlan.h"

namespace palpate
{
namespace
{
SceneProduct MakeContact(const FitResult& found)
{
  auto own = vtkSmartPointer<vtkPolyData>::New();
  own->ShallowCopy(found.Surface);
  return std::make_shared<const TouchContact>(MakeFacetContact(own, found.Input));
}
} // namespace

void PlanFacetContact(StructurePlan& plan)
{
  plan.AddContact("facets", plan.AddSurface(),
                  [](const StructurePlan::Inputs& inputs, const ProgressFunction&)
                  { return MakeContact(ProductAs<FitSurface>(inputs.data())->Found); });
}

SceneRepresentation FacetRepresentation()
{
  SceneRepresentation facets;
  facets.Name = facets.Label = TouchRepresentation::Facets;
  facets.Sources = {SceneSource::Label, SceneSource::Surface};
  facets.PlanContact = PlanFacetContact;
  facets.Describe = [](const ContactSetting&) { return std::string("facets"); };
  facets.KeyOf = [](const ContactSetting&) { return std::string("facets/all"); };
  facets.Vary = [](const ContactSetting& standard, const TouchToolSettings& tool, int)
  {
    const bool isSphere = tool.Kind == TouchToolSettings::Shape::Sphere; // no other can touch them
    return isSphere ? std::vector<ContactSetting>{standard} : std::vector<ContactSetting>();
  };
  return facets;
}
} // namespace palpate
