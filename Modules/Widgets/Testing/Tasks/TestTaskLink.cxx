#include "TaskWindow.h"

#include "vtkMatrix4x4.h"

#include <QDockWidget>
#include <QDropEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QUrl>

#include <array>
#include <cmath>

namespace palpate::task_link_test
{
namespace
{
using test::BallRadius;

using TaskLinkTest = test::TaskWindow;

TEST_F(TaskLinkTest, WholeTaskSurvivesPauseAndKill)
{
  this->Window->resize(test::TaskSizes[0]);
  this->Write(ShortTask(TaskKind::Landmarks));
  this->Begin();
  EXPECT_EQ(this->Text("task-page-progress"), "Training, trial 1 of 6");
  this->DoTrial();
  this->DoTrial();
  // Killed in the third, and resumed in a smaller window.
  this->StartTrial();
  EXPECT_EQ(this->Text("task-progress"), "Trial 3 of 6");
  this->MarkAll({{"front", {0.0, -BallRadius, 0.0}}});
  this->KillAndStartAgain();
  TaskForm* form = this->OpenForm();
  ASSERT_NE(form, nullptr);
  EXPECT_EQ(form->findChild<QPushButton*>("task-begin")->text(), "Resume");
  EXPECT_EQ(form->findChild<QLabel*>("task-state")->text(),
            "Resumes at trial 3 of 6, with the answers of its beginning.");
  this->Window->resize(test::TaskSizes[1]);
  ClickOn(form->findChild<QPushButton*>("task-begin"));
  this->DoTrial();
  // The pause that is due.
  EXPECT_EQ(this->Text("task-page-progress"), "Training, trial 4 of 6: pause");
  this->LookOftenEnough();
  EXPECT_FALSE(this->Button("task-start")->isEnabled());
  EXPECT_TRUE(this->Text("task-page-state").startsWith("The pause lasts"));
  this->LetPass(LeastPause);
  this->Window->resize(test::TaskSizes[2]);
  for (int trial = 4; trial <= 6; ++trial)
  {
    this->DoTrial();
  }
  WaitUntil([this] { return this->Button("task-open-folder")->isVisible(); });
  const TaskResults results = ReadTaskResults(this->Results());
  ASSERT_EQ(results.Rows.size(), 6U);
  EXPECT_EQ(test::ReadAll(this->Results() / "results.csv"), TaskResultsCsv(results));
  EXPECT_EQ(results.Participants[0].Answers.at("years"), "3");
  EXPECT_EQ(results.Participants[0].Answers.at("hand"), "left");
  for (const TaskResult& row : results.Rows)
  {
    EXPECT_EQ(row.End.Attempt, row.End.Trial == 3 ? 2 : 1);
    EXPECT_EQ(row.End.Conduct.End, TaskEnd::Done);
    const double error = ValueOf(row, TaskKind::Landmarks, "error_max_mm");
    // The pointer leads the tool's centre, of 1 mm; without force that is deep in the ball.
    EXPECT_LT(error, row.End.Condition == "force" ? 1.5 : 12.0) << row.End.Trial;
    EXPECT_EQ(row.End.Conduct.PeakForce > 0.1, row.End.Condition == "force");
    EXPECT_TRUE(this->IsRecorded(row.End)) << row.End.Trial;
  }
  ClickOn(this->Button("task-page-stop"));
  EXPECT_FALSE(this->Link()->IsOpen());
  EXPECT_TRUE(this->Window->menuBar()->isEnabled());
}

TEST_F(TaskLinkTest, EscapeStopsForceAndTheTrialBeginsAgain)
{
  this->Write(OneTrial(TaskKind::Landmarks));
  this->Begin();
  this->StartTrial();
  this->PressAt({0.0, -BallRadius, 0.0});
  QTest::keyClick(this->Window.get(), Qt::Key_Escape);
  EXPECT_FALSE(this->Study->IsTouching());
  ASSERT_TRUE(this->Link()->IsResting());
  WaitUntil([this] { return this->Text("task-page-state").contains("begins again"); });
  EXPECT_EQ(this->Log().size(), 2U) << "begun, and not ended";
  this->DoTrial();
  EXPECT_NE(this->LastResult().find(R"("attempt":2)"), std::string::npos) << this->LastResult();
}

TEST_F(TaskLinkTest, NothingElseCanBeDoneDuringATask)
{
  this->Write(OneTrial(TaskKind::Landmarks));
  this->Begin();
  this->StartTrial();
  const StudyState before = this->Study->State();
  this->Opened = QStringList{QString::fromStdString(this->MaskFile().string())};
  const std::array<std::pair<Qt::Key, Qt::KeyboardModifier>, 5> keys{
      {{Qt::Key_O, Qt::ControlModifier},
       {Qt::Key_A, Qt::NoModifier},
       {Qt::Key_T, Qt::NoModifier},
       {Qt::Key_T, Qt::ControlModifier},
       {Qt::Key_N, Qt::ControlModifier}}};
  for (const auto& [key, modifier] : keys)
  {
    Activate(*this->Window);
    QTest::keyClick(this->Window->Views()->Space()->Canvas(), key, modifier);
  }
  EXPECT_EQ(this->Study->State(), before);
  EXPECT_FALSE(this->Study->IsBusy());
  EXPECT_TRUE(this->Study->IsTouching());
  EXPECT_FALSE(this->Action("Draw by touch")->isChecked());
  EXPECT_FALSE(this->Window->acceptDrops());
  for (const auto* dock : this->Window->findChildren<QDockWidget*>())
  {
    EXPECT_FALSE(dock->isVisible()) << dock->objectName().toStdString();
  }
  ClickOn(this->Button("task-stop"));
  EXPECT_FALSE(this->Link()->IsOpen());
  EXPECT_TRUE(this->Window->findChild<QDockWidget*>("Work")->isVisible());
}

TEST_F(TaskLinkTest, WithoutForceTheToolIsShownWhereTheHandIs)
{
  this->Write(OneTrial(TaskKind::Landmarks, false));
  this->Begin();
  this->StartTrial();
  this->PressAt({0.0, -BallRadius, 0.0});
  const TouchState& newest = this->Study->Reading().Newest;
  EXPECT_EQ(test::Norm(newest.ForceWorld), 0.0);
  EXPECT_GT((Vector3(newest.ProxyWorld) - this->Probe()).norm(), 0.3) << "a wall would hold it";
  const vtkMatrix4x4* place = this->Window->Contents().Probe()->GetProxyMatrix();
  const Vector3 shown(place->GetElement(0, 3), place->GetElement(1, 3), place->GetElement(2, 3));
  EXPECT_LT((shown - this->Probe()).norm(), 1e-9);
  EXPECT_FALSE(this->Window->Contents().Probe()->GetInContact());
}

TEST_F(TaskLinkTest, ForceThatIsFeltIsNotSeen)
{
  this->Write(OneTrial(TaskKind::Landmarks));
  this->Begin();
  this->StartTrial();
  vtkProbeRepresentation* probe = this->Window->Contents().Probe();
  this->PressAt({0.0, -BallRadius, 0.0});
  EXPECT_TRUE(probe->GetInContact()) << "a mouse pushes nothing";
  ViewContents contents;
  contents.HideForce(true);
  contents.ShowTouch(this->Study->Reading(), true);
  EXPECT_FALSE(contents.Probe()->GetInContact());
  EXPECT_EQ(Vector3(contents.Probe()->GetForce()).norm(), 0.0);
}

TEST_F(TaskLinkTest, LimitsEndATrial)
{
  TaskSettings task = OneTrial(TaskKind::Landmarks);
  task.MostSeconds = 1.0;
  this->Write(task);
  this->Begin();
  this->StartTrial();
  EXPECT_TRUE(this->Text("task-time").endsWith(" left")) << this->Text("task-time").toStdString();
  WaitUntil([this] { return this->Link()->IsResting(); });
  EXPECT_NE(this->LastResult().find(R"("ended_by":"time")"), std::string::npos);
}

TEST_F(TaskLinkTest, NextWithoutAnAnswerGivesUp)
{
  this->Write(OneTrial(TaskKind::Landmarks));
  this->Begin();
  this->StartTrial();
  this->EndTrial();
  EXPECT_NE(this->LastResult().find(R"("ended_by":"given-up")"), std::string::npos);
}

TEST_F(TaskLinkTest, NoduleIsMarkedAndSized)
{
  this->Write(OneTrial(TaskKind::Nodule));
  this->Begin();
  this->StartTrial();
  this->PressAt({1.0, BallRadius, 2.0});
  this->Mark();
  this->Release({1.0, BallRadius, 2.0});
  auto* diameter = this->Window->findChild<QDoubleSpinBox*>("task-diameter");
  diameter->setFocus();
  diameter->selectAll();
  QTest::keyClicks(diameter, "9");
  this->EndTrial();
  const TaskResults results = ReadTaskResults(this->Results());
  EXPECT_LT(ValueOf(results.Rows[0], TaskKind::Nodule, "distance_mm"), 1.0);
  EXPECT_EQ(ValueOf(results.Rows[0], TaskKind::Nodule, "size_error_mm"), 1.0);
}

TEST_F(TaskLinkTest, StrokeAroundABallIsItsOutline)
{
  this->Write(OneTrial(TaskKind::Outline));
  this->Begin();
  this->StartTrial();
  ASSERT_TRUE(this->Action("Draw by touch")->isChecked());
  const SlicePane* slice = this->Window->Views()->Slice(SliceOrientation::Axial);
  const auto at = [&](double angle)
  { return PlaceIn(*slice, BallRadius * Vector3(std::cos(angle), std::sin(angle), 0.0)); };
  SendMouse(slice->Canvas(), QEvent::MouseButtonPress, at(0.0), Qt::LeftButton, Qt::LeftButton);
  for (int n = 1; n <= 60; ++n)
  {
    SendMouse(slice->Canvas(), QEvent::MouseMove, at(0.1 * n), Qt::NoButton, Qt::LeftButton);
  }
  SendMouse(slice->Canvas(), QEvent::MouseButtonRelease, at(6.0), Qt::LeftButton, Qt::NoButton);
  this->Show("task-outline");
  this->EndTrial();
  EXPECT_FALSE(this->Action("Draw by touch")->isChecked());
  const TaskResults results = ReadTaskResults(this->Results());
  EXPECT_GT(ValueOf(results.Rows[0], TaskKind::Outline, "dice"), 0.97) << "a pixel is 0.2 mm";
  EXPECT_EQ(results.Rows[0].End.Conduct.End, TaskEnd::Done);
}

TEST_F(TaskLinkTest, PathIsFollowedFromItsStartAndEndsByItself)
{
  TaskSettings task = OneTrial(TaskKind::Path);
  for (TaskTarget& target : task.Targets)
  {
    target.Points.resize(10); // a quarter of the circle
  }
  this->Write(task);
  this->Begin();
  this->StartTrial();
  this->Show("task-path");
  // Around the ball and from outside, so that the way to the start is not a part of the path.
  for (const double height : {40.0, 0.0})
  {
    const Vector3 place(35.0, -5.0, height);
    this->FeelUntil(
        [&]
        {
          this->Study->Current().Touch().MoveHand(place);
          return (this->Probe() - place).norm() < 2.0;
        });
  }
  // Slowly, so that the hand does not overshoot into the ball.
  double radius = 35.0;
  double angle = 0.0;
  this->FeelUntil(
      [&]
      {
        const Vector3 goal = radius * Vector3(std::cos(angle), std::sin(angle), 0.0);
        this->Study->Current().Touch().MoveHand(goal);
        const bool isThere = (this->Probe() - goal).norm() < 1.5;
        radius -= isThere && radius > 23.0 ? 0.5 : 0.0;
        angle += isThere && radius <= 23.0 ? 0.02 : 0.0;
        return this->Link()->IsResting();
      });
  const TaskResults results = ReadTaskResults(this->Results());
  EXPECT_EQ(ValueOf(results.Rows[0], TaskKind::Path, "passed"), 1.0);
  EXPECT_EQ(ValueOf(results.Rows[0], TaskKind::Path, "wall_contacts"), 0.0);
  EXPECT_LT(ValueOf(results.Rows[0], TaskKind::Path, "deviation_mean_mm"), 3.0);
}

TEST_F(TaskLinkTest, FormRefusesWhatTheTaskDoesNotAllow)
{
  this->Write(OneTrial(TaskKind::Landmarks));
  TaskForm* form = this->OpenForm();
  ASSERT_NE(form, nullptr);
  QTest::keyClicks(form->findChild<QLineEdit*>("task-ask-years"), "seventy");
  if (const char* folder = std::getenv("PALPATE_PICTURES"))
  {
    EXPECT_TRUE(form->grab().save(QString(folder) + "/task-form.png"));
  }
  ClickOn(form->findChild<QPushButton*>("task-begin"));
  EXPECT_TRUE(form->isVisible());
  EXPECT_TRUE(form->findChild<QLabel*>("task-state")->text().contains("years"));
  EXPECT_FALSE(this->Link()->IsOpen());
}

TEST_F(TaskLinkTest, ReadyTaskIsMadeAndBegun)
{
  const QString folder = QString::fromStdString((this->Files / "ready").string());
  this->Chosen = folder;
  this->Action("Mark ten landmarks")->trigger();
  WaitUntil([this] { return this->Form() != nullptr; });
  ClickOn(this->Form()->findChild<QPushButton*>("task-begin"));
  this->StartTrial();
  EXPECT_EQ(this->Text("task-line"), "Mark base (1 of 10)");
  EXPECT_TRUE(std::filesystem::exists(this->Files / "ready" / "results" / TaskRun::LogName(1)));
  this->Show("task-landmarks");
}

TEST_F(TaskLinkTest, NothingIsClippedAtUsualSizes)
{
  for (const QSize& size : test::TaskSizes)
  {
    this->Window->resize(size);
    this->Write(OneTrial(TaskKind::Nodule));
    this->Begin();
    WaitUntil([this] { return this->Button("task-start")->isEnabled(); });
    this->Show(QString("task-page-%1").arg(size.width()));
    EXPECT_EQ(this->Window->size(), size);
    for (const QWidget* whole : {static_cast<QWidget*>(this->Link()->Page()),
                                 static_cast<QWidget*>(this->Link()->Strip())})
    {
      if (whole == this->Link()->Strip())
      {
        this->StartTrial();
        this->Show(QString("task-trial-%1").arg(size.width()));
        EXPECT_EQ(this->Window->size(), size);
      }
      for (const auto* button : whole->findChildren<QPushButton*>())
      {
        if (button->isVisible())
        {
          EXPECT_GE(button->width(), button->minimumSizeHint().width())
              << button->objectName().toStdString();
          EXPECT_TRUE(
              whole->rect().contains(QRect(button->mapTo(whole, QPoint(0, 0)), button->size())))
              << button->objectName().toStdString();
        }
      }
    }
    ClickOn(this->Button("task-stop"));
    std::filesystem::remove_all(this->Results());
  }
}
} // namespace
} // namespace palpate::task_link_test
