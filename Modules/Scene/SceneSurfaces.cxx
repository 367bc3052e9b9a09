#include "SceneSurfaces.h"

#include "FitResult.h"
#include "SceneRepresentation.h"
#include "SceneRun.h"

namespace palpate
{
namespace
{
// The same structures, for display alone.
SceneSettings OnlyDisplayed(const SceneSettings& scene)
{
  SceneSettings displayed = scene;
  displayed.Tool = TouchToolSettings();
  displayed.Guides.clear();
  for (SceneStructure& structure : displayed.Structures)
  {
    structure.Appearance = RepresentationOf(structure).Appearance == SceneAppearance::Model
                               ? SceneAppearance::Model
                               : SceneAppearance::Surface;
    structure.IsTouchable = false;
    structure.IsForbidden = false;
  }
  return displayed;
}
} // namespace

std::vector<vtkSmartPointer<vtkPolyData>> DisplayedSurfaces(const SceneSettings& scene,
                                                            const ProgressFunction& progress)
{
  const SceneSettings displayed = OnlyDisplayed(scene);
  SceneRun run;
  run.Make(displayed, progress);
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  for (const SceneStructure& structure : displayed.Structures)
  {
    const auto model = ProductAs<FitResult>(run.ProductAt(SceneStep::Model, structure.Id));
    const auto surface = ProductAs<FitSurface>(run.ProductAt(SceneStep::Surface, structure.Id));
    if (structure.IsVisible && model != nullptr)
    {
      surfaces.push_back(model->ModelSurface);
    }
    else if (structure.IsVisible && surface != nullptr)
    {
      surfaces.push_back(surface->Found.Surface);
    }
  }
  return surfaces;
}
} // namespace palpate
