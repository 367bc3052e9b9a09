#pragma once

#include "CurveActor.h"
#include "PalpateInteractionModule.h"
#include "SlicePosition.h"

#include "vtkSmartPointer.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <vector>

class vtkRenderer;
class vtkSurfaceDisplay;

namespace palpate
{
/// The contours of surfaces in a slice, cut again only if the slice or the surface changed.
class PALPATEINTERACTION_EXPORT SliceContours
{
public:
  /// Null removes them.
  void SetRenderer(vtkRenderer* renderer);
  void Add(vtkSurfaceDisplay* surface);
  void Remove(vtkSurfaceDisplay* surface);
  void Update(const SlicePosition& slice);
  /// Of all surfaces that are not wireframes, world; empty if there is none.
  Eigen::AlignedBox3d Bounds() const;

  /// Number of cuts so far.
  int CutCount() const { return this->Cuts; }

private:
  struct Contour
  {
    vtkSmartPointer<vtkSurfaceDisplay> Surface;
    std::unique_ptr<CurveActor> Curves;
    // Of the last cut.
    std::uint64_t Time = 0;
    double Height = 0.0;
    Vector3 Normal = Vector3::Zero();
  };

  void Update(Contour& contour, const SlicePosition& slice);

  vtkSmartPointer<vtkRenderer> Renderer;
  std::vector<Contour> Contours;
  int Cuts = 0;
};
} // namespace palpate
