#pragma once

#include "BrushVoxels.h"
#include "PalpateStudyModule.h"
#include "StudyCorrected.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <optional>

class vtkImageData;

namespace palpate
{
/// A stroke of a brush while it is led: its voxels at once, and the step that it becomes. World mm,
/// patient LPS.
class PALPATESTUDY_EXPORT StudyBrush
{
public:
  /// Begins a stroke of a brush like that (radius, slice, erasing) at a place. With an image, which
  /// may have another grid, it keeps to its edges (MakeStrokeToEdges). Fails, saying why, where
  /// there are no voxels.
  Status Begin(const StudyCorrected& corrected, const BrushStroke& like, const Vector3& placeWorld,
               vtkImageData* edges);
  /// Goes on to a place, all of it with this radius. Places nearer than a tenth of the radius to
  /// each other are one. Fails as MakeStroke.
  Status Move(const Vector3& placeWorld, double radius);
  bool IsBegun() const { return this->Stroke.has_value(); }
  const BrushStroke* Current() const { return this->Stroke ? &*this->Stroke : nullptr; }
  /// The boundary of its voxels so far.
  vtkPolyData* Outline() const { return this->Drawn; }
  /// Ends it. None if it has passed over no voxel, or none was begun.
  std::optional<CorrectionStep> End();
  void GiveUp();

private:
  Status Update();

  std::optional<BrushStroke> Stroke;
  BrushStroke::Path Path;
  IndexToWorld Grid;
  std::array<int, 3> ImageSize{};
  vtkSmartPointer<vtkImageData> Edges;
  VoxelMask Voxels;
  vtkSmartPointer<vtkPolyData> Drawn;
};
} // namespace palpate
