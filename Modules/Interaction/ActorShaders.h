#pragma once

#include "vtkActor.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"

namespace palpate
{
/// Draws an actor, faint, over everything that hides it.
inline void ShowThrough(vtkActor* actor, double opacity)
{
  // All depths become nearly those of the camera's near plane, in their order.
  actor->GetShaderProperty()->AddVertexShaderReplacement(
      "//VTK::PositionVC::Impl", true,
      "//VTK::PositionVC::Impl\n"
      "  gl_Position.z = mix(-gl_Position.w, gl_Position.z, 0.01);\n",
      false);
  actor->GetProperty()->SetOpacity(opacity);
}

/// Draws only the far side of an actor, in one dark colour: around a smaller object in it, a rim.
inline void MakeRim(vtkActor* actor)
{
  actor->GetProperty()->FrontfaceCullingOn();
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
}
} // namespace palpate
