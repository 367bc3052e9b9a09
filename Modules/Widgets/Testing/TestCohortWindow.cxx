#include "CohortWindow.h"

#include "CohortTable.h"
#include "ModelFile.h"
#include "WindowTest.h"

#include <QProgressBar>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace palpate::cohort_window_test
{
namespace
{
/// Six balls round 20 mm whose second harmonic of degree 2 grows by 4 mm a case.
class CohortWindowTest : public test::WindowTest
{
protected:
  void SetUp() override
  {
    test::WindowTest::SetUp();
    if (IsSkipped())
    {
      return;
    }
    const std::filesystem::path folder = this->Phantom.Folder / "cohort";
    std::filesystem::create_directory(folder);
    CohortTable table;
    std::string covariates = "case,age,group\n";
    for (int i = 0; i < 6; ++i)
    {
      std::vector<double> coefficients(9, 0.0);
      coefficients[0] = 20.0 * std::sqrt(4.0 * M_PI);
      coefficients[6] = 4.0 * (i - 2.5);
      CohortRow row;
      row.Case = "case " + std::to_string(i);
      row.Model = std::to_string(i) + ".json";
      row.Degree = 2;
      row.Result.State = FitResult::Outcome::Fitted;
      row.Result.Structure.Label = 1;
      row.Result.Dice = 0.9 + 0.01 * i;
      WriteModel(folder / row.Model, {RadialModel(2, coefficients, Vector3::Zero()), {}});
      table.Add({row});
      covariates += row.Case + "," + std::to_string(70 - i) + "," + (i % 2 == 0 ? "a" : "b") + "\n";
    }
    table.Write(folder / "cohort.csv");
    test::WriteAll(folder / "covariates.csv", covariates);
    this->Chosen = QString::fromStdString(folder.string());
    this->Opened = QStringList{this->Chosen + "/covariates.csv"};
    this->Action("Open cohort...")->trigger();
    this->Cohort = this->Window->findChild<CohortWindow*>();
    ASSERT_NE(this->Cohort, nullptr);
  }
  void Open()
  {
    this->Button("Open &folder...")->click();
    WaitUntil([this] { return this->State().startsWith("6 cases"); });
  }
  QPushButton* Button(const QString& text) const
  {
    for (auto* button : this->Cohort->findChildren<QPushButton*>())
    {
      if (button->text() == text)
      {
        return button;
      }
    }
    return nullptr;
  }
  QString State() const { return this->Cohort->findChild<QLabel*>("cohort-state")->text(); }
  QTableWidget* Table() const { return this->Cohort->findChild<QTableWidget*>(); }
  CohortShapeView* View() const { return this->Cohort->findChild<CohortShapeView*>(); }
  ScatterChart* Scatter() const { return this->Cohort->findChild<ScatterChart*>(); }
  QSlider* Slider(int mode) const
  {
    return this->Cohort->findChild<QSlider*>(QString("cohort-mode-%1").arg(mode));
  }

  CohortWindow* Cohort = nullptr;
};

TEST_F(CohortWindowTest, TellsHowFarTheReadingIs)
{
  const auto percents = std::make_shared<std::vector<int>>();
  auto* bar = this->Cohort->findChild<QProgressBar*>();
  QObject::connect(bar, &QProgressBar::valueChanged, bar,
                   [percents](int percent) { percents->push_back(percent); });
  this->Open();
  EXPECT_GE(percents->size(), 6U); // six models and six pictures
  EXPECT_TRUE(std::is_sorted(percents->begin(), percents->end()));
}

TEST_F(CohortWindowTest, ListsCasesWithPicturesAndNumbers)
{
  this->Open();
  ASSERT_EQ(this->Table()->rowCount(), 6);
  EXPECT_EQ(this->Table()->horizontalHeaderItem(1)->text(), "Volume, ml");
  EXPECT_FALSE(this->Table()->item(0, 0)->icon().isNull());
  this->Table()->sortByColumn(2, Qt::DescendingOrder);
  EXPECT_EQ(this->Table()->item(0, 0)->text(), "case 5"); // the highest Dice
}

// It is white where it is the mean.
TEST_F(CohortWindowTest, MeanShapeIsShadedAndBurnsOutNowhere)
{
  this->Open();
  QApplication::processEvents();
  const QImage image = this->View()->Canvas()->grabFramebuffer();
  int brightest = 0;
  int dim = 0;
  int bright = 0;
  for (int y = 0; y < image.height(); ++y)
  {
    for (int x = 0; x < image.width(); ++x)
    {
      const int grey = qRed(image.pixel(x, y));
      brightest = std::max(brightest, grey);
      bright += grey > 200 ? 1 : 0;
      dim += grey > 80 && grey <= 200 ? 1 : 0;
    }
  }
  EXPECT_LT(brightest, 252);
  EXPECT_GT(bright, 100);
  EXPECT_GT(dim, bright / 3);
}

TEST_F(CohortWindowTest, SlidersMoveTheMeanAlongModes)
{
  this->Open();
  EXPECT_NEAR(this->View()->LargestOffset(), 0.0, 1e-9);
  EXPECT_FALSE(this->Slider(2)->isEnabled()); // the shapes have one mode
  this->Slider(1)->setValue(20);
  // Two standard deviations of 4 mm times 1.87 (of 0 to 5) times the harmonic at a pole.
  const double expected = 2.0 * 4.0 * std::sqrt(3.5) * std::sqrt(5.0 / (4.0 * M_PI));
  EXPECT_NEAR(this->View()->LargestOffset(), expected, 0.05);
  this->Button("Show &mean")->click();
  EXPECT_NEAR(this->View()->LargestOffset(), 0.0, 1e-9);
}

TEST_F(CohortWindowTest, ThePictureFollowsTheSliders)
{
  this->Open();
  const auto picture = [this]
  {
    for (int turn = 0; turn < 3; ++turn)
    {
      QApplication::processEvents();
    }
    return this->View()->Canvas()->grabFramebuffer();
  };
  const QImage mean = picture();
  this->Slider(1)->setValue(30);
  const QImage moved = picture();
  EXPECT_NE(mean, moved);
  // The middle of the mean is nearly white; three deviations along the mode colour it.
  const QColor before = mean.pixelColor(mean.width() / 2, mean.height() / 2);
  const QColor after = moved.pixelColor(moved.width() / 2, moved.height() / 2);
  EXPECT_LT(before.hsvSaturation(), 40);
  EXPECT_GT(after.hsvSaturation(), before.hsvSaturation() + 20);
}

TEST_F(CohortWindowTest, ACaseIsChosenInTableAndDots)
{
  this->Open();
  this->Table()->selectRow(5);
  EXPECT_EQ(this->Cohort->Chosen(), 5);
  EXPECT_EQ(this->Scatter()->Chosen(), 5);
  EXPECT_NEAR(this->View()->LargestOffset(), 2.5 * 4.0 * std::sqrt(5.0 / (4.0 * M_PI)), 0.05);
  QApplication::processEvents();
  const auto place = this->Scatter()->PlaceOf(1);
  ASSERT_TRUE(place.has_value());
  Click(this->Scatter(), *place);
  EXPECT_EQ(this->Cohort->Chosen(), 1);
  ASSERT_FALSE(this->Table()->selectedItems().isEmpty());
  EXPECT_EQ(this->Table()->selectedItems().front()->text(), "case 1");
}

TEST_F(CohortWindowTest, MovingASliderLeavesTheCase)
{
  this->Open();
  this->Table()->selectRow(0);
  this->Slider(1)->setValue(10);
  EXPECT_EQ(this->Cohort->Chosen(), -1);
  EXPECT_TRUE(this->Table()->selectedItems().isEmpty());
}

TEST_F(CohortWindowTest, CovariatesBecomeColumnsAndAxes)
{
  this->Open();
  this->Button("Add &covariates...")->click();
  const int last = this->Table()->columnCount() - 1;
  EXPECT_EQ(this->Table()->horizontalHeaderItem(last)->text(), "group");
  EXPECT_EQ(this->Table()->item(1, last)->text(), "b");
  auto* across = this->Cohort->findChildren<QComboBox*>().front();
  across->setCurrentText("age");
  const auto young = this->Scatter()->PlaceOf(5);
  const auto old = this->Scatter()->PlaceOf(0);
  ASSERT_TRUE(young && old);
  EXPECT_LT(young->x(), old->x());
}

TEST_F(CohortWindowTest, SaysWhatIsNoCohort)
{
  this->Chosen = QString::fromStdString(this->Phantom.Folder.Path().string());
  this->Button("Open &folder...")->click();
  WaitUntil([this] { return this->State().contains("has no cohort.csv"); });
  EXPECT_EQ(this->Table()->rowCount(), 0);
}

TEST_F(CohortWindowTest, FitsMasksAndKeepsTheModelsWhereAsked)
{
  const std::filesystem::path masks = this->Phantom.Folder / "masks";
  const std::filesystem::path kept = this->Phantom.Folder / "kept";
  std::filesystem::create_directory(masks);
  std::filesystem::create_directory(kept);
  std::filesystem::copy_file(this->MaskFile(), masks / "a.nii.gz");
  std::filesystem::copy_file(this->MaskFile(), masks / "b.nii.gz");
  this->Chosen = QString::fromStdString(masks.string());
  EXPECT_FALSE(this->Button("&Keep models...")->isVisible());
  this->Button("Fit &masks...")->click();
  WaitUntil([this] { return this->State().startsWith("2 cases"); });
  this->Chosen = QString::fromStdString(kept.string());
  ASSERT_TRUE(this->Button("&Keep models...")->isVisible());
  this->Button("&Keep models...")->click();
  EXPECT_EQ(CohortTable::Read(kept / "cohort.csv").Rows().size(), 2U);
  this->Button("Open &folder...")->click();
  WaitUntil([this] { return this->State().startsWith("2 cases"); });
}

TEST_F(CohortWindowTest, FitCanBeCancelled)
{
  const std::filesystem::path masks = this->Phantom.Folder / "masks";
  std::filesystem::create_directory(masks);
  for (int n = 0; n < 50; ++n)
  {
    std::filesystem::copy_file(this->MaskFile(), masks / (std::to_string(n) + ".nii.gz"));
  }
  this->Chosen = QString::fromStdString(masks.string());
  this->Button("Fit &masks...")->click();
  WaitUntil([this] { return this->State().contains(" of 50"); });
  this->Cohort->findChild<QPushButton*>("cohort-cancel")->click();
  WaitUntil([this] { return this->State() == "Cancelled."; });
  EXPECT_TRUE(this->Button("Fit &masks...")->isEnabled());
}

TEST_F(CohortWindowTest, MayBeClosedWhileItReads)
{
  this->Button("Open &folder...")->click();
  this->Cohort->close();
  QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_EQ(this->Window->findChild<CohortWindow*>(), nullptr);
}
} // namespace
} // namespace palpate::cohort_window_test
