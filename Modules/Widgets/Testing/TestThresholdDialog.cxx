#include "ThresholdDialog.h"

#include "ImageWriter.h"
#include "SlicePainter.h"
#include "WindowTest.h"

#include <QDialogButtonBox>
#include <QPointer>

namespace palpate::threshold_dialog_test
{
namespace
{
class ThresholdDialogTest : public test::WindowTest
{
protected:
  // Chosen in the menu.
  void OpenDialog()
  {
    this->Action("Add structure from image values")->trigger();
    this->Dialog = this->Window->findChild<ThresholdDialog*>();
    ASSERT_NE(this->Dialog, nullptr) << this->Messages();
    EXPECT_TRUE(this->Dialog->isVisible());
  }
  void Press(QDialogButtonBox::StandardButton button)
  {
    this->Dialog->findChild<QDialogButtonBox*>()->button(button)->click();
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_EQ(this->Dialog, nullptr) << "closed dialogs are gone";
  }
  template <typename T>
  T* Part(const char* name) const
  {
    return this->Dialog->findChild<T*>(name);
  }
  double Lower() const { return this->Part<QDoubleSpinBox>("threshold-lower")->value(); }
  const std::optional<ValueBand>& Band() const
  {
    return this->Window->Contents().Images()->GetContent().Band;
  }
  std::string Undo() const { return this->Study->Current().History().UndoText(); }
  const SceneStructure& Last() const { return this->Study->State().Structures.back(); }
  // A volume with air of -1000 HU, soft tissue and bone.
  std::filesystem::path Ct() const
  {
    test::LabelGrid grid;
    const auto image = test::MakeLabelImage<short>(
        grid, [](double x, double y, double z) { return std::hypot(x, y, z) < 12.0; }, 1);
    for (vtkIdType v = 0; v < image->GetNumberOfPoints(); ++v)
    {
      short& voxel = static_cast<short*>(image->GetScalarPointer())[v];
      voxel = static_cast<short>(voxel == 0 ? -1000 : v % 3 == 0 ? 900 : 40);
    }
    WriteImage(this->Phantom.Folder / "ct.nii.gz", image);
    return this->Phantom.Folder / "ct.nii.gz";
  }

  QPointer<ThresholdDialog> Dialog;
};

TEST_F(ThresholdDialogTest, AddingIsOneUndoStep)
{
  this->OpenPhantom();
  const StudyState before = this->Study->State();
  this->OpenDialog();
  EXPECT_NEAR(this->Lower(), 350.0, 340.0) << "between 0 and 700";
  this->Part<QDoubleSpinBox>("threshold-lower")->setValue(400.0);
  this->Part<QDoubleSpinBox>("threshold-lower")->setValue(500.0);
  this->Part<QLineEdit>("threshold-name")->setText("rind");
  EXPECT_EQ(this->Study->State().Structures, before.Structures) << "not before OK";
  this->Press(QDialogButtonBox::Ok);
  ASSERT_EQ(this->Study->State().Structures.size(), 4U) << this->Messages();
  EXPECT_EQ(this->Last().Iso, 500.0);
  EXPECT_EQ(this->Last().Name, "rind");
  EXPECT_FALSE(this->Last().IsLimited());
  EXPECT_EQ(this->Undo(), "Add rind");
  EXPECT_FALSE(this->Band()) << "the picture ends";
  this->Settle();
  EXPECT_EQ(this->Study->Current().Pipeline().StateOf(SceneStep::Touch, this->Last().Id).Is,
            StudyStepState::Kind::UpToDate);
  this->Study->Undo();
  EXPECT_EQ(this->Study->State().Structures, before.Structures);
}

TEST_F(ThresholdDialogTest, CancelLeavesNothing)
{
  this->OpenPhantom();
  const StudyState before = this->Study->State();
  const std::string undo = this->Undo();
  this->OpenDialog();
  this->Part<QSlider>("threshold-lower-slider")->setValue(900);
  EXPECT_TRUE(this->Band());
  this->Press(QDialogButtonBox::Cancel);
  EXPECT_FALSE(this->Band());
  EXPECT_EQ(this->Study->State().Structures, before.Structures);
  EXPECT_EQ(this->Undo(), undo);
}

TEST_F(ThresholdDialogTest, SlicesShowTheValueWhileItMoves)
{
  this->OpenPhantom();
  this->OpenDialog();
  vtkSliceView* axial = this->Window->Views()->Slice(SliceOrientation::Axial)->View();
  for (const int place : {300, 600})
  {
    const int painted = axial->GetPaintCount();
    this->Part<QSlider>("threshold-lower-slider")->setValue(place);
    ASSERT_TRUE(this->Band());
    EXPECT_EQ(this->Band()->Low, this->Lower());
    EXPECT_NEAR(this->Lower(), 0.7 * place, 1.0);
    WaitUntil([&] { return axial->GetPaintCount() > painted; });
  }
}

TEST_F(ThresholdDialogTest, ClickOnTheHistogramChoosesItsValue)
{
  this->OpenPhantom();
  this->OpenDialog();
  auto* chart = this->Part<HistogramView>("histogram");
  QApplication::processEvents();
  Click(chart, {0.25 * chart->width(), 10.0});
  EXPECT_NEAR(this->Lower(), 175.0, 5.0);
  EXPECT_EQ(this->Band()->Low, this->Lower());
}

TEST_F(ThresholdDialogTest, RangeInsideALabelIsShownAndAdded)
{
  this->OpenPhantom();
  this->OpenDialog();
  this->Part<QDoubleSpinBox>("threshold-lower")->setValue(350.0);
  this->Part<QCheckBox>("threshold-has-upper")->click();
  this->Part<QDoubleSpinBox>("threshold-upper")->setValue(900.0);
  auto* masks = this->Part<QComboBox>("threshold-mask");
  EXPECT_EQ(masks->count(), 4) << "the whole volume and three labels";
  masks->setCurrentIndex(masks->findText("label 1"));
  ASSERT_TRUE(this->Band());
  EXPECT_EQ(this->Band()->High, 900.0);
  ASSERT_NE(this->Band()->Mask, nullptr);
  EXPECT_EQ(this->Band()->MaskValue, 1);
  this->Press(QDialogButtonBox::Ok);
  EXPECT_EQ(this->Last().IsoUpper, 900.0);
  EXPECT_EQ(this->Last().WithinFile, this->MaskFile());
  EXPECT_EQ(this->Last().WithinLabel, "1");
}

TEST_F(ThresholdDialogTest, OnlyACtHasPresetsInHounsfieldUnits)
{
  this->OpenPhantom();
  this->OpenDialog();
  EXPECT_EQ(this->Part<QPushButton>("threshold-bone"), nullptr);
  this->Press(QDialogButtonBox::Cancel);
  this->Study->OpenVolume(this->Ct());
  this->Settle();
  this->OpenDialog();
  ASSERT_NE(this->Part<QPushButton>("threshold-bone"), nullptr);
  this->Part<QPushButton>("threshold-bone")->click();
  EXPECT_EQ(this->Lower(), 300.0);
  this->Part<QPushButton>("threshold-skin")->click();
  EXPECT_EQ(this->Lower(), -300.0);
}

TEST_F(ThresholdDialogTest, EmptyRangeCannotBeAdded)
{
  this->OpenPhantom();
  this->OpenDialog();
  const auto* add = this->Dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  this->Part<QDoubleSpinBox>("threshold-lower")->setValue(500.0);
  EXPECT_TRUE(add->isEnabled());
  this->Part<QCheckBox>("threshold-has-upper")->click();
  this->Part<QDoubleSpinBox>("threshold-upper")->setValue(400.0);
  EXPECT_FALSE(add->isEnabled());
  this->Part<QDoubleSpinBox>("threshold-lower")->setValue(300.0);
  EXPECT_TRUE(add->isEnabled());
}

TEST_F(ThresholdDialogTest, ClosesWithTheVolume)
{
  this->OpenPhantom();
  this->OpenDialog();
  this->Action("New study")->trigger();
  QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_EQ(this->Dialog, nullptr);
  EXPECT_FALSE(this->Band());
}

TEST_F(ThresholdDialogTest, IsOpenOnce)
{
  this->OpenPhantom();
  this->OpenDialog();
  this->Action("Add structure from image values")->trigger();
  EXPECT_EQ(this->Window->findChildren<ThresholdDialog*>().size(), 1);
}

TEST_F(ThresholdDialogTest, NeedsAVolume)
{
  this->Action("Add structure from image values")->trigger();
  EXPECT_EQ(this->Window->findChild<ThresholdDialog*>(), nullptr);
  EXPECT_NE(this->Messages().find("no volume"), std::string::npos) << this->Messages();
}
} // namespace
} // namespace palpate::threshold_dialog_test
