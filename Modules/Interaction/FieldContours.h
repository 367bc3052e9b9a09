#pragma once

#include "CurveActor.h"
#include "PalpateInteractionModule.h"
#include "PixelGrid.h"
#include "SlicePosition.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

class vtkRenderer;
class vtkVolume;

namespace palpate
{
class ScalarField;

/// The contour of a field's material in a plane, from samples at every second pixel, within the
/// pixels of a box.
PALPATEINTERACTION_EXPORT std::vector<SurfaceCurve>
ContourOfField(const std::shared_ptr<const ScalarField>& field, int material,
               const PixelGrid& pixels);

/// Contours of sub-voxel volumes in a slice, found again only if the slice or a field changed.
class PALPATEINTERACTION_EXPORT FieldContours
{
public:
  /// Null removes them.
  void SetRenderer(vtkRenderer* renderer);
  void Add(vtkVolume* volume);
  void Remove(vtkVolume* volume);
  void Update(const SlicePosition& slice);

  /// Number of contours found so far.
  int CutCount() const { return this->Cuts; }

private:
  struct Contour
  {
    vtkSmartPointer<vtkVolume> Volume;
    std::unique_ptr<CurveActor> Curves;
    // Of the last cut.
    std::shared_ptr<const ScalarField> Field;
    PixelGrid Pixels;
  };

  vtkSmartPointer<vtkRenderer> Renderer;
  std::vector<Contour> Contours;
  int Cuts = 0;
};
} // namespace palpate
