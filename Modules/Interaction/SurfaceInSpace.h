#pragma once

#include "PalpateInteractionModule.h"
#include "SurfaceOutline.h"
#include "ViewProps.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <optional>

class vtkCamera;
class vtkLookupTable;
class vtkSurfaceDisplay;

namespace palpate
{
struct ContactMark;
struct ToolShadow;

/// A surface in 3D, plain or coloured by an array, with the contact region in its own colour, and
/// an outline if it is highlighted or forbidden. A shader blends that colour per pixel, and the
/// tool's shadow: moving them costs nothing per surface point. Where a translucent surface turns
/// away from the viewer it is less translucent, as glass is, so that its shape is seen.
class PALPATEINTERACTION_EXPORT SurfaceInSpace : public ViewProps
{
public:
  explicit SurfaceInSpace(vtkSurfaceDisplay* display);

  void Update();
  /// Outlines it if it is highlighted, on light or on dark ground, or forbidden. `pixels` of a
  /// point.
  void UpdateOutline(bool isGroundLight, double pixels);
  /// Sets the contact, for the camera of the next frame.
  void UpdateContact(const ContactMark& contact, vtkCamera* camera);
  /// Sets the tool's shadow, for the camera of the next frame.
  void UpdateShadow(const ToolShadow& shadow, vtkCamera* camera);

  vtkSurfaceDisplay* Display() const { return this->Shown; }
  vtkActor* Actor() const { return this->Surface; }
  /// Range of the values that colour it, at the last update; none if it is plain or hidden.
  const std::optional<std::array<double, 2>>& ColoredRange() const { return this->Range; }
  /// Maps those values to colours.
  void SetColors(vtkLookupTable* colors);

private:
  void SetMaterial();
  void ColorByArray();

  vtkSmartPointer<vtkSurfaceDisplay> Shown;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Surface;
  SurfaceOutline Outline;
  std::optional<std::array<double, 2>> Range;
  std::uint64_t Time = 0;
};
} // namespace palpate
