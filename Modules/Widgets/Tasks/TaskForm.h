#pragma once

#include "DeviceChoice.h"
#include "FileQuestions.h"
#include "TaskRun.h"
#include "TaskSettings.h"

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

class QFormLayout;

namespace palpate
{
/// Asks who does a task, as a number and what the task's file asks for, and begins or resumes the
/// run in the folder of the results.
class TaskForm : public QDialog
{
  Q_OBJECT

public:
  /// Keeps the address of `questions`. `folder` and `device` are proposals; the number is that of
  /// the first participant who has not finished there.
  TaskForm(const TaskSettings& task, const std::filesystem::path& folder, const std::string& device,
           const FileQuestions& questions, QWidget* window);

  /// Once it is accepted.
  std::unique_ptr<TaskRun> TakeRun() { return std::move(this->Run); }
  std::filesystem::path Folder() const { return this->Results->text().toStdString(); }
  std::string Device() const { return this->Devices->Chosen(); }
  TaskParticipant Participant() const;

  void accept() override;

private:
  void AddQuestions(QFormLayout* form);
  QWidget* MakeFolder(const FileQuestions& questions, const std::filesystem::path& folder);
  bool HasLog(int number) const;
  void ChooseNumber();
  void Look();

  TaskSettings Task;
  std::unique_ptr<TaskRun> Run;
  QSpinBox* Number;
  QLineEdit* Results;
  DeviceChoice* Devices;
  QLabel* Line;
  QPushButton* Ok;
  std::vector<QWidget*> Boxes;                   ///< of the questions
  std::vector<std::function<QString()>> Replies; ///< in them
};
} // namespace palpate
