#include "ModelFile.h"
#include "TaskFile.h"
#include "TaskForm.h"
#include "TaskLink.h"
#include "TaskResults.h"
#include "TutorialWindow.h"

#include <QComboBox>
#include <QLineEdit>

#include <string>
#include <vector>

namespace palpate::task_tutorial_test
{
namespace
{
// Documentation/Tutorial/RunATask.md.
class TaskTutorial : public test::TutorialWindow
{
protected:
  void Run(const std::vector<std::string>& words)
  {
    const test::CommandRun run = test::RunPalpate(words, this->Phantom.Folder.Path());
    ASSERT_EQ(run.Code, 0) << run.Errors;
  }
  TaskForm* OpenForm()
  {
    this->Opened = QStringList{QString::fromStdString(this->File("study/task.json").string())};
    this->Action("Run a task...")->trigger();
    QApplication::processEvents();
    // One that was closed may still be there.
    return this->Window->findChildren<TaskForm*>().last();
  }
  void Begin()
  {
    TaskForm* form = this->OpenForm();
    form->findChild<QComboBox*>("task-ask-hand")->setCurrentText("right");
    form->findChild<QLineEdit*>("task-ask-years")->setText("12");
    form->findChild<QPushButton*>("task-begin")->click();
    this->AwaitPage();
  }
  void AwaitPage()
  {
    WaitUntil([this] { return this->Button("task-start")->isEnabled(); });
  }
  void StartTrial()
  {
    this->AwaitPage();
    this->Button("task-start")->click();
    WaitUntil([this] { return this->Button("task-next")->isEnabled(); });
    DrawAll(*this->Window->Views());
  }
  // The first landmark.
  void TouchTheBase(const std::string& target)
  {
    const RadialModel gland =
        std::get<RadialModel>(ReadModel(this->File("study/" + target + "/gland.json")).Surface);
    const Vector3 up = Vector3::UnitZ();
    this->HoldStill(gland.PointWorld(up) + 0.5 * gland.Normal(up), gland.Normal(up));
  }
  // Two trials, of which each condition has one.
  void Shorten()
  {
    TaskSettings task = ReadTask(this->File("study/task.json"));
    task.Trials = 1;
    task.TrainingTrials = 0;
    task.PauseAfter = 0;
    test::WriteAll(this->File("study/task.json"), TaskText(task, this->File("study")));
    std::filesystem::remove_all(this->File("study/results"));
  }
};

TEST_F(TaskTutorial, SixStepsLeadToATable)
{
  this->Run({"task", "init", "landmarks", "--output", "study"});
  this->Run({"task", "check", "study/task.json"});
  this->Begin();
  this->ExpectBaseline("tutorial-task-page.png");
  this->StartTrial();
  this->TouchTheBase("training");
  this->ExpectBaseline("tutorial-task-trial.png");
  this->Button("task-stop")->click();
  TaskForm* form = this->OpenForm();
  EXPECT_EQ(form->findChild<QLabel*>("task-state")->text(),
            "Resumes at trial 1 of 8, with the answers of its beginning.");
  form->reject();
  this->Shorten();
  this->Begin();
  for (int trial = 0; trial < 2; ++trial)
  {
    this->StartTrial();
    this->Button("task-mark")->click();
    this->Button("task-next")->click();
  }
  WaitUntil([this] { return this->Button("task-open-folder")->isVisible(); });
  const std::string ofWindow = test::ReadAll(this->File("study/results/results.csv"));
  EXPECT_EQ(ReadTaskResults(this->File("study/results")).Rows.size(), 2U);
  this->Run({"task", "results", "study/results", "--output", "again"});
  EXPECT_EQ(test::ReadAll(this->File("again/results.csv")), ofWindow);
}
} // namespace
} // namespace palpate::task_tutorial_test
