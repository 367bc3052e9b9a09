#include "BaselineImage.h"
#include "CommandRun.h"
#include "WidgetImage.h"
#include "WindowTest.h"

#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QMimeData>
#include <QSlider>
#include <QStyleFactory>
#include <QTableWidget>
#include <QUrl>

#include <cmath>

namespace palpate
{
namespace
{
// Documentation/Tutorial/FeelAProstate.md, step by step, as a new user does. The screenshots are
// those of the page; the style is Qt's own, so that they look the same on every machine.
class TutorialTest : public test::WindowTest
{
protected:
  void SetUp() override
  {
    test::WindowTest::SetUp();
    if (!IsSkipped())
    {
      QApplication::setStyle(QStyleFactory::create("Fusion"));
      this->Window->resize(1180, 760);
    }
  }

  std::filesystem::path File(const std::string& name) const { return this->Phantom.Folder / name; }
  void DropFiles(const std::vector<std::string>& names)
  {
    QMimeData data;
    QList<QUrl> urls;
    for (const std::string& name : names)
    {
      urls += QUrl::fromLocalFile(QString::fromStdString(this->File(name).string()));
    }
    data.setUrls(urls);
    QDragEnterEvent enter({300, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(this->Window.get(), &enter);
    QDropEvent drop({300.0, 300.0}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(this->Window.get(), &drop);
  }
  void Raise(const char* panel) { this->Window->findChild<QDockWidget*>(panel)->raise(); }
  void ExpectBaseline(const std::string& name)
  {
    DrawAll(*this->Window->Views());
    test::ExpectLikeBaseline(test::ImageOf(*this->Window),
                             std::filesystem::path(PALPATE_DOCUMENTATION_IMAGES) / name);
  }
  const FitResult& Fit()
  {
    return *this->Study->Current().Pipeline().Newest<FitResult>(SceneStep::Model, 1);
  }
  double Force() const
  {
    const PlainVector3& force = this->Study->Reading().Newest.ForceWorld;
    return std::hypot(force.X, force.Y, force.Z);
  }
  // With the pointer over the gland, one wheel step after the other until it is touched.
  void PressByWheel()
  {
    QWidget* canvas = this->Window->Views()->Space()->Canvas();
    const QPointF place = this->PlaceOf(CenterOf(this->Fit().Model));
    Move(canvas, place);
    std::uint64_t last = 0;
    this->FeelUntil(
        [&]
        {
          const TouchState& newest = this->Study->Reading().Newest;
          const bool isFelt = this->Force() > 0.6;
          if (!isFelt && newest.Tick.Number >= last + 20)
          {
            last = newest.Tick.Number;
            Wheel(canvas, place, 1);
          }
          return isFelt;
        });
  }
  // The same position and force each time: 1.4 mm below the point where the line to the eye leaves
  // the gland.
  void HoldStill()
  {
    const SphericalHarmonicModel& gland = *this->Fit().Radial();
    const Vector3 toEye = this->Window->Views()->Space()->Axes().col(2);
    const Vector3 place = gland.CenterWorld() + (gland.Radius(toEye) - 1.4) * toEye;
    std::uint64_t since = 0;
    double former = 0.0;
    this->FeelUntil(
        [&]
        {
          this->Study->Current().Touch().MoveHand(place);
          const bool isSteady = this->Force() > 0.1 && std::abs(this->Force() - former) < 1e-4;
          const std::uint64_t now = this->Study->Reading().Newest.Tick.Number;
          since = isSteady ? since : now;
          former = this->Force();
          return now > since + 800;
        });
  }

  void OpenAndLook();
  void Judge();
  void Touch();
  void Replay();
  void Keep();
};

void TutorialTest::OpenAndLook()
{
  this->DropFiles({"prostate/volume.nii.gz", "prostate/mask.nii.gz"});
  WaitUntil([this] { return !this->Study->State().Structures.empty(); });
  this->Settle();
  DrawAll(*this->Window->Views());
  SlicePane* axial = this->Window->Views()->Slice(SliceOrientation::Axial);
  Click(axial->Canvas(),
        {0.5 * axial->Canvas()->width() + 20.0, 0.5 * axial->Canvas()->height() + 12.0});
  EXPECT_EQ(this->Messages(), "");
  this->ExpectBaseline("tutorial-open.png");
}

void TutorialTest::Judge()
{
  EXPECT_EQ(this->Fit().State, FitResult::Outcome::Fitted);
  const double fine = this->Fit().ModelToMask.Mean;
  EXPECT_LT(fine, 0.3); // mm; a tenth of a slice
  auto* degree = this->Window->findChild<QDoubleSpinBox*>("Degree of all");
  degree->setValue(4);
  this->Settle();
  EXPECT_GT(this->Fit().ModelToMask.Mean, fine);
  this->Action("All as error maps")->trigger();
  this->Settle();
  this->ExpectBaseline("tutorial-error.png");
  this->Action("Undo")->trigger();
  this->Action("Undo")->trigger();
  this->Settle();
  EXPECT_EQ(this->Fit().ModelToMask.Mean, fine);
}

void TutorialTest::Touch()
{
  this->Button("start-touch")->click();
  WaitUntil([this] { return this->Study->IsTouching() || !this->Messages().empty(); });
  ASSERT_TRUE(this->Study->IsTouching()) << this->Messages();
  this->Action("Slices follow the probe")->trigger();
  this->PressByWheel();
  this->HoldStill();
  this->Button("add-touched")->click();
  ASSERT_EQ(this->Study->State().Landmarks.size(), 1U);
  this->Raise("Plots");
  this->ExpectBaseline("tutorial-touch.png");
}

// Records the touch and replays it.
void TutorialTest::Replay()
{
  const auto file = QString::fromStdString(this->File("prostate/case.touch").string());
  this->SavedTo = file;
  this->Button("record")->click();
  ASSERT_TRUE(this->Study->Current().Touch().IsRecording()) << this->Messages();
  this->HoldStill();
  this->Button("record")->click();
  this->Button("start-touch")->click();
  EXPECT_FALSE(this->Study->IsTouching());
  this->Opened = QStringList{file};
  this->Action("Open a recording")->trigger();
  WaitUntil([this] { return this->Study->Current().Replay() != nullptr; });
  auto* slider = this->Window->findChild<QSlider*>("replay-slider");
  slider->setValue(slider->maximum());
  WaitUntil([this] { return this->Window->Contents().Probe()->GetInContact(); });
  this->ExpectBaseline("tutorial-replay.png");
  this->Button("replay-close")->click();
}

void TutorialTest::Keep()
{
  this->SavedTo = QString::fromStdString(this->File("marks.mrk.json").string());
  this->Button("export-landmarks")->click();
  EXPECT_TRUE(std::filesystem::exists(this->File("marks.mrk.json"))) << this->Messages();
  this->SavedTo = QString::fromStdString(this->File("prostate/case.palpate.json").string());
  this->Action("Save as")->trigger();
  ASSERT_TRUE(std::filesystem::exists(this->File("prostate/case.palpate.json")));
  const test::CommandRun run = test::RunPalpate(
      {"study", "prostate/case.palpate.json", "--output", "results"}, this->Phantom.Folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_TRUE(std::filesystem::exists(this->File("results/markups.csv")));
}

TEST_F(TutorialTest, TenStepsLeadToTouchedProstate)
{
  const test::CommandRun run =
      test::RunPalpate({"phantom", "--output", "prostate"}, this->Phantom.Folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  ASSERT_NO_FATAL_FAILURE(this->OpenAndLook());
  ASSERT_NO_FATAL_FAILURE(this->Judge());
  ASSERT_NO_FATAL_FAILURE(this->Touch());
  ASSERT_NO_FATAL_FAILURE(this->Replay());
  ASSERT_NO_FATAL_FAILURE(this->Keep());
}
} // namespace
} // namespace palpate
