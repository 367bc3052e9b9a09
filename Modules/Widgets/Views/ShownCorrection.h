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
  /// Whether it is shown instead of a structure's own surface.
  bool IsOf(int id) const { return this->Shown->GetVisibility() && this->Id == id; }

private:
  vtkNew<vtkSurfaceDisplay> Shown;
  int Id = 0;
  std::uint64_t Revision = 0; // that is shown
};
} // namespace palpate
