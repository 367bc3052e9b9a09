#include "ModelFile.h"
#include "SegmentationFile.h"
#include "TaskFile.h"
#include "TaskForm.h"
#include "TaskLink.h"
#include "TaskResults.h"
#include "TutorialWindow.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <QComboBox>
#include <QLineEdit>

#include <cmath>
#include <string>
#include <utility>
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
  TaskForm* OpenForm(const std::string& task = "study/task.json")
  {
    this->Opened = QStringList{QString::fromStdString(this->File(task).string())};
    this->Action("Run a task...")->trigger();
    QApplication::processEvents();
    // One that was closed may still be there.
    return this->Window->findChildren<TaskForm*>().last();
  }
  void Begin(const std::string& task = "study/task.json")
  {
    TaskForm* form = this->OpenForm(task);
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
  // Where a mask ends in a direction from the middle of the displayed axial slice.
  Vector3 EdgeOf(const Segmentation& labels, double angle) const
  {
    vtkImageData* image = labels.Layers.front();
    Vector3 edge = Vector3::Zero();
    for (double radius = 0.0; radius < 60.0; radius += 0.25)
    {
      Vector3 place(radius * std::cos(angle), radius * std::sin(angle),
                    this->Window->Contents().Crosshair()->GetPositionWorld()[2]);
      const vtkIdType point = image->FindPoint(place.data());
      const bool isInside = point >= 0 && image->GetPointData()->GetScalars()->GetTuple1(point) > 0;
      edge = isInside ? place : edge;
    }
    return edge;
  }
  // From a mask's edge to the true one, where they differ most.
  std::pair<Vector3, Vector3> LargestError(const std::string& folder) const
  {
    const Segmentation start = ReadSegmentation(this->File(folder + "/start.nii.gz"));
    const Segmentation truth = ReadSegmentation(this->File(folder + "/true.nii.gz"));
    std::pair<Vector3, Vector3> largest{Vector3::Zero(), Vector3::Zero()};
    for (double angle = 0.0; angle < 2.0 * M_PI; angle += 0.1)
    {
      const std::pair edges{this->EdgeOf(start, angle), this->EdgeOf(truth, angle)};
      const bool isLarger =
          (edges.second - edges.first).norm() > (largest.second - largest.first).norm();
      largest = isLarger ? edges : largest;
    }
    return largest;
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

TEST_F(TaskTutorial, MaskIsPulledOntoTheOrgansEdge)
{
  this->Run({"task", "init", "mask", "--output", "masks"});
  this->Begin("masks/task.json");
  this->StartTrial();
  const SlicePane* slice = this->Window->Views()->Slice(SliceOrientation::Axial);
  // In the middle of voxels, and once the hand, which slices follow, has come to rest.
  const Vector3 middle = Vector3::Constant(0.3);
  std::uint64_t since = 0;
  Vector3 former = middle;
  this->FeelUntil(
      [&]
      {
        const TouchState& newest = this->Study->Reading().Newest;
        const bool isStill = (Vector3(newest.ProbeWorld) - former).norm() < 1e-3;
        former = Vector3(newest.ProbeWorld);
        since = isStill ? since : newest.Tick.Number;
        return newest.Tick.Number > since + 800;
      });
  this->Window->Contents().Crosshair()->SetPositionWorld(middle.data());
  DrawAll(*this->Window->Views());
  const auto [wrong, right] = this->LargestError("masks/training");
  const auto at = [&, from = wrong, way = Vector3(right - wrong)](double part)
  { return PlaceIn(*slice, from + part * way); };
  SendMouse(slice->Canvas(), QEvent::MouseMove, at(0.0), Qt::NoButton, Qt::NoButton);
  SendMouse(slice->Canvas(), QEvent::MouseButtonPress, at(0.0), Qt::LeftButton, Qt::LeftButton);
  for (int n = 1; n <= 8; ++n)
  {
    SendMouse(slice->Canvas(), QEvent::MouseMove, at(n / 8.0), Qt::NoButton, Qt::LeftButton);
  }
  this->ExpectBaseline("tutorial-task-mask.png");
  SendMouse(slice->Canvas(), QEvent::MouseButtonRelease, at(1.0), Qt::LeftButton, Qt::NoButton);
  EXPECT_EQ(this->Study->State().Correction.Steps.size(), 1U);
  this->Button("task-next")->click();
  WaitUntil([this] { return this->Button("task-start")->isEnabled(); });
  EXPECT_NE(test::ReadAll(this->File("masks/results/participant-0001.jsonl")).find("\"dice\""),
            std::string::npos);
}

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
