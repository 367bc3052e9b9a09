#include "ColorBar.h"

#include "ArrayColors.h"
#include "ViewText.h"

#include "vtkLookupTable.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

namespace palpate
{
namespace
{
constexpr int BarTextSize = 11; // points
constexpr int LabelCount = 5;
constexpr double BarLeft = 0.02; // all as fractions of the view
constexpr double BarBottom = 0.05;
constexpr double Width = 0.12;
constexpr double Height = 0.4;
constexpr double TitleGap = 0.045; // under the title, for the highest number
} // namespace

ColorBar::ColorBar() : Title(MakeViewText(BarLeft, BarBottom + Height + TitleGap, BarTextSize))
{
  this->Title->GetTextProperty()->SetVerticalJustificationToBottom();
  this->Bar->SetNumberOfLabels(LabelCount);
  this->Bar->SetLabelFormat("%.3g");
  this->Bar->UnconstrainedFontSizeOn();
  this->Bar->SetPosition(BarLeft, BarBottom);
  this->Bar->SetPosition2(Width, Height);
  this->Bar->SetBarRatio(0.25);
  this->Bar->PickableOff();
  vtkTextProperty* style = this->Bar->GetLabelTextProperty();
  style->SetColor(1.0, 1.0, 1.0);
  style->SetFontSize(BarTextSize);
  style->BoldOff();
  style->ItalicOff();
  this->Add(this->Bar);
  this->Add(this->Title);
}

void ColorBar::SetGrey(double grey)
{
  this->Bar->GetLabelTextProperty()->SetColor(grey, grey, grey);
  this->Title->GetTextProperty()->SetColor(grey, grey, grey);
}

void ColorBar::Update(vtkLookupTable* colors, const std::string& array)
{
  this->SetVisible(colors != nullptr);
  if (colors != nullptr && this->Bar->GetLookupTable() != colors)
  {
    this->Bar->SetLookupTable(colors);
    this->Bar->SetMaximumNumberOfColors(static_cast<int>(colors->GetNumberOfAvailableColors()));
    SetViewText(this->Title, ArrayTitle(array));
  }
}
} // namespace palpate
