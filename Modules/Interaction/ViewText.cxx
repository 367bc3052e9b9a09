#include "ViewText.h"

#include "vtkCoordinate.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

namespace palpate
{
namespace
{
constexpr int LetterSize = 15; // points
constexpr double Edge = 0.015; // of the view, between letters and edges
} // namespace

double PointPixels(vtkRenderer* renderer)
{
  constexpr double PointsPerInch = 72.0;
  vtkRenderWindow* window = renderer->GetRenderWindow();
  return window == nullptr ? 1.0 : window->GetDPI() / PointsPerInch;
}

vtkSmartPointer<HaloText> MakeViewText(double x, double y, int size)
{
  auto text = vtkSmartPointer<HaloText>::New();
  vtkTextProperty* style = text->GetTextProperty();
  style->SetFontSize(size);
  style->SetColor(1.0, 1.0, 1.0);
  style->SetJustification(x < 0.3 ? VTK_TEXT_LEFT : x > 0.7 ? VTK_TEXT_RIGHT : VTK_TEXT_CENTERED);
  style->SetVerticalJustification(y < 0.3   ? VTK_TEXT_BOTTOM
                                  : y > 0.7 ? VTK_TEXT_TOP
                                            : VTK_TEXT_CENTERED);
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->SetPosition(x, y);
  text->PickableOff();
  return text;
}

void SetViewText(vtkTextActor* actor, const std::string& text)
{
  if (actor->GetInput() == nullptr || text != actor->GetInput())
  {
    actor->SetInput(text.c_str());
  }
}

EdgeLetters::EdgeLetters()
    : Letters{{MakeViewText(Edge, 0.5, LetterSize), MakeViewText(1.0 - Edge, 0.5, LetterSize),
               MakeViewText(0.5, 1.0 - Edge, LetterSize), MakeViewText(0.5, Edge, LetterSize)}}
{
  for (vtkTextActor* letter : this->Letters)
  {
    letter->GetTextProperty()->BoldOn();
    this->Add(letter);
  }
}

void EdgeLetters::Update(const ViewFrame& frame)
{
  const auto texts = EdgeLettersOf(frame);
  for (std::size_t edge = 0; edge < texts.size(); ++edge)
  {
    SetViewText(this->Letters[edge], texts[edge]);
  }
}
} // namespace palpate
