#include "ImageWriter.h"
#include "LabelImages.h"
#include "SlicePainter.h"
#include "ThresholdDialog.h"
#include "TransformFile.h"
#include "WindowTest.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QSlider>

#include <cmath>
#include <fstream>
#include <random>

namespace palpate::volume_panel_test
{
namespace
{
class VolumePanelTest : public test::WindowTest
{
protected:
  QDoubleSpinBox* Number(const char* name) const
  {
    return this->Window->findChild<QDoubleSpinBox*>(name);
  }
  void Choose(const char* preset)
  {
    auto* box = this->Window->findChild<QComboBox*>("window-preset");
    const int index = box->findText(preset);
    ASSERT_GE(index, 0);
    Q_EMIT box->activated(index);
  }
  vtkImageDisplay* Images() const { return this->Window->Contents().Images(); }
};

TEST_F(VolumePanelTest, NumbersAreThoseOfTheSlices)
{
  this->OpenPhantom();
  EXPECT_NEAR(this->Number("window")->value(), this->Images()->GetWindow(), 0.5);
  this->Images()->SetWindowLevel(300.0, 120.0);
  EXPECT_EQ(this->Number("window")->value(), 300.0);
  EXPECT_EQ(this->Number("level")->value(), 120.0);
  this->Number("window")->setValue(250.0);
  this->Number("level")->setValue(-30.0);
  EXPECT_EQ(this->Images()->GetWindow(), 250.0);
  EXPECT_EQ(this->Images()->GetLevel(), -30.0);
  EXPECT_EQ(this->Study->State().View.Window, 250.0) << "part of the study";
}

TEST_F(VolumePanelTest, PresetsSetWindowAndLevel)
{
  this->OpenPhantom();
  const double automatic = this->Images()->GetWindow();
  this->Choose("CT: bone");
  EXPECT_EQ(this->Images()->GetWindow(), 1800.0);
  EXPECT_EQ(this->Images()->GetLevel(), 400.0);
  this->Choose("Full range");
  const double* range = this->Images()->GetImage()->GetScalarRange();
  EXPECT_EQ(this->Images()->GetWindow(), range[1] - range[0]);
  this->Choose("Automatic");
  EXPECT_EQ(this->Images()->GetWindow(), automatic);
}

TEST_F(VolumePanelTest, FilesAreNamed)
{
  EXPECT_FALSE(this->Number("window")->isEnabled());
  this->OpenPhantom();
  EXPECT_TRUE(this->Number("window")->isEnabled());
  const QString volume = this->Window->findChild<QLabel*>("volume-name")->text();
  EXPECT_TRUE(volume.startsWith("volume.nii.gz  ")) << volume.toStdString();
  EXPECT_TRUE(volume.endsWith(" mm")) << volume.toStdString();
  EXPECT_TRUE(this->Window->findChild<QLabel*>("labels-name")->text().contains("3 structures"));
}

// A second volume over the phantom's: oblique and anisotropic.
class SeveralVolumesTest : public VolumePanelTest
{
protected:
  void SetUp() override
  {
    VolumePanelTest::SetUp();
    test::LabelGrid grid;
    grid.Size = {{30, 24, 10}};
    grid.Spacing = {{1.5, 1.2, 4.0}};
    std::mt19937_64 random(5);
    grid.Direction = test::RandomRotation(random);
    grid.CenterOnOrigin();
    WriteImage(this->Second, test::MakeLabelImage<short>(
                                 grid, [](double x, double, double) { return x < 0.0; }, 100));
    this->OpenPhantom();
    this->Study->AddVolume(this->Second);
    WaitUntil([this] { return this->Images()->GetNumberOfOverlays() == 1; });
  }
  QListWidget* List() const { return this->Window->findChild<QListWidget*>("volumes"); }
  QComboBox* Box(const char* name) const { return this->Window->findChild<QComboBox*>(name); }
  const StudyVolume& Further() const { return this->Study->State().Volumes.at(0); }
  // Where the first voxel of the second volume is shown, mm.
  Vector3 Place() const
  {
    const auto& image = this->Images()->GetContent().Over.at(0).Image;
    return Vector3(image->GetOrigin());
  }
  void ChooseTransform(const std::filesystem::path& file)
  {
    this->Opened = QStringList{QString::fromStdString(file.string())};
    this->Button("volume-transform")->click();
  }

  std::filesystem::path Second = this->Phantom.Folder / "second.nii.gz";
};

TEST_F(SeveralVolumesTest, ListIsShownForSeveralOnly)
{
  EXPECT_TRUE(this->List()->isVisible());
  EXPECT_EQ(this->List()->item(0)->text(), "volume.nii.gz");
  EXPECT_EQ(this->List()->item(1)->text(), "second.nii.gz");
  EXPECT_FALSE(this->Box("volume-colors")->isVisible()) << "the first is selected";
  this->List()->setCurrentRow(1);
  EXPECT_TRUE(this->Box("volume-colors")->isVisible());
  this->Button("remove-volume")->click();
  EXPECT_FALSE(this->List()->isVisible());
  EXPECT_EQ(this->Images()->GetNumberOfOverlays(), 0);
  this->Study->Undo();
  WaitUntil([this] { return this->Images()->GetNumberOfOverlays() == 1; });
}

TEST_F(SeveralVolumesTest, NumbersAreThoseOfTheSelectedVolume)
{
  const double ofFirst = this->Images()->GetWindow();
  this->List()->setCurrentRow(1);
  EXPECT_NEAR(this->Number("window")->value(), 100.0, 1.0) << "of second.nii.gz";
  this->Number("window")->setValue(80.0);
  this->Number("level")->setValue(30.0);
  EXPECT_EQ(this->Images()->GetOverlayWindow(0), 80.0);
  EXPECT_EQ(this->Images()->GetOverlayLevel(0), 30.0);
  EXPECT_EQ(this->Images()->GetWindow(), ofFirst);
  EXPECT_EQ(this->Further().Window, 80.0) << "part of the study";
  this->Choose("Automatic");
  EXPECT_FALSE(this->Further().Window);
  EXPECT_NEAR(this->Images()->GetOverlayWindow(0), 100.0, 1.0);
  this->List()->setCurrentRow(0);
  EXPECT_EQ(this->Number("window")->value(), ofFirst);
}

TEST_F(SeveralVolumesTest, ColoursOpacityAndMixingReachTheSlices)
{
  this->List()->setCurrentRow(1);
  const auto& over = this->Images()->GetContent().Over;
  this->Box("volume-colors")->setCurrentIndex(2);
  Q_EMIT this->Box("volume-colors")->activated(2);
  EXPECT_EQ(over.at(0).Colors, VolumeColors::BlueToYellow);
  this->Window->findChild<QSlider*>("volume-opacity")->setValue(80);
  EXPECT_NEAR(over.at(0).Opacity, 0.8, 1e-6);
  this->Window->findChild<QCheckBox*>("volume-hides-below")->click();
  EXPECT_TRUE(over.at(0).HidesBelow);
  this->Box("mixing")->setCurrentIndex(2);
  Q_EMIT this->Box("mixing")->activated(2);
  EXPECT_EQ(this->Images()->GetMixing(), vtkImageDisplay::CURTAIN);
  this->Window->findChild<QSlider*>("curtain")->setValue(250);
  EXPECT_EQ(this->Images()->GetCurtain(), 0.25);
  EXPECT_EQ(this->Study->State().View.Mixing, StudyMixing::Curtain) << "part of the study";
}

TEST_F(SeveralVolumesTest, HiddenVolumeIsNotShownNorKept)
{
  this->List()->item(1)->setCheckState(Qt::Unchecked);
  EXPECT_FALSE(this->Further().IsVisible);
  EXPECT_EQ(this->Images()->GetNumberOfOverlays(), 0);
  this->List()->item(1)->setCheckState(Qt::Checked);
  WaitUntil([this] { return this->Images()->GetNumberOfOverlays() == 1; });
}

TEST_F(SeveralVolumesTest, ProbeNamesTheValueOfEach)
{
  const std::string text = this->Window->Contents().TextAt(Vector3(-3.0, 0.0, 0.0));
  EXPECT_NE(text.find("volume.nii.gz 700"), std::string::npos) << text;
  EXPECT_NE(text.find("second.nii.gz 100"), std::string::npos) << text;
}

TEST_F(SeveralVolumesTest, TransformMovesTheSelectedVolumeUntilItIsCleared)
{
  const Vector3 before = this->Place();
  const Eigen::Affine3d map = Eigen::Translation3d(7.0, -3.0, 2.0) *
                              Eigen::Affine3d(Eigen::AngleAxisd(0.4, Vector3::UnitY()));
  WriteTransform(this->Phantom.Folder / "a.lta", map);
  this->List()->setCurrentRow(1);
  QPushButton* clear = this->Button("volume-transform-clear");
  EXPECT_FALSE(clear->isEnabled());
  const auto isAt = [this](const Vector3& place)
  { return this->Images()->GetNumberOfOverlays() == 1 && (this->Place() - place).norm() < 1e-6; };
  this->ChooseTransform(this->Phantom.Folder / "a.lta");
  WaitUntil([&] { return isAt(map * before); });
  EXPECT_EQ(this->Button("volume-transform")->text(), "a.lta");
  clear->click();
  WaitUntil([&] { return isAt(before); });
  EXPECT_FALSE(clear->isEnabled());
  this->Study->Undo();
  WaitUntil([&] { return isAt(map * before); });
}

TEST_F(SeveralVolumesTest, BadTransformIsRefusedWithAMessage)
{
  this->List()->setCurrentRow(1);
  std::ofstream(this->Phantom.Folder / "bad.xfm") << "MNI Transform File\nLinear_Transform = 1 0";
  this->ChooseTransform(this->Phantom.Folder / "bad.xfm");
  EXPECT_TRUE(this->Further().Transform.empty());
  EXPECT_NE(this->Messages().find("bad.xfm"), std::string::npos) << this->Messages();
}

TEST_F(SeveralVolumesTest, StructureOfTheSelectedVolumeGoesWithIt)
{
  WriteTransform(this->Phantom.Folder / "a.tfm",
                 Eigen::Affine3d(Eigen::Translation3d(7.0, -3.0, 2.0)));
  this->List()->setCurrentRow(1);
  this->ChooseTransform(this->Phantom.Folder / "a.tfm");
  WaitUntil([this]
            { return this->Images()->GetNumberOfOverlays() == 1 && !this->Study->IsBusy(); });
  this->Button("volume-structure")->click();
  auto* dialog = this->Window->findChild<ThresholdDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(dialog->windowTitle().contains("second.nii.gz"));
  dialog->accept();
  const SceneStructure& made = this->Study->State().Structures.back();
  EXPECT_EQ(made.File, this->Second);
  EXPECT_EQ(made.Move, (SceneMove{this->Phantom.Folder / "a.tfm", this->VolumeFile()}));
  this->Button("volume-transform-clear")->click();
  EXPECT_FALSE(this->Study->State().Structures.back().Move.IsSet());
}

TEST_F(SeveralVolumesTest, KeyShowsTheNextVolume)
{
  this->Action("Next volume over the first")->trigger();
  EXPECT_FALSE(this->Further().IsVisible);
  this->Action("Next volume over the first")->trigger();
  EXPECT_TRUE(this->Further().IsVisible);
}

TEST_F(SeveralVolumesTest, SessionReopensEqual)
{
  this->List()->setCurrentRow(1);
  this->Number("window")->setValue(80.0);
  const StudyState saved = this->Study->State();
  ASSERT_TRUE(this->Study->Save(this->Phantom.Folder / "two.palpate.json"));
  this->Study->New();
  EXPECT_FALSE(this->List()->isVisible());
  this->Study->OpenSession(this->Phantom.Folder / "two.palpate.json");
  WaitUntil([this] { return this->Images()->GetNumberOfOverlays() == 1; });
  EXPECT_EQ(this->Study->State().Volumes, saved.Volumes);
  EXPECT_EQ(this->Images()->GetOverlayWindow(0), 80.0);
}
} // namespace
} // namespace palpate::volume_panel_test
