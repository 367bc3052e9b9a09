#include "PipelineLine.h"

#include "WindowTest.h"

#include <QToolButton>

#include <future>

namespace palpate::pipeline_line_test
{
namespace
{
class PipelineLineTest : public test::WindowTest
{
protected:
  PipelineLine* Line() const { return this->Window->findChild<PipelineLine*>(); }
  QToolButton* Act() const { return this->Line()->findChild<QToolButton*>("pipeline-act"); }
  int ColumnTop() const
  {
    return this->Window->findChild<WorkColumn*>()->mapTo(this->Window.get(), QPoint()).y();
  }
};

TEST_F(PipelineLineTest, TellsWhatRunsWithoutMovingAnything)
{
  EXPECT_EQ(this->Line()->Text(), "Nothing is open");
  EXPECT_TRUE(this->Act()->isHidden());
  const int top = this->ColumnTop();
  const int height = this->Line()->height();
  QStringList told;
  QObject::connect(this->Study.get(), &StudyController::StepsChanged,
                   [&]
                   {
                     told += this->Line()->Text();
                     QApplication::processEvents(QEventLoop::ExcludeUserInputEvents);
                     EXPECT_EQ(this->ColumnTop(), top);
                     EXPECT_EQ(this->Line()->height(), height);
                   });
  this->OpenPhantom(FitSettings());
  EXPECT_TRUE(told.filter(" of 3").size() > 0) << told.join(", ").toStdString();
  // One voxel cannot be modelled.
  WaitUntil([this] { return this->Line()->Text().contains("failed"); });
  EXPECT_TRUE(this->Act()->isHidden());
}

TEST_F(PipelineLineTest, StepIsCancelledAndRunAgain)
{
  this->OpenPhantom();
  std::promise<void> released;
  StudyJob job; // keeps the study's only worker
  job.IsUrgent = true;
  job.Work = [wait = released.get_future().share()](const ProgressFunction&)
  {
    wait.wait();
    return StudyJob::Delivery([] {});
  };
  this->Study->Current().Jobs().Start(std::move(job));
  StudyState next = this->Study->State();
  next.Structures.front().Degree = 5;
  this->Study->Change("Change the degree", next);
  this->Study->CancelStep(SceneStep::Model);
  WaitUntil([this] { return this->Line()->Text() == "Model was cancelled"; });
  EXPECT_EQ(this->Act()->text(), "Run again");
  this->Act()->click();
  released.set_value();
  this->Settle();
  EXPECT_FALSE(this->Line()->Text().contains("cancelled"));
  EXPECT_TRUE(this->Act()->isHidden());
}

TEST_F(PipelineLineTest, ClickOpensAllSteps)
{
  auto* steps = this->Window->findChild<QLabel*>("state-volume");
  ASSERT_NE(steps, nullptr);
  EXPECT_FALSE(steps->window()->isVisible());
  this->Line()->findChild<QToolButton*>("pipeline")->click();
  EXPECT_TRUE(steps->window()->isVisible());
  steps->window()->close();
}
} // namespace
} // namespace palpate::pipeline_line_test
