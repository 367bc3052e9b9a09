#include "InputError.h"
#include "ModelFile.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"
#include "WindowTest.h"

#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QUrl>

#include <cmath>
#include <fstream>
#include <map>

namespace palpate::main_window_test
{
namespace
{
class MainWindowTest : public test::WindowTest
{
protected:
  // Grey values that vary more than those of a label map.
  std::filesystem::path WriteGrey(const std::string& name) const
  {
    const test::LabelGrid grid;
    const auto image =
        test::MakeLabelImage<float>(grid, [](double, double, double) { return true; });
    for (vtkIdType v = 0; v < image->GetNumberOfPoints(); ++v)
    {
      static_cast<float*>(image->GetScalarPointer())[v] =
          std::sin(0.37F * static_cast<float>(v % 1009));
    }
    WriteImage(this->Phantom.Folder / name, image);
    return this->Phantom.Folder / name;
  }
};

TEST_F(MainWindowTest, DetectsFileKinds)
{
  const std::filesystem::path grey = this->WriteGrey("grey.nrrd");
  this->Study->OpenFiles({grey, this->MaskFile()});
  WaitUntil([this] { return this->Study->State().Structures.size() == 3; });
  this->Settle();
  EXPECT_EQ(this->Study->State().VolumeFile, grey);
  EXPECT_EQ(this->Study->State().SegmentationFile, this->MaskFile());
  const ViewContents& shown = this->Window->Contents();
  EXPECT_EQ(shown.Surfaces().count(1), 1U);
  EXPECT_NE(shown.Images()->GetImage(), nullptr);
}

TEST_F(MainWindowTest, VolumesOpenedTogetherAreAllThere)
{
  const std::filesystem::path first = this->WriteGrey("first.nrrd");
  const std::filesystem::path second = this->WriteGrey("second.nrrd");
  this->Study->OpenFiles({first, second});
  WaitUntil([this] { return this->Study->State().Volumes.size() == 1; });
  EXPECT_EQ(this->Study->State().VolumeFile, first);
  EXPECT_EQ(this->Study->State().Volumes.front().File, second);
}

TEST_F(MainWindowTest, DroppedFilesAreOpened)
{
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(QString::fromStdString(this->MaskFile().string()))});
  QDragEnterEvent enter({300, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(this->Window.get(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(300.0, 300.0), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(this->Window.get(), &drop);
  WaitUntil([this] { return this->Window->Contents().Images()->GetImage() != nullptr; });
  EXPECT_EQ(this->Study->State().SegmentationFile, this->MaskFile());
}

TEST_F(MainWindowTest, BadFileMessageEqualsCommandLineAndWindowContinues)
{
  const auto bad = this->Phantom.Folder / "bad.nii.gz";
  std::ofstream(bad) << "no image";
  std::string message;
  try
  {
    ReadVolume(bad);
  }
  catch (const InputError& error)
  {
    message = error.what();
  }
  ASSERT_FALSE(message.empty());
  this->Opened = QStringList{QString::fromStdString(bad.string())};
  this->Action("Open volume")->trigger();
  WaitUntil([this] { return !this->Messages().empty(); });
  EXPECT_EQ(this->Messages(), message);
  this->Button("copy")->click();
  EXPECT_EQ(QApplication::clipboard()->text().toStdString(), message);
  this->Button("close")->click();
  EXPECT_FALSE(this->Window->Messages()->isVisible());
  this->OpenPhantom();
  EXPECT_EQ(this->Window->Contents().Surfaces().count(1), 1U);
}

TEST_F(MainWindowTest, UndoNamesTheStep)
{
  this->OpenPhantom();
  auto* degree = this->Window->findChild<QDoubleSpinBox*>("Degree of all");
  degree->setValue(5);
  EXPECT_EQ(this->Study->State().Structures.at(0).Degree, 5);
  QAction* undo = this->Action("Undo");
  EXPECT_EQ(undo->text(), "&Undo: Change the degree of all structures to 5");
  undo->trigger();
  EXPECT_EQ(this->Study->State().Structures.at(0).Degree, 12);
  EXPECT_EQ(degree->value(), 12);
  this->Action("Redo")->trigger();
  EXPECT_EQ(degree->value(), 5);
}

TEST_F(MainWindowTest, RobustIsUndoStepAndCoverageIsShown)
{
  EXPECT_TRUE(this->Window->findChild<QLabel*>("coverage")->isHidden()) << "without a model";
  this->OpenPhantom();
  EXPECT_FALSE(this->Window->findChild<QLabel*>("coverage")->isHidden());
  EXPECT_EQ(this->Window->findChild<QLabel*>("coverage")->text(), "good");
  auto* robust = this->Window->findChild<QComboBox*>("Robust");
  Q_EMIT robust->activated(1);
  EXPECT_TRUE(this->Study->State().Fit.IsRobust);
  this->Action("Undo")->trigger();
  EXPECT_FALSE(this->Study->State().Fit.IsRobust);
  EXPECT_EQ(robust->currentText(), "off");
}

TEST_F(MainWindowTest, StatusLineShowsPositionValueAndLabel)
{
  this->OpenPhantom();
  SlicePane* axial = this->Window->Views()->Slice(SliceOrientation::Axial);
  const QPointF middle(0.5 * axial->Canvas()->width(), 0.5 * axial->Canvas()->height());
  const double left = -15.0 / axial->View()->GetPixelMillimeters(); // to the sphere's centre
  Move(axial->Canvas(), middle + QPointF(left, 0.0));
  const std::string text = this->Window->PointText().toStdString();
  EXPECT_NE(text.find("volume.nii.gz 700"), std::string::npos) << text;
  EXPECT_NE(text.find("label 1"), std::string::npos) << text;
  EXPECT_EQ(text.rfind("R 1", 0), 0U) << text; // 15 mm, within a pixel
}

TEST_F(MainWindowTest, SlicesFollowModelsWhereThereIsNoVolume)
{
  const auto open = [this](const char* name, const Vector3& center, std::size_t count)
  {
    const std::filesystem::path file = this->Phantom.Folder / name;
    WriteModel(file, {RadialModel(0, {20.0 * std::sqrt(4.0 * M_PI)}, center), {}});
    this->Study->OpenFiles({file});
    WaitUntil([&] { return this->Window->Contents().Surfaces().size() == count; });
    DrawAll(*this->Window->Views());
  };
  const auto crosshair = [this]
  { return Vector3(this->Window->Contents().Crosshair()->GetPositionWorld()); };
  constexpr double DrawnTriangles = 0.5; // mm, by which the drawing may be off the middle
  const Vector3 first(500.0, -400.0, 900.0);
  open("first.json", first, 1);
  EXPECT_LT((crosshair() - first).norm(), DrawnTriangles);
  const Vector3 second(560.0, -400.0, 900.0);
  open("second.json", second, 2);
  EXPECT_LT((crosshair() - 0.5 * (first + second)).norm(), DrawnTriangles);
  // The user's place stays.
  const Vector3 chosen(505.0, -401.0, 903.0);
  this->Window->Contents().Crosshair()->SetPositionWorld(chosen.data());
  open("third.json", second, 3);
  EXPECT_EQ(crosshair(), chosen);
  this->Leaving = FileQuestions::Answer::Discard;
  this->Action("New study")->trigger();
  WaitUntil([this] { return this->Window->Contents().Surfaces().empty(); });
  open("first.json", first, 1);
  EXPECT_LT((crosshair() - first).norm(), DrawnTriangles);
}

TEST_F(MainWindowTest, SavedStudyReopensUnchanged)
{
  this->OpenPhantom();
  SlicePane* axial = this->Window->Views()->Slice(SliceOrientation::Axial);
  Click(axial->Canvas(), {90.0, 80.0});
  this->Action("3-D with slices")->trigger();
  this->SavedTo = QString::fromStdString((this->Phantom.Folder / "case").string());
  this->Action("Save as")->trigger();
  const auto file = this->Phantom.Folder / "case.palpate.json";
  ASSERT_TRUE(std::filesystem::exists(file)) << this->Messages();
  EXPECT_FALSE(this->Window->isWindowModified());
  const StudyState saved = this->Study->State();
  EXPECT_EQ(saved.View.Layout, "space");
  this->Action("New study")->trigger();
  StudyState first;
  first.Fit = CoarseFit();
  EXPECT_EQ(this->Study->State(), first);
  this->Opened = QStringList{QString::fromStdString(file.string())};
  this->Action("Open study")->trigger();
  this->Settle();
  DrawAll(*this->Window->Views());
  EXPECT_EQ(this->Study->State(), saved);
  EXPECT_EQ(this->Window->Views()->Layout(), ViewLayout::Space);
}

TEST_F(MainWindowTest, StudyAmongFilesAsksBeforeReplacingChanges)
{
  this->OpenPhantom();
  const auto file = this->Phantom.Folder / "case.palpate.json";
  ASSERT_TRUE(this->Study->Save(file));
  this->Window->findChild<QDoubleSpinBox*>("Degree of all")->setValue(5);
  const StudyState changed = this->Study->State();
  this->Leaving = FileQuestions::Answer::Cancel;
  this->Study->OpenFiles({file});
  WaitUntil([this] { return !this->Study->IsBusy(); });
  EXPECT_EQ(this->Study->State(), changed);
  this->Leaving = FileQuestions::Answer::Discard;
  this->Study->OpenFiles({file});
  WaitUntil([this] { return this->Study->State().Structures.at(0).Degree == 12; });
}

TEST_F(MainWindowTest, AsksForMissingFile)
{
  this->OpenPhantom();
  const auto file = this->Phantom.Folder / "case.palpate.json";
  this->Study->Save(file);
  const auto moved = this->Phantom.Folder / "moved.nii.gz";
  std::filesystem::rename(this->MaskFile(), moved);
  this->Found = QString::fromStdString(moved.string());
  this->Study->OpenSession(file);
  WaitUntil([this] { return this->Study->State().SegmentationFile.filename() == "moved.nii.gz"; });
  ASSERT_EQ(this->AskedFor.size(), 1U);
  EXPECT_EQ(this->AskedFor.front().Role, "segmentation");
}

TEST_F(MainWindowTest, ListsRecentFiles)
{
  // One after the other: files that are opened together are read at the same time.
  this->Study->OpenVolume(this->VolumeFile());
  WaitUntil([this] { return !this->Study->State().VolumeFile.empty(); });
  this->Study->OpenSegmentation(this->MaskFile());
  WaitUntil([this] { return !this->Study->State().Structures.empty(); });
  auto* menu = this->Action("Recent")->menu();
  Q_EMIT menu->aboutToShow();
  ASSERT_EQ(menu->actions().size(), 2);
  EXPECT_TRUE(menu->actions().front()->text().startsWith("mask.nii.gz"));
}

TEST_F(MainWindowTest, ShortcutsAreUnique)
{
  std::map<QKeySequence, QString> keys;
  for (const QAction* action : this->Window->findChildren<QAction*>())
  {
    if (!action->shortcut().isEmpty())
    {
      EXPECT_EQ(keys.count(action->shortcut()), 0U)
          << action->shortcut().toString().toStdString() << " is " << action->text().toStdString()
          << " and " << keys[action->shortcut()].toStdString();
      keys[action->shortcut()] = action->text();
    }
  }
  EXPECT_GT(keys.size(), 15U);
}

TEST_F(MainWindowTest, ScreenshotEqualsWindow)
{
  this->OpenPhantom();
  const auto file = this->Phantom.Folder / "window.png";
  EXPECT_TRUE(this->Window->SaveScreenshot(QString::fromStdString(file.string())));
  EXPECT_EQ(QImage(QString::fromStdString(file.string())).size(), this->Window->size());
  EXPECT_FALSE(this->Window->SaveScreenshot("/no/such/folder/window.png"));
  EXPECT_NE(this->Messages().find("/no/such/folder/window.png"), std::string::npos);
}

TEST_F(MainWindowTest, ClosesUnaskedIfFilesWereOnlyOpened)
{
  this->OpenPhantom();
  this->Leaving = FileQuestions::Answer::Cancel;
  EXPECT_FALSE(this->Window->isWindowModified());
  EXPECT_TRUE(this->Window->close());
}

TEST_F(MainWindowTest, MessageGoesWithItsCause)
{
  this->OpenPhantom();
  StudyState broken = this->Study->State();
  broken.Tool.Kind = TouchToolSettings::Shape::Surface;
  broken.Tool.File = this->Phantom.Folder / "none.stl";
  const std::string before = this->Messages();
  this->Study->Change("Take a missing tool", broken);
  WaitUntil([this] { return this->Messages().find("none.stl") != std::string::npos; });
  this->Study->Undo();
  WaitUntil([this] { return this->Messages().find("none.stl") == std::string::npos; });
  EXPECT_EQ(this->Messages(), before) << "others stay";
  this->Study->Redo();
  WaitUntil([this] { return this->Messages().find("none.stl") != std::string::npos; });
}

// More often than twice: each try meets another turn of the timer that looks for problems.
TEST_F(MainWindowTest, TouchThatFailsTellsItsMessageEachTime)
{
  for (int n = 0; n < 4; ++n)
  {
    this->Study->StartTouch();
    WaitUntil([this] { return this->Messages().find("nothing to touch") != std::string::npos; });
    this->Button("close")->click();
  }
}

TEST_F(MainWindowTest, MessagesOfAStudyGoWithIt)
{
  this->OpenPhantom();
  EXPECT_FALSE(this->Messages().empty()) << "a structure of one voxel";
  this->Study->New();
  WaitUntil([this] { return this->Messages().empty(); });
  EXPECT_FALSE(this->Window->Messages()->isVisible());
}

TEST_F(MainWindowTest, CancelKeepsWindowOpen)
{
  this->OpenPhantom();
  this->Window->findChild<QDoubleSpinBox*>("Degree of all")->setValue(5);
  this->Leaving = FileQuestions::Answer::Cancel;
  EXPECT_FALSE(this->Window->close());
  EXPECT_TRUE(this->Window->isVisible());
  this->Leaving = FileQuestions::Answer::Discard;
  EXPECT_TRUE(this->Window->close());
}

TEST_F(MainWindowTest, ClosesDuringWork)
{
  this->Study->OpenSegmentation(this->MaskFile());
  WaitUntil([this] { return !this->Study->State().Structures.empty(); });
  EXPECT_TRUE(this->Window->close());
  EXPECT_FALSE(this->Window->isVisible());
}
} // namespace
} // namespace palpate::main_window_test
