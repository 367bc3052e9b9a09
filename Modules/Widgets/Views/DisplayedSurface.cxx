#include "DisplayedSurface.h"

#include "FitResult.h"
#include "RadialModel.h"
#include "SceneRepresentation.h"
#include "YieldingSurface.h"

#include "vtkPolyData.h"

#include <variant>

namespace palpate
{
namespace
{
constexpr const char* ErrorArray = "DistanceToSurface";

// Whether to display its model, if there is one.
bool WantsModel(const SceneStructure& structure)
{
  switch (structure.Appearance)
  {
  case SceneAppearance::Model:
  case SceneAppearance::ErrorMap:
  case SceneAppearance::StiffnessMap:
    return true;
  case SceneAppearance::Surface:
  case SceneAppearance::SubVoxel:
    return false;
  case SceneAppearance::Automatic:
    break;
  }
  return structure.Source() == SceneSource::Model ||
         RepresentationOf(structure).Appearance == SceneAppearance::Model;
}
} // namespace

bool WantsField(const SceneStructure& structure)
{
  const bool isFelt =
      structure.IsDrilled() || RepresentationOf(structure).Appearance == SceneAppearance::SubVoxel;
  return structure.Appearance == SceneAppearance::SubVoxel ||
         (structure.Appearance == SceneAppearance::Automatic && isFelt);
}

std::shared_ptr<const FitResult> ModelOf(const StudyPipeline& pipeline,
                                         const SceneStructure& structure)
{
  auto model = pipeline.Newest<FitResult>(SceneStep::Model, structure.Id);
  const bool isDrawn = WantsModel(structure) && model != nullptr &&
                       model->ModelSurface != nullptr && model->State == FitResult::Outcome::Fitted;
  return isDrawn ? model : nullptr;
}

vtkPolyData* SurfaceOf(const StudyPipeline& pipeline, const SceneStructure& structure)
{
  if (const auto model = ModelOf(pipeline, structure))
  {
    return model->ModelSurface;
  }
  const auto surface = pipeline.Newest<FitSurface>(SceneStep::Surface, structure.Id);
  return surface != nullptr ? surface->Found.Surface.Get() : nullptr;
}

std::shared_ptr<const FitResult> YieldingModelOf(const StudyPipeline& pipeline,
                                                 const SceneStructure& structure)
{
  const bool isRigid = structure.Representation == TouchRepresentation::Harmonics ||
                       structure.Representation == TouchRepresentation::Facets ||
                       structure.Representation == TouchRepresentation::SubVoxel;
  auto model = pipeline.Newest<FitResult>(SceneStep::Elasticity, structure.Id);
  model = model != nullptr ? model : pipeline.Newest<FitResult>(SceneStep::Model, structure.Id);
  const bool yields = !isRigid && WantsModel(structure) && model != nullptr &&
                      model->Elasticity != nullptr &&
                      std::holds_alternative<RadialModel>(model->Model);
  return yields ? model : nullptr;
}

const char* ColorArrayOf(SceneAppearance appearance)
{
  return appearance == SceneAppearance::ErrorMap       ? ErrorArray
         : appearance == SceneAppearance::StiffnessMap ? YieldingSurface::StiffnessArray
                                                       : "";
}
} // namespace palpate
