#pragma once

#include "DrawnOrgan.h"

#include "vtkNew.h"
#include "vtkSurfaceDisplay.h"

#include <cstdint>

namespace palpate
{
/// The surface of an organ that is drawn by touch, as all views share it: coloured by its standard
/// deviation in 3-D.
class ShownDrawing
{
public:
  ShownDrawing();

  void Show(const DrawnOrgan& organ);
  vtkSurfaceDisplay* Display() const { return this->Shown; }

private:
  vtkNew<vtkSurfaceDisplay> Shown;
  std::uint64_t Revision = 0; // that is shown
};
} // namespace palpate
