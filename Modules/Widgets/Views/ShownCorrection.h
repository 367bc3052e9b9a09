#pragma once

#include "StudyCorrected.h"
#include "StudyState.h"

#include "vtkNew.h"
#include "vtkSurfaceDisplay.h"

#include <cstdint>

namespace palpate
{
/// The surface of the structure that is being corrected, as all views share it instead of the
/// structure's own: coloured by its distance from the start in 3-D.
class ShownCorrection
{
public:
  ShownCorrection();

  void Show(const StudyState& state, const StudyCorrected& corrected);
  vtkSurfaceDisplay* Display() const { return this->Shown; }
  /// The outline of a brush's strokes that it has not yet; null: none.
  void ShowStroke(vtkPolyData* outline, bool erases);
  vtkSurfaceDisplay* Stroke() const { return this->Painted; }
  /// Whether it is shown instead of a structure's own surface.
  bool IsOf(int id) const { return this->Shown->GetVisibility() && this->Id == id; }

private:
  vtkNew<vtkSurfaceDisplay> Shown;
  vtkNew<vtkSurfaceDisplay> Painted;
  int Id = 0;
  std::uint64_t Revision = 0; // that is shown
};
} // namespace palpate
