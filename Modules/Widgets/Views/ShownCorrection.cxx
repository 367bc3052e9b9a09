#include "ShownCorrection.h"

namespace palpate
{
ShownCorrection::ShownCorrection()
{
  this->Shown->VisibilityOff();
  this->Shown->SetColor(0.94, 0.89, 0.26); // as what is drawn
  this->Shown->SetLineWidth(2.0);
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
