#pragma once

#include "PalpateInteractionModule.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <cstdint>

class vtkActor;
class vtkCamera;
class vtkLookupTable;
class vtkPolyDataMapper;
class vtkProbeRepresentation;
class vtkSurfaceDisplay;

namespace palpate
{
/// A surface in space, plain or coloured by an array, with the place that is touched in a colour of
/// its own. That colour is mixed by the graphics system for each pixel, so that a touch that moves
/// costs nothing for the surface's points.
class PALPATEINTERACTION_EXPORT SurfaceInSpace
{
public:
  explicit SurfaceInSpace(vtkSurfaceDisplay* display);
  ~SurfaceInSpace();
  SurfaceInSpace(const SurfaceInSpace&) = delete;
  SurfaceInSpace& operator=(const SurfaceInSpace&) = delete;

  void Update();
  /// Where the probe, which may be null, touches, seen by the camera that draws next.
  void UpdateContact(vtkProbeRepresentation* probe, vtkCamera* camera);

  vtkSurfaceDisplay* Display() const { return this->Shown; }
  vtkActor* Actor() const { return this->Surface; }
  /// Of the array that colours it; null where none does.
  vtkLookupTable* Colors() const { return this->Lookup; }

private:
  void ColorByArray();

  vtkSmartPointer<vtkSurfaceDisplay> Shown;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Surface;
  vtkSmartPointer<vtkLookupTable> Lookup;
  std::uint64_t Time = 0;
};
} // namespace palpate
