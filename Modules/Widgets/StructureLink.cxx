#include "StructureLink.h"

#include <utility>

namespace palpate
{
StructureLink::StructureLink(StructuresPanel& table, ViewContents& contents, ViewGrid& views,
                             std::function<bool()> mayPick, QObject* parent)
    : QObject(parent), Table(table), Contents(contents), Views(views), MayPick(std::move(mayPick))
{
  connect(&table, &StructuresPanel::Selected, this, &StructureLink::Centre);
  connect(&table, &StructuresPanel::PlaceChosen, this, &StructureLink::ShowPlace);
  connect(&table, &StructuresPanel::SelectionChanged, this, &StructureLink::Highlight);
  connect(views.Space(), &ViewPane::Tapped, this, &StructureLink::TakeSpaceClick);
  for (const SliceOrientation orientation : AllSliceOrientations)
  {
    connect(views.Slice(orientation), &SlicePane::TappedAt, this, &StructureLink::TakeSliceClick);
  }
}

void StructureLink::Centre(int id)
{
  if (const auto center = this->Contents.CenterOf(id))
  {
    this->ShowInSlices(*center);
  }
}

void StructureLink::ShowInSlices(const Vector3& placeWorld)
{
  this->Contents.Crosshair()->SetPositionWorld(placeWorld.data());
  for (const SliceOrientation orientation : AllSliceOrientations)
  {
    this->Views.Slice(orientation)->ShowPlace(placeWorld);
  }
}

void StructureLink::ShowPlace(const Vector3& placeWorld)
{
  this->ShowInSlices(placeWorld);
  this->Views.Space()->LookAt(placeWorld);
}

void StructureLink::Highlight()
{
  const std::vector<int> ids = this->Table.SelectedIds();
  this->Contents.Highlight({ids.begin(), ids.end()});
}

void StructureLink::TakeSliceClick(const Vector3& pointWorld)
{
  if (this->MayPick())
  {
    this->Table.Select(this->Contents.StructureAt(pointWorld));
  }
}

void StructureLink::TakeSpaceClick(double x, double y)
{
  Vector3 point;
  if (this->MayPick())
  {
    const vtkObject* picked = this->Views.Space()->View()->PickObject(x, y, point.data());
    this->Table.Select(this->Contents.StructureAt(picked, point));
  }
}
} // namespace palpate
