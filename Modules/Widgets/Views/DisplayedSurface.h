#pragma once

#include "StudyPipeline.h"
#include "StudyState.h"

#include <memory>

class vtkPolyData;

namespace palpate
{
struct FitResult;

/// Whether to display the field of a structure, if there is one.
bool WantsField(const SceneStructure& structure);

/// The model whose drawing is displayed, or null.
std::shared_ptr<const FitResult> ModelOf(const StudyPipeline& pipeline,
                                         const SceneStructure& structure);

/// The displayed surface of a structure: its model if wanted, else the surface of its mask; null if
/// there is none yet.
vtkPolyData* SurfaceOf(const StudyPipeline& pipeline, const SceneStructure& structure);

/// The model of a structure that yields, or null.
std::shared_ptr<const FitResult> YieldingModelOf(const StudyPipeline& pipeline,
                                                 const SceneStructure& structure);

/// The array of the surface that colours it; empty if it is plain.
const char* ColorArrayOf(SceneAppearance appearance);
} // namespace palpate
