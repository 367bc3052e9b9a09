#include "ShownDrawing.h"

namespace palpate
{
ShownDrawing::ShownDrawing()
{
  constexpr double Opacity = 0.75;
  this->Shown->VisibilityOff();
  this->Shown->SetColor(0.94, 0.89, 0.26); // Okabe and Ito's yellow, unlike organs
  this->Shown->SetOpacity(Opacity);
  this->Shown->SetLineWidth(2.0);
  this->Shown->PickableOff(); // a touch of it says nothing about the organ
  this->Shown->SetColorArray(DrawnOrgan::DeviationArray);
}

void ShownDrawing::Show(const DrawnOrgan& organ)
{
  if (this->Revision == organ.Revision())
  {
    return;
  }
  this->Revision = organ.Revision();
  if (organ.Surface() != nullptr)
  {
    this->Shown->SetSurface(organ.Surface());
  }
  this->Shown->SetVisibility(organ.Surface() != nullptr);
}
} // namespace palpate
