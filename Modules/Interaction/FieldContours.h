#pragma once

#include "CurvesInSlice.h"
#include "PalpateInteractionModule.h"
#include "PixelGrid.h"
#include "SlicePosition.h"

#include <memory>
#include <vector>

class vtkVolume;

namespace palpate
{
class ScalarField;

/// Samples that take 5 ms in a tricubic field, and 1.6 ms in a trilinear one.
constexpr int MostFieldSamples = 70000;

/// The contour of a field's material in a plane, within the pixels of a box, from samples at every
/// pixel; of more than MostFieldSamples at every second one.
PALPATEINTERACTION_EXPORT std::vector<SurfaceCurve>
ContourOfField(const std::shared_ptr<const ScalarField>& field, int material,
               const PixelGrid& pixels);

/// A field, and the pixels in which its contour was found.
struct FieldCut
{
  std::shared_ptr<const ScalarField> Field;
  PixelGrid Pixels;
};

/// Contours of sub-voxel volumes in a slice, found again only if the slice or a field changed.
class PALPATEINTERACTION_EXPORT FieldContours : public CurvesInSlice<vtkVolume, FieldCut>
{
public:
  void Update(const SlicePosition& slice);
};
} // namespace palpate
