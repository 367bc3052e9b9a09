#include "ViewGrid.h"

#include <algorithm>

namespace palpate
{
const char* WordOf(ViewLayout layout)
{
  constexpr std::array<const char*, 3> Words{"four", "space", "one"};
  return Words.at(static_cast<std::size_t>(layout));
}

ViewLayout LayoutOf(const std::string& word)
{
  for (const ViewLayout layout : AllViewLayouts)
  {
    if (word == WordOf(layout))
    {
      return layout;
    }
  }
  return ViewLayout::Four;
}

ViewGrid::ViewGrid(ViewContents& contents, QWidget* parent)
    : QWidget(parent), Contents(contents), InSpace(new SpacePane(contents, this)),
      Grid(new QGridLayout(this)), One(InSpace)
{
  this->Grid->setContentsMargins(0, 0, 0, 0);
  this->Grid->setSpacing(2);
  for (const SliceOrientation orientation : AllSliceOrientations)
  {
    const auto s = static_cast<std::size_t>(orientation);
    this->Slices[s] = new SlicePane(orientation, contents, this);
    this->All[s] = this->Slices[s];
  }
  this->All[3] = this->InSpace;
  for (ViewPane* pane : this->All)
  {
    connect(pane, &ViewPane::MaximizeAsked, this, [this, pane] { this->ToggleMaximized(pane); });
  }
  this->Arrange();
}

void ViewGrid::SetLayout(ViewLayout layout)
{
  this->Shown = layout;
  this->Alone = nullptr;
  this->Arrange();
}

void ViewGrid::ToggleMaximized(ViewPane* pane)
{
  this->Alone = this->Alone == nullptr ? pane : nullptr;
  this->One = pane;
  this->Arrange();
}

void ViewGrid::Put(ViewPane* pane, int row, int column, int rows, int columns)
{
  this->Grid->addWidget(pane, row, column, rows, columns);
  pane->setVisible(true);
}

void ViewGrid::Arrange()
{
  for (ViewPane* pane : this->All)
  {
    this->Grid->removeWidget(pane);
  }
  for (int line = 0; line < 3; ++line)
  {
    this->Grid->setRowStretch(line, 0);
    this->Grid->setColumnStretch(line, 0);
  }
  ViewPane* single = this->Shown == ViewLayout::One ? this->One : nullptr;
  single = this->Alone != nullptr ? this->Alone : single;
  for (ViewPane* pane : this->All)
  {
    pane->setVisible(single == nullptr || pane == single);
  }
  if (single != nullptr)
  {
    this->Put(single, 0, 0, 1, 1);
  }
  else if (this->Shown == ViewLayout::Space)
  {
    this->Put(this->InSpace, 0, 0, 3, 1);
    for (int s = 0; s < 3; ++s)
    {
      this->Put(this->Slices[static_cast<std::size_t>(s)], s, 1, 1, 1);
      this->Grid->setRowStretch(s, 1);
    }
    this->Grid->setColumnStretch(0, 2);
    this->Grid->setColumnStretch(1, 1);
  }
  else
  {
    this->Put(this->All[0], 0, 0, 1, 1);
    this->Put(this->All[3], 0, 1, 1, 1);
    this->Put(this->All[1], 1, 0, 1, 1);
    this->Put(this->All[2], 1, 1, 1, 1);
    for (int line = 0; line < 2; ++line)
    {
      this->Grid->setRowStretch(line, 1);
      this->Grid->setColumnStretch(line, 1);
    }
  }
  this->ShowNotice(this->Notice);
}

void ViewGrid::TakeContents()
{
  std::set<vtkSmartPointer<vtkSurfaceDisplay>> next;
  for (const auto* shown :
       {&this->Contents.Surfaces(), &this->Contents.Cuts(), &this->Contents.Outlines()})
  {
    for (const auto& [label, surface] : *shown)
    {
      next.insert(surface);
    }
  }
  for (const auto& surface : next)
  {
    if (this->Surfaces.count(surface) == 0)
    {
      for (ViewPane* pane : this->All)
      {
        pane->AddSurface(surface);
      }
    }
  }
  for (const auto& surface : this->Surfaces)
  {
    if (next.count(surface) == 0)
    {
      for (ViewPane* pane : this->All)
      {
        pane->RemoveSurface(surface);
      }
    }
  }
  const bool areOthers = next != this->Surfaces;
  this->Surfaces = next;
  std::set<vtkVolume*> fields;
  for (const auto& [label, field] : this->Contents.Fields())
  {
    fields.insert(field);
  }
  this->InSpace->ShowFields({fields.begin(), fields.end()});
  for (SlicePane* slice : this->Slices)
  {
    slice->ShowFields(fields);
  }
  this->FitToAnotherImage();
  if (areOthers)
  {
    this->InSpace->ShowAllUnlessLed();
  }
}

// A volume at another position would be outside the current view.
void ViewGrid::FitToAnotherImage()
{
  vtkImageData* image = this->Contents.Images()->GetImage();
  if (image != this->Image)
  {
    this->Image = image;
    this->InSpace->FreeCamera();
    this->FitAll();
  }
}

void ViewGrid::SetAlongImage(bool isAlongImage)
{
  for (ViewPane* pane : this->All)
  {
    pane->SetAlongImage(isAlongImage);
  }
}

void ViewGrid::SetLeftButtonMode(int mode)
{
  for (SlicePane* slice : this->Slices)
  {
    slice->SetLeftButtonMode(mode);
  }
}

void ViewGrid::SetNeurological(bool isNeurological)
{
  for (SlicePane* slice : this->Slices)
  {
    slice->SetNeurological(isNeurological);
  }
}

void ViewGrid::SetLengthUnit(LengthUnit unit)
{
  for (ViewPane* pane : this->All)
  {
    pane->SetLengthUnit(unit);
  }
}

void ViewGrid::ShowNotice(const TouchNotice& notice)
{
  this->Notice = notice;
  // The 3D view, or the only one.
  const auto seen = std::find_if(this->All.rbegin(), this->All.rend(),
                                 [](const ViewPane* pane) { return !pane->isHidden(); });
  for (ViewPane* pane : this->All)
  {
    pane->ShowNotice(seen != this->All.rend() && pane == *seen ? notice : TouchNotice());
  }
}

void ViewGrid::FitAll()
{
  for (SlicePane* slice : this->Slices)
  {
    slice->FitToImage();
  }
  this->InSpace->ShowAll();
}
} // namespace palpate
