#pragma once

#include "HaloText.h"
#include "PalpateInteractionModule.h"
#include "Vector3.h"

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkRenderer;

namespace palpate
{
/// Text next to points in 3D, in front of everything; it may be faint where its point is hidden.
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
  /// See HaloText.
  void SetReach(double reach) { this->Reach = reach; }
  void Update(const std::vector<Label>& labels, const std::array<double, 3>& color);

private:
  void Resize(std::size_t count);

  vtkWeakPointer<vtkRenderer> Renderer;
  std::vector<vtkSmartPointer<HaloText>> Texts;
  double Reach = -1.0;
};
} // namespace palpate
