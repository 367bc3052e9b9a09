#pragma once

#include "AnatomicalView.h"
#include "HaloText.h"
#include "PalpateInteractionModule.h"
#include "ViewProps.h"

#include <array>

class vtkRenderer;
class vtkTextActor;

namespace palpate
{
/// Pixels per point of a renderer's window; 1 without a window.
PALPATEINTERACTION_EXPORT double PointPixels(vtkRenderer* renderer);

/// A white text at a position of a view, 0 to 1 from its lower left corner; near an edge it is
/// justified to it. Size in points.
PALPATEINTERACTION_EXPORT vtkSmartPointer<HaloText> MakeViewText(double x, double y, int size);

/// Sets the text if it changed: rendering text takes longer than drawing it.
PALPATEINTERACTION_EXPORT void SetViewText(vtkTextActor* actor, const std::string& text);

/// Letters of the patient's directions at the four edges of a view.
class PALPATEINTERACTION_EXPORT EdgeLetters : public ViewProps
{
public:
  EdgeLetters();
  void Update(const ViewFrame& frame);

  /// Left, right, top, bottom.
  const std::array<vtkSmartPointer<HaloText>, 4>& Texts() const { return this->Letters; }

private:
  std::array<vtkSmartPointer<HaloText>, 4> Letters;
};
} // namespace palpate
