#pragma once

#include "PalpateInteractionModule.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <optional>

class vtkActor;
class vtkCamera;
class vtkLookupTable;
class vtkPolyDataMapper;
class vtkSurfaceDisplay;

namespace palpate
{
struct ContactMark;

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
  /// Where it is touched, seen by the camera that draws next.
  void UpdateContact(const ContactMark& contact, vtkCamera* camera);

  vtkSurfaceDisplay* Display() const { return this->Shown; }
  vtkActor* Actor() const { return this->Surface; }
  /// Of the numbers that colour it, as it was updated last; none where it is plain or not shown.
  const std::optional<std::array<double, 2>>& ColoredRange() const { return this->Range; }
  /// By which those numbers have their colours.
  void SetColors(vtkLookupTable* colors);

private:
  void ColorByArray();

  vtkSmartPointer<vtkSurfaceDisplay> Shown;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Surface;
  std::optional<std::array<double, 2>> Range;
  std::uint64_t Time = 0;
};
} // namespace palpate
