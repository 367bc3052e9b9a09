#pragma once

#include "PalpateInteractionModule.h"
#include "Vector3.h"

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkRenderer;
class vtkTextActor;

namespace palpate
{
/// Text next to points in 3D, in front of everything.
class PALPATEINTERACTION_EXPORT PointLabels
{
public:
  struct Label
  {
    std::string Text;
    Vector3 PositionWorld;
  };

  /// Removes them from the previous renderer; null for none.
  void SetRenderer(vtkRenderer* renderer);
  void Update(const std::vector<Label>& labels, const std::array<double, 3>& color);

private:
  void Resize(std::size_t count);

  vtkWeakPointer<vtkRenderer> Renderer;
  std::vector<vtkSmartPointer<vtkTextActor>> Texts;
};
} // namespace palpate
