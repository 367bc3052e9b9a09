#pragma once

#include "StructuresPanel.h"
#include "ViewContents.h"
#include "ViewGrid.h"

#include <QObject>

#include <functional>

namespace palpate
{
/// Links the table of structures with the views: a row that the user selects is centred in the
/// slices, selected rows are highlighted, a place that a row's mark names is shown in all views,
/// and a click on a structure selects its row.
class StructureLink : public QObject
{
  Q_OBJECT

public:
  /// Keeps the addresses. `mayPick` tells whether clicks have no other meaning.
  StructureLink(StructuresPanel& table, ViewContents& contents, ViewGrid& views,
                std::function<bool()> mayPick, QObject* parent);

private:
  void Centre(int id);
  void ShowInSlices(const Vector3& placeWorld);
  void ShowPlace(const Vector3& placeWorld);
  void Highlight();
  void TakeSliceClick(const Vector3& pointWorld);
  void TakeSpaceClick(double x, double y);

  StructuresPanel& Table;
  ViewContents& Contents;
  ViewGrid& Views;
  std::function<bool()> MayPick;
};
} // namespace palpate
