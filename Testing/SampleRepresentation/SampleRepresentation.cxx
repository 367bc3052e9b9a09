#include "SampleRepresentation.h"

#include "StructurePlan.h"

#include <cmath>

namespace palpate
{
namespace
{
constexpr const char* Margin = "sphere_margin_mm";

SceneProduct MakeContact(const FitResult& found, double margin)
{
  const double volume = 1000.0 * found.MaskMilliliters; // mm^3
  const double radius = std::cbrt(0.75 * volume / M_PI) + margin;
  double center[3];
  found.Surface->GetCenter(center);
  const RadialModel sphere(0, {radius * std::sqrt(4.0 * M_PI)}, {center[0], center[1], center[2]});
  TouchContact contact = MakeModelContact(sphere, RadialContactMode::Nearest, found.Input);
  contact.Represented = "sphere";
  return std::make_shared<const TouchContact>(std::move(contact));
}
} // namespace

SceneRepresentation SampleRepresentation()
{
  SceneRepresentation sphere;
  sphere.Name = sphere.Label = "sphere";
  sphere.Sources = {SceneSource::Label};
  sphere.Numbers = {{Margin, "Margin of the sphere, mm", 10.0, 2}};
  sphere.PlanContact = [](StructurePlan& plan)
  {
    plan.AddContact("sphere", plan.AddSurface(),
                    [margin = plan.Settings().Number(Margin)](const StructurePlan::Inputs& inputs,
                                                              const ProgressFunction&)
                    { return MakeContact(ProductAs<FitSurface>(inputs.data())->Found, margin); });
  };
  sphere.Describe = [](const ContactSetting&) { return std::string("sphere"); };
  sphere.KeyOf = sphere.Describe;
  sphere.Vary = [](const ContactSetting& standard, const TouchToolSettings&, int)
  { return std::vector<ContactSetting>{standard}; };
  return sphere;
}
} // namespace palpate
