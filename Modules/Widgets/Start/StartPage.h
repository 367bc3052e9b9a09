#pragma once

#include "StartCard.h"
#include "StartTile.h"
#include "TileGrid.h"

#include <QBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QStringList>

#include <map>

namespace palpate
{
/// What an empty window offers: to open files, the files that were opened last, and cards to begin
/// with.
class StartPage : public QScrollArea
{
  Q_OBJECT

public:
  explicit StartPage(QWidget* parent);

  /// Lists files, the last one first.
  void ShowRecent(const QStringList& files);
  /// What a card does now; empty for its own text.
  void ShowProgress(StartCard::Kind kind, const QString& text);

Q_SIGNALS:
  void OpenAsked();   ///< files of any kind
  void FolderAsked(); ///< a folder of DICOM slices
  void FileChosen(const QString& file);
  void CardChosen(palpate::StartCard::Kind kind);

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  void AddOpening();
  void AddCards();
  QLabel* AddHeading(const QString& text);

  QVBoxLayout* Column;
  QLabel* RecentHeading;
  TileGrid* Recent;
  TileGrid* Cards;
  std::map<StartCard::Kind, StartTile*> OfKind;
};
} // namespace palpate
