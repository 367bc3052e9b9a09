#include "ShapeContact.h"

#include "CaseText.h"
#include "FieldOfImage.h"
#include "FilterRun.h"
#include "LabelMask.h"
#include "MaskComponents.h"
#include "MaskShape.h"

#include "vtkImageData.h"

namespace palpate
{
namespace
{
void Require(const Status& status, const Segmentation& segmentation, const Segment& structure)
{
  if (!status.IsOk())
  {
    throw FilterError(CaseMessage(segmentation.Source, structure, status.Message()));
  }
}

// The nodes of a mask's shape, in the world.
FieldGrid GridOf(const ShapeGrid& shape, const VoxelMask& mask, const FieldGrid& image)
{
  Vector3 first; // index in the image
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    first[axis] = mask.StartIndex[a] + shape.Origin[axis] / mask.Spacing[a];
  }
  return {shape.Size, image.PointWorld(first), Vector3::Constant(shape.Spacing), image.Direction()};
}
} // namespace

TouchContact MakeShapeContact(const Segmentation& segmentation, const Segment& structure,
                              double smoothing)
{
  const vtkSmartPointer<vtkImageData> image =
      segmentation.Layers[static_cast<std::size_t>(structure.Layer)];
  VoxelMask mask = CopyLabelMask(image, structure.Value, 1).Mask;
  FillCavities(mask);
  ShapeField shape;
  const double volume = static_cast<double>(mask.Count()) * mask.VoxelVolume();
  Require(MakeMaskShape(mask, volume, {smoothing, 0}, shape), segmentation, structure);
  const FieldGrid grid = GridOf(shape.Grid, mask, GridOfImage(image));
  FieldBuilder builder(grid);
  builder.SetInterpolation(FieldInterpolation::TricubicBSpline);
  builder.AddMaterial(
      {builder.AddChannel(SamplesOfGrid(shape.Values.data(), grid)), 0.0, FieldSense::AtLeast});
  std::shared_ptr<const ScalarField> field;
  Require(builder.Build(field), segmentation, structure);
  return MakeFieldContact(field, 0, segmentation.Source);
}
} // namespace palpate
