#pragma once

#include "FileQuestions.h"
#include "OrganRelations.h"
#include "StudyController.h"
#include "ViewContents.h"

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTimer>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>

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
  ~RelationsPanel() override;

Q_SIGNALS:
  /// The user chose a pair: show where it is nearest (world, mm).
  void Chosen(const Vector3& pointWorld);

private:
  QTableWidget* MakeTable(const char* name, const QStringList& heads);
  std::vector<NamedSurface> Displayed() const;
  void MeasureOrCancel();
  void Measure();
  /// Runs it in the background; what it returns is called in the window's thread.
  void Run(std::function<StudyJob::Delivery(const ProgressFunction& progress)> work);
  void End(const QString& text);
  void ShowProgress();
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
  QTimer Watch; ///< of the job
  std::optional<StudyJobs::Id> Job;
  std::shared_ptr<const OrganRelations> Found;
};
} // namespace palpate
