#pragma once

#include "TaskCases.h"
#include "TaskLink.h"
#include "TaskLog.h"
#include "TaskResults.h"
#include "WindowTest.h"

#include <QComboBox>
#include <QTest>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace palpate::test
{
/// The last is 1600 x 1000 at scale 2.
inline const std::array<QSize, 3> TaskSizes{QSize(1280, 800), QSize(1024, 700), QSize(800, 500)};
/// A ball of 20 mm, whose tasks are run by real events; forces are those of the mouse as the hand.
class TaskWindow : public WindowTest
{
protected:
  static constexpr double LeastPause = 2.0; // s

  void SetUp() override
  {
    WindowTest::SetUp();
    if (!IsSkipped() && !std::filesystem::exists(this->Files / "ball.json"))
    {
      WriteBall(this->Files);
    }
  }
  // Two conditions; in each a training trial and two others. Each target is seen from the front.
  static TaskSettings ShortTask(TaskKind kind)
  {
    TaskSettings task = TaskOf(kind);
    task.Title = "Mark two landmarks";
    task.Instructions = "Mark each displayed landmark on the organ's surface.";
    task.PauseSeconds = LeastPause;
    for (TaskTarget& target : task.Targets)
    {
      target.Scene = "ball.scene.json";
      if (kind == TaskKind::Landmarks)
      {
        target.Points = {{"front", {0.0, -BallRadius, 0.0}},
                         {"upper", BallRadius * Vector3(0.0, -0.8, 0.6)}};
      }
    }
    return task;
  }
  static TaskSettings OneTrial(TaskKind kind, bool hasForce = true)
  {
    TaskSettings task = ShortTask(kind);
    task.Conditions = {{"only", hasForce, {}}};
    task.Trials = 1;
    task.TrainingTrials = 0;
    return task;
  }
  void Write(TaskSettings task)
  {
    for (TaskTarget& target : task.Targets)
    {
      target.Scene = this->Files / target.Scene;
    }
    WriteAll(this->TaskFile(), TaskText(task, this->Files.Path()));
  }
  std::filesystem::path TaskFile() const { return this->Files / "task.json"; }
  std::filesystem::path Results() const { return this->Files / "results"; }
  std::vector<std::string> Log(int participant = 1) const
  {
    return TaskLog::ReadLines(this->Results() / TaskRun::LogName(participant));
  }
  std::string LastResult() const { return this->Log().back(); }

  TaskForm* OpenForm()
  {
    this->Opened = QStringList{QString::fromStdString(this->TaskFile().string())};
    Activate(*this->Window);
    QTest::keyClick(this->Window.get(), Qt::Key_T, Qt::ControlModifier | Qt::AltModifier);
    QApplication::processEvents();
    TaskForm* form = this->Form();
    EXPECT_NE(form, nullptr) << this->Messages();
    return form;
  }
  // Those that were closed may still be there.
  TaskForm* Form() const
  {
    for (auto* form : this->Window->findChildren<TaskForm*>())
    {
      if (form->isVisible())
      {
        return form;
      }
    }
    return nullptr;
  }
  void Begin()
  {
    TaskForm* form = this->OpenForm();
    ASSERT_NE(form, nullptr);
    QTest::keyClicks(form->findChild<QLineEdit*>("task-ask-years"), "3");
    QTest::keyClick(form->findChild<QComboBox*>("task-ask-hand"), Qt::Key_Down);
    ClickOn(form->findChild<QPushButton*>("task-begin"));
    ASSERT_TRUE(this->Link()->IsOpen());
  }
  TaskLink* Link() const { return this->Window->findChild<TaskLink*>(); }
  static void ClickOn(QPushButton* button)
  {
    QTest::mouseClick(button, Qt::LeftButton);
    QApplication::processEvents();
  }
  QString Text(const char* label) const { return this->Window->findChild<QLabel*>(label)->text(); }
  // Waits for the page, and leaves it for a trial that runs.
  void StartTrial()
  {
    QPushButton* start = this->Button("task-start");
    WaitUntil([&] { return this->Link()->IsResting() && start->isEnabled(); });
    ClickOn(start);
    WaitUntil([this] { return this->Button("task-next")->isEnabled(); });
    DrawAll(*this->Window->Views());
  }
  void EndTrial()
  {
    Activate(*this->Window);
    QTest::keyClick(this->Window.get(), Qt::Key_N);
    ASSERT_TRUE(this->Link()->IsResting());
  }
  // By mouse: over the place, pressed, and held until it is felt, or deep enough to be seen.
  void PressAt(const Vector3& world)
  {
    QWidget* canvas = this->Window->Views()->Space()->Canvas();
    const QPointF place = this->PlaceOf(world);
    Move(canvas, place);
    WaitUntil([&] { return (this->Probe() - world).norm() < 6.0; });
    SendMouse(canvas, QEvent::MouseButtonPress, place, Qt::LeftButton, Qt::LeftButton);
    this->FeelUntil([&] { return this->Study->Reading().Newest.Depth > 0.5; });
  }
  void Release(const Vector3& world)
  {
    SendMouse(this->Window->Views()->Space()->Canvas(), QEvent::MouseButtonRelease,
              this->PlaceOf(world), Qt::LeftButton, Qt::NoButton);
  }
  Vector3 Probe() const { return Vector3(this->Study->Reading().Newest.ProbeWorld); }
  void Mark()
  {
    Activate(*this->Window);
    QTest::keyClick(this->Window.get(), Qt::Key_Space);
  }
  void MarkAll(const std::vector<TaskPoint>& points)
  {
    for (const TaskPoint& point : points)
    {
      this->PressAt(point.PointWorld);
      this->Mark();
      this->Release(point.PointWorld);
    }
  }
  void DoTrial()
  {
    this->StartTrial();
    this->MarkAll(ShortTask(TaskKind::Landmarks).Targets[0].Points);
    this->EndTrial();
  }
  // Until a scene was read, and the window had time to say what it knows.
  void LookOftenEnough()
  {
    constexpr int Enough = 5;
    int looks = 0;
    const auto link =
        QObject::connect(this->Study.get(), &StudyController::StepsChanged, [&looks] { ++looks; });
    WaitUntil([&] { return looks >= Enough && !this->Study->IsBusy(); });
    QObject::disconnect(link);
  }
  // Virtual time: nothing waits for it but the pause.
  void LetPass(double seconds)
  {
    this->Time->WaitUntil(this->Time->Now() + static_cast<std::int64_t>(1e9 * seconds));
  }
  // Of a window that a busy machine held up, a part is kept.
  bool IsRecorded(const TaskEvent& end) const
  {
    const std::string name = "participant-0001-trial-" + std::to_string(end.Trial) + "-attempt-" +
                             std::to_string(end.Attempt) + ".touch";
    const std::filesystem::directory_iterator files(this->Results());
    return std::any_of(begin(files), std::filesystem::directory_iterator(),
                       [&](const auto& file)
                       { return file.path().filename().string().rfind(name, 0) == 0; });
  }
  // As if the program were killed: nothing more is written.
  void KillAndStartAgain()
  {
    const std::vector<std::string> before = this->Log();
    this->TearDown();
    EXPECT_EQ(this->Log(), before);
    this->SetUp();
  }
  // Written where PALPATE_PICTURES says, for people to look at.
  void Show(const QString& name)
  {
    DrawAll(*this->Window->Views());
    if (const char* folder = std::getenv("PALPATE_PICTURES"))
    {
      EXPECT_TRUE(this->Window->grab().save(QString(folder) + "/" + name + ".png"));
    }
  }

  TemporaryFolder Files;
};
} // namespace palpate::test
