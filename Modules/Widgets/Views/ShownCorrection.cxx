#include "ShownCorrection.h"

namespace palpate
{
ShownCorrection::ShownCorrection()
{
  this->Shown->VisibilityOff();
  this->Shown->SetColor(0.94, 0.89, 0.26); // as what is drawn
  this->Shown->SetLineWidth(2.0);
  this->Painted->VisibilityOff();
  this->Painted->PickableOff(); // the surface below is painted at
  this->Painted->SetLineWidth(2.0);
}

void ShownCorrection::ShowStroke(vtkPolyData* outline, bool erases)
{
  if (outline != nullptr)
  {
    this->Painted->SetSurface(outline);
    // Bluish green and vermilion (Okabe and Ito).
    this->Painted->SetColor(erases ? 0.84 : 0.0, erases ? 0.37 : 0.62, erases ? 0.0 : 0.45);
  }
  this->Painted->SetVisibility(outline != nullptr);
}

void ShownCorrection::Show(const StudyState& state, const StudyCorrected& corrected)
{
  if (this->Revision == corrected.Revision())
  {
    return;
  }
  this->Revision = corrected.Revision();
  this->Id = state.Correction.StructureId;
  if (corrected.Surface() != nullptr)
  {
    // Without a change there is no scale.
    this->Shown->SetColorArray(corrected.IsMoved() ? StudyCorrected::ChangeArray : "");
    this->Shown->SetSurface(corrected.Surface());
  }
  this->Shown->SetVisibility(corrected.Surface() != nullptr);
}
} // namespace palpate
