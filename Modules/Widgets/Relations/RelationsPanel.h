#pragma once

#include "FileQuestions.h"
#include "OrganRelations.h"
#include "PanelJob.h"
#include "StudyController.h"
#include "ViewContents.h"

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>

#include <memory>

namespace palpate
{
/// The displayed structures, each measured, and all pairs of them, as `palpate relate` has them.
class RelationsPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  RelationsPanel(StudyController& study, ViewContents& contents, const FileQuestions& questions,
                 QWidget* parent = nullptr);

Q_SIGNALS:
  /// The user chose a pair: show where it is nearest (world, mm).
  void Chosen(const Vector3& pointWorld);

private:
  QTableWidget* MakeTable(const char* name, const QStringList& heads);
  std::vector<NamedSurface> Displayed() const;
  void Measure();
  void Take(std::shared_ptr<const OrganRelations> found);
  void FillPairs();
  void FillShapes();
  void ShowPlaceOf(int row);
  void Save();

  StudyController& Study;
  ViewContents& Contents;
  const FileQuestions& Questions;
  QTableWidget* Pairs;
  QTableWidget* Shapes;
  QPushButton* Measuring;
  QPushButton* Saving;
  QLabel* Line;
  PanelJob* Job;
  std::shared_ptr<const OrganRelations> Found;
};
} // namespace palpate
