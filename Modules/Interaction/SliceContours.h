#pragma once

#include "CurveActor.h"
#include "PalpateInteractionModule.h"
#include "SlicePosition.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <memory>
#include <vector>

class vtkRenderer;
class vtkSurfaceDisplay;

namespace palpate
{
/// The contours of surfaces in a slice, cut anew where the slice or the surface is another one.
class PALPATEINTERACTION_EXPORT SliceContours
{
public:
  /// Null takes them away.
  void SetRenderer(vtkRenderer* renderer);
  void Add(vtkSurfaceDisplay* surface);
  void Remove(vtkSurfaceDisplay* surface);
  void Update(const SlicePosition& slice);

  /// How often a surface was cut so far.
  int CutCount() const { return this->Cuts; }

private:
  struct Contour
  {
    vtkSmartPointer<vtkSurfaceDisplay> Surface;
    std::unique_ptr<CurveActor> Curves;
    // What it was cut by last.
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
