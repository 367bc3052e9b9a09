#include "DrawingPanel.h"
#include "ModelFile.h"
#include "SegmentationFile.h"
#include "ShapePriorFile.h"
#include "WholeFile.h"
#include "WindowLook.h"
#include "WindowTest.h"
#include "ZonePrior.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include "vtkCamera.h"

#include <QComboBox>
#include <QRegularExpression>
#include <QTest>

#include <array>
#include <cmath>
#include <cstdlib>

namespace palpate::drawing_panel_test
{
namespace
{
// The last is 1600 x 1000 at scale 2.
const std::array<QSize, 3> Sizes{QSize(1280, 800), QSize(1024, 700), QSize(800, 500)};

// Label 1 of the phantom, a sphere of 9 mm around (-15, 0, 0), is drawn.
class DrawingPanelTest : public test::WindowTest
{
protected:
  void Open(const QSize& size = QSize(1280, 800))
  {
    this->Window->resize(size);
    this->OpenPhantom();
    Activate(*this->Window);
    this->GoTo(this->Center);
    QTest::keyClick(this->Window->Views()->Slice(SliceOrientation::Axial)->Canvas(), Qt::Key_T);
    ASSERT_TRUE(this->Action("Draw by touch")->isChecked());
    DrawAll(*this->Window->Views());
  }
  void GoTo(const Vector3& world)
  {
    this->Window->Contents().Crosshair()->SetPositionWorld(world.data());
    DrawAll(*this->Window->Views());
  }
  SlicePane* Slice(SliceOrientation orientation) const
  {
    return this->Window->Views()->Slice(orientation);
  }
  // On the sphere in a slice through its centre: in axial slices the angle is from the right.
  Vector3 PlaceAt(SliceOrientation orientation, double angle) const
  {
    const double c = this->Radius * std::cos(angle);
    const double s = this->Radius * std::sin(angle);
    return this->Center + (orientation == SliceOrientation::Axial     ? Vector3(c, s, 0.0)
                           : orientation == SliceOrientation::Coronal ? Vector3(c, 0.0, s)
                                                                      : Vector3(0.0, c, s));
  }
  void ClickAt(SliceOrientation orientation, const Vector3& world,
               Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    QWidget* canvas = this->Slice(orientation)->Canvas();
    const QPointF place = PlaceIn(*this->Slice(orientation), world);
    SendMouse(canvas, QEvent::MouseButtonPress, place, Qt::LeftButton, Qt::LeftButton, modifiers);
    SendMouse(canvas, QEvent::MouseButtonRelease, place, Qt::LeftButton, Qt::NoButton, modifiers);
  }
  // Of a part of the circle.
  void DrawArc(SliceOrientation orientation, double from, double to)
  {
    QWidget* canvas = this->Slice(orientation)->Canvas();
    const auto at = [&](double angle)
    { return PlaceIn(*this->Slice(orientation), this->PlaceAt(orientation, angle)); };
    SendMouse(canvas, QEvent::MouseButtonPress, at(from), Qt::LeftButton, Qt::LeftButton);
    for (int n = 1; n <= 30; ++n)
    {
      SendMouse(canvas, QEvent::MouseMove, at(from + (to - from) * n / 30.0), Qt::NoButton,
                Qt::LeftButton);
    }
    SendMouse(canvas, QEvent::MouseButtonRelease, at(to), Qt::LeftButton, Qt::NoButton);
  }
  // Twelve touches of the sphere in three slices.
  void DrawSphere()
  {
    for (const SliceOrientation orientation : AllSliceOrientations)
    {
      for (int n = 0; n < 4; ++n)
      {
        this->ClickAt(orientation, this->PlaceAt(orientation, 0.4 + 1.5707963 * n));
      }
    }
  }
  const StudyDrawing& Drawn() const { return this->Study->State().Drawing; }
  const DrawnOrgan& Organ() const { return this->Study->Current().Drawn().Organ(); }
  QString Line() const { return this->Window->findChild<QLabel*>("draw-line")->text(); }
  // The longest distance from the sphere of what is shown.
  double Error() const
  {
    double largest = 0.0;
    vtkPolyData* surface = this->Window->Contents().Drawing().Display()->GetSurface();
    for (vtkIdType n = 0; n < surface->GetNumberOfPoints(); ++n)
    {
      const double distance = (Vector3(surface->GetPoint(n)) - this->Center).norm();
      largest = std::max(largest, std::abs(distance - this->Radius));
    }
    return largest;
  }
  bool IsShown() const { return this->Window->Contents().Drawing().Display()->GetVisibility(); }
  // A prior of bodies behind a known ball, which is called as label 1.
  void ChooseZonePrior()
  {
    const std::filesystem::path file = this->Phantom.Folder / "zone.json";
    WriteShapePrior(test::ZonePrior("1"), file);
    this->Opened = QStringList{QString::fromStdString(file.string())};
    QTest::mouseClick(this->Button("draw-choose-prior"), Qt::LeftButton);
    WaitUntil([this] { return this->Organ().Surface() != nullptr; });
    DrawAll(*this->Window->Views());
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

  const Vector3 Center{-15.0, 0.0, 0.0};
  const double Radius = 9.0;
};

TEST_F(DrawingPanelTest, ClicksInThreeSlicesDrawTheOrganAtUsualSizes)
{
  for (const QSize& size : Sizes)
  {
    this->Open(size);
    ASSERT_EQ(this->Window->size(), size);
    EXPECT_FALSE(this->IsShown());
    this->DrawSphere();
    ASSERT_EQ(this->Drawn().Touches.size(), 12U);
    const double pixel = this->Slice(SliceOrientation::Axial)->View()->GetPixelMillimeters();
    for (const SurfaceTouch& touch : this->Drawn().Touches)
    {
      EXPECT_NEAR((touch.PointWorld - this->Center).norm(), this->Radius, pixel);
    }
    ASSERT_TRUE(this->IsShown());
    EXPECT_LT(this->Error(), 2.0) << "twelve touches of 1 mm";
    EXPECT_TRUE(this->Line().contains(" ml, sure to ")) << this->Line().toStdString();
    this->Show(QString("draw-%1").arg(size.width()));
    this->Study->New();
    QTest::keyClick(this->Window.get(), Qt::Key_Escape);
  }
}

TEST_F(DrawingPanelTest, IsShownFromTheThirdTouchOnAndEachIsUndone)
{
  this->Open();
  const auto touch = [this](int n)
  { this->ClickAt(SliceOrientation::Axial, this->PlaceAt(SliceOrientation::Axial, 2.1 * n)); };
  touch(0);
  touch(1);
  EXPECT_FALSE(this->IsShown());
  EXPECT_TRUE(this->Line().contains("2 so far")) << this->Line().toStdString();
  touch(2);
  EXPECT_TRUE(this->IsShown());
  EXPECT_EQ(this->Organ().Next().size(), 3U) << "until there are six";
  EXPECT_TRUE(this->Line().contains("mark 4")) << this->Line().toStdString();
  QTest::keyClick(this->Window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(this->Drawn().Touches.size(), 2U);
  EXPECT_FALSE(this->IsShown());
  QTest::keyClick(this->Window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(this->IsShown());
}

TEST_F(DrawingPanelTest, DragAlongTheEdgeIsAStrokeAndOneStep)
{
  this->Open();
  this->DrawArc(SliceOrientation::Axial, 0.0, 3.0);
  const std::size_t count = this->Drawn().Touches.size();
  EXPECT_GE(count, 11U) << "27 mm";
  EXPECT_LE(count, 14U);
  for (const SurfaceTouch& touch : this->Drawn().Touches)
  {
    EXPECT_EQ(touch.Stroke, 1);
    EXPECT_NEAR(touch.PointWorld.z(), 0.0, 1e-6) << "in the slice";
  }
  this->DrawArc(SliceOrientation::Coronal, 0.0, 2.0);
  EXPECT_EQ(this->Drawn().Touches.back().Stroke, 2);
  auto* table = this->Window->findChild<QTableWidget*>("touches");
  EXPECT_EQ(table->rowCount(), 2);
  table->selectRow(0);
  this->Button("draw-remove")->click();
  EXPECT_EQ(table->rowCount(), 1);
  EXPECT_EQ(this->Drawn().Touches.front().Stroke, 2);
  this->Study->Undo();
  this->Study->Undo();
  EXPECT_EQ(this->Drawn().Touches.size(), count);
}

TEST_F(DrawingPanelTest, WheelLeavesTheSliceAndTheNextTouchIsInTheOther)
{
  this->Open();
  QWidget* canvas = this->Slice(SliceOrientation::Axial)->Canvas();
  const QPointF place = PlaceIn(*this->Slice(SliceOrientation::Axial), this->Center);
  Move(canvas, place);
  EXPECT_EQ(this->Slice(SliceOrientation::Axial)->cursor().shape(), Qt::CrossCursor);
  test::WidgetTest::Wheel(canvas, place, 3);
  DrawAll(*this->Window->Views());
  Click(canvas, place);
  ASSERT_EQ(this->Drawn().Touches.size(), 1U);
  const double* cross = this->Window->Contents().Crosshair()->GetPositionWorld();
  EXPECT_GT(std::abs(cross[2]), 0.9);
  EXPECT_NEAR(this->Drawn().Touches[0].PointWorld.z(), cross[2], 1e-6);
}

TEST_F(DrawingPanelTest, ControlMarksAPointOutsideAndTheChoiceDoesToo)
{
  this->Open();
  this->ClickAt(SliceOrientation::Axial, this->Center + Vector3(0.0, 12.0, 0.0),
                Qt::ControlModifier);
  auto* next = this->Window->findChild<QComboBox*>("draw-next");
  next->setFocus();
  QTest::keyClick(next, Qt::Key_Down);
  EXPECT_EQ(next->currentText(), "Outside here");
  this->DrawArc(SliceOrientation::Axial, 0.0, 1.0);
  ASSERT_EQ(this->Drawn().Touches.size(), 2U) << "a point outside is no stroke";
  EXPECT_TRUE(this->Drawn().Touches[0].IsOutside);
  EXPECT_TRUE(this->Drawn().Touches[1].IsOutside);
  QTest::keyClick(next, Qt::Key_Down);
  this->ClickAt(SliceOrientation::Axial, this->Center);
  ASSERT_TRUE(this->Drawn().CenterWorld);
  EXPECT_LT((*this->Drawn().CenterWorld - this->Center).norm(), 1.0);
  EXPECT_EQ(next->currentText(), "On the surface") << "there is one middle";
}

TEST_F(DrawingPanelTest, EscapeEndsTheModeAndKeepsWhatIsDrawn)
{
  this->Open();
  this->DrawSphere();
  const StudyDrawing before = this->Drawn();
  QWidget* canvas = this->Slice(SliceOrientation::Axial)->Canvas();
  SendMouse(canvas, QEvent::MouseButtonPress, QPointF(40, 40), Qt::LeftButton, Qt::LeftButton);
  QTest::keyClick(this->Window.get(), Qt::Key_Escape);
  SendMouse(canvas, QEvent::MouseButtonRelease, QPointF(80, 80), Qt::LeftButton, Qt::NoButton);
  EXPECT_FALSE(this->Action("Draw by touch")->isChecked());
  EXPECT_FALSE(this->Button("draw-mode")->isChecked());
  this->ClickAt(SliceOrientation::Axial, this->Center);
  EXPECT_EQ(this->Drawn(), before) << "the stroke was given up, and clicks are the crosshair's";
  EXPECT_TRUE(this->IsShown());
  EXPECT_TRUE(this->Window->Contents().Landmarks()->GetLandmarks().empty());
}

TEST_F(DrawingPanelTest, ModesOfTheMouseExcludeEachOther)
{
  this->Open();
  this->Action("Add landmarks by click")->trigger();
  EXPECT_FALSE(this->Action("Draw by touch")->isChecked());
  this->ClickAt(SliceOrientation::Axial, this->Center);
  EXPECT_TRUE(this->Drawn().Touches.empty());
  EXPECT_EQ(this->Study->State().Landmarks.size(), 1U);
  this->Button("draw-mode")->click();
  EXPECT_FALSE(this->Action("Add landmarks by click")->isChecked());
}

TEST_F(DrawingPanelTest, SaysWhyItIsRefusedWhileItHolds)
{
  this->Open();
  auto* sigma = this->Window->findChild<QDoubleSpinBox*>("draw-sigma");
  sigma->setValue(0.1);
  this->DrawArc(SliceOrientation::Axial, 0.0, 6.2);
  const std::size_t count = this->Drawn().Touches.size();
  EXPECT_FALSE(this->Line().startsWith("Refused")) << this->Line().toStdString();
  EXPECT_TRUE(this->Button("draw-keep")->isEnabled());
  // Along and back again, another way: a cleft.
  for (const double shift : {-3.0, 3.0})
  {
    for (int n = 0; n < 7; ++n)
    {
      this->ClickAt(SliceOrientation::Axial, this->Center + Vector3(-8.0 + 2.5 * n, shift, 0.0));
    }
  }
  EXPECT_TRUE(this->Line().startsWith("Refused: the touched points are "))
      << this->Line().toStdString();
  EXPECT_FALSE(this->Button("draw-keep")->isEnabled());
  for (const SceneContact& contact : this->Study->Current().Contacts())
  {
    EXPECT_NE(contact.Id, StudyDrawn::StructureId) << "it is not felt";
  }
  while (this->Drawn().Touches.size() > count)
  {
    this->Study->Undo();
  }
  EXPECT_FALSE(this->Line().startsWith("Refused")) << this->Line().toStdString();
  EXPECT_TRUE(this->Button("draw-keep")->isEnabled());
}

TEST_F(DrawingPanelTest, KeptOrganIsAStructureWithAMask)
{
  this->Open();
  this->DrawSphere();
  this->Chosen = QString::fromStdString((this->Phantom.Folder / "kept" / "Left ball").string());
  const std::size_t before = this->Study->State().Structures.size();
  QTest::mouseClick(this->Button("draw-keep"), Qt::LeftButton);
  WaitUntil([&] { return this->Study->State().Structures.size() > before; });
  this->Settle();
  const SceneStructure& kept = this->Study->State().Structures.back();
  EXPECT_EQ(kept.Name, "Left ball");
  EXPECT_TRUE(this->Drawn().Touches.empty());
  EXPECT_FALSE(this->IsShown()) << "the structure is";
  EXPECT_EQ(this->Window->Contents().Surfaces().count(kept.Id), 1U);
  const Segmentation mask = ReadSegmentation(kept.File.parent_path() / "mask.nii.gz");
  const double millimeters = 4.0 / 3.0 * 3.14159265 * std::pow(this->Radius, 3);
  double count = 0.0;
  for (vtkIdType n = 0; n < mask.Layers[0]->GetNumberOfPoints(); ++n)
  {
    count += mask.Layers[0]->GetPointData()->GetScalars()->GetTuple1(n);
  }
  EXPECT_NEAR(count, millimeters, 0.15 * millimeters) << "voxels of 1 mm";
  this->Study->Undo();
  EXPECT_EQ(this->Drawn().Touches.size(), 12U);
  EXPECT_TRUE(this->IsShown());
}

TEST_F(DrawingPanelTest, SessionAndFilesKeepTouches)
{
  this->Open();
  this->DrawArc(SliceOrientation::Axial, 0.0, 3.0);
  this->ClickAt(SliceOrientation::Coronal, this->PlaceAt(SliceOrientation::Coronal, 1.0));
  this->ExpectSameStudyAfterReopening();
  EXPECT_TRUE(this->IsShown());
  const std::vector<SurfaceTouch> touches = this->Drawn().Touches;
  this->SavedTo = QString::fromStdString((this->Phantom.Folder / "touches.csv").string());
  this->Button("draw-export")->click();
  this->FinishWriting();
  this->Button("draw-clear")->click();
  EXPECT_TRUE(this->Drawn().Touches.empty());
  this->Opened = QStringList{this->SavedTo};
  this->Button("draw-import")->click();
  EXPECT_EQ(this->Drawn().Touches, touches);
}

TEST_F(DrawingPanelTest, TapInSpaceTouchesASurfaceAndADragTurnsTheCamera)
{
  this->Open();
  ViewPane* space = this->Window->Views()->Space();
  const Vector3 camera(space->Renderer()->GetActiveCamera()->GetPosition());
  const QPointF place = this->PlaceOf(this->Center);
  Click(space->Canvas(), place);
  ASSERT_EQ(this->Drawn().Touches.size(), 1U);
  EXPECT_NEAR((this->Drawn().Touches[0].PointWorld - this->Center).norm(), this->Radius, 0.7);
  SendMouse(space->Canvas(), QEvent::MouseButtonPress, place, Qt::LeftButton, Qt::LeftButton);
  SendMouse(space->Canvas(), QEvent::MouseMove, place + QPointF(60, 20), Qt::NoButton,
            Qt::LeftButton);
  SendMouse(space->Canvas(), QEvent::MouseButtonRelease, place + QPointF(60, 20), Qt::LeftButton,
            Qt::NoButton);
  EXPECT_EQ(this->Drawn().Touches.size(), 1U);
  EXPECT_GT((Vector3(space->Renderer()->GetActiveCamera()->GetPosition()) - camera).norm(), 1.0);
}

TEST_F(DrawingPanelTest, LastingContactOfTheToolIsATouchWithItsNormal)
{
  this->Open();
  this->BeginTouch();
  this->Press(this->Center, 0.3);
  WaitUntil([this] { return !this->Drawn().Touches.empty(); });
  const SurfaceTouch touch = this->Drawn().Touches[0];
  const Vector3 out = (touch.PointWorld - this->Center).normalized();
  EXPECT_NEAR((touch.PointWorld - this->Center).norm(), this->Radius, 0.7) << "a mask of 1 mm";
  ASSERT_TRUE(touch.Normal);
  EXPECT_GT(touch.Normal->dot(out), 0.97);
  EXPECT_EQ(this->Study->Reading().Newest.Safety.Fault, SafetyFault::None);
  this->Study->StopTouch();
  this->Action("Draw where touched")->trigger();
  EXPECT_NE(this->Messages().find("Touch is off"), std::string::npos) << this->Messages();
  EXPECT_EQ(this->Drawn().Touches.size(), 1U);
}

TEST_F(DrawingPanelTest, ForceStaysOffAfterEscape)
{
  this->Open();
  this->BeginTouch();
  QTest::keyClick(this->Window.get(), Qt::Key_Escape);
  this->FeelUntil(
      [this] { return this->Study->Reading().Newest.Safety.Fault == SafetyFault::SwitchedOff; });
  this->Button("draw-mode")->click();
  const std::uint64_t scene = this->Study->Reading().Newest.Scene;
  this->DrawSphere();
  this->FeelUntil([&] { return this->Study->Reading().Newest.Scene > scene; });
  EXPECT_EQ(this->Study->Reading().Newest.Safety.Fault, SafetyFault::SwitchedOff);
}

TEST_F(DrawingPanelTest, NothingIsClippedInLightAndDark)
{
  for (const WindowLook look : {WindowLook::Light, WindowLook::Dark})
  {
    ChooseLook(look);
    for (const QSize& size : Sizes)
    {
      this->Open(size);
      this->DrawSphere();
      EXPECT_EQ(this->Window->size(), size) << "the window can be as small as that";
      auto* panel = this->Window->findChild<DrawingPanel*>();
      for (auto* control : panel->findChildren<QWidget*>(QRegularExpression("^draw-")))
      {
        const QSize least = control->isVisible() ? control->minimumSizeHint() : QSize();
        EXPECT_GE(control->width(), least.width()) << control->objectName().toStdString();
        EXPECT_GE(control->height(), least.height()) << control->objectName().toStdString();
      }
      this->Show(
          QString("draw-%1-%2").arg(look == WindowLook::Dark ? "dark" : "light").arg(size.width()));
      this->Study->New();
      QTest::keyClick(this->Window.get(), Qt::Key_Escape);
    }
  }
  ChooseLook(WindowLook::System);
}

TEST_F(DrawingPanelTest, KnownOrganIsProposedAndTheOtherDrawnAtUsualSizes)
{
  for (const QSize& size : Sizes)
  {
    this->Open(size);
    auto* known = this->Window->findChild<QComboBox*>("draw-known");
    EXPECT_FALSE(known->isVisible());
    this->ChooseZonePrior();
    EXPECT_TRUE(this->IsShown()) << "before any touch";
    EXPECT_EQ(known->currentData().toInt(), 1) << known->currentText().toStdString();
    const QSize least = known->minimumSizeHint();
    EXPECT_TRUE(known->isVisible());
    EXPECT_GE(known->width(), least.width());
    EXPECT_GE(known->height(), least.height());
    EXPECT_EQ(this->Window->size(), size);
    EXPECT_TRUE(this->Line().contains("mark 1")) << this->Line().toStdString();
    // The next clicks are touches, since the known organ says where the middle is.
    const Vector3 behind = this->Center + Vector3(0.0, 5.0, 0.0);
    this->GoTo(behind);
    for (int n = 0; n < 6; ++n)
    {
      this->ClickAt(SliceOrientation::Axial,
                    behind + 5.0 * Vector3(std::cos(1.05 * n), std::sin(1.05 * n), 0.0));
    }
    EXPECT_EQ(this->Drawn().Touches.size(), 6U);
    EXPECT_TRUE(this->Organ().Next().empty());
    EXPECT_FALSE(this->Line().startsWith("Refused")) << this->Line().toStdString();
    this->Show(QString("draw-zone-%1").arg(size.width()));
    this->Study->New();
    QTest::keyClick(this->Window.get(), Qt::Key_Escape);
  }
}

TEST_F(DrawingPanelTest, KnownOrganIsAChoiceThatIsUndone)
{
  this->Open();
  this->ChooseZonePrior();
  auto* known = this->Window->findChild<QComboBox*>("draw-known");
  known->setFocus();
  QTest::keyClick(known, Qt::Key_Home);
  EXPECT_EQ(this->Drawn().KnownId, 0);
  EXPECT_FALSE(this->IsShown()) << "there is no touch and no middle";
  EXPECT_TRUE(this->Line().contains("Choose the known organ")) << this->Line().toStdString();
  QTest::keyClick(this->Window.get(), Qt::Key_Z, Qt::ControlModifier);
  WaitUntil([this] { return this->Organ().Surface() != nullptr; });
  EXPECT_TRUE(this->IsShown());
  EXPECT_EQ(known->currentData().toInt(), 1);
}

TEST_F(DrawingPanelTest, KeptZoneIsASurfaceModelThatNamesWhatWasKnown)
{
  this->Open();
  this->ChooseZonePrior();
  this->ExpectSameStudyAfterReopening();
  this->Chosen = QString::fromStdString((this->Phantom.Folder / "kept" / "zone").string());
  const std::size_t before = this->Study->State().Structures.size();
  WaitUntil([this] { return this->Button("draw-keep")->isEnabled(); });
  QTest::mouseClick(this->Button("draw-keep"), Qt::LeftButton);
  WaitUntil([&] { return this->Study->State().Structures.size() > before; });
  const std::filesystem::path folder = this->Study->State().Structures.back().File.parent_path();
  EXPECT_TRUE(std::holds_alternative<SurfaceModel>(ReadModel(folder / "model.json").Surface));
  const std::string said = ReadWholeFile(folder / "completion.json", 1U << 20U);
  EXPECT_NE(said.find("mask.nii.gz"), std::string::npos) << said;
  EXPECT_NE(said.find("\"prior_cases\":24"), std::string::npos) << said;
}

TEST_F(DrawingPanelTest, DrawnOrganIsFeltSofterWhereUnsureUnlessSwitchedOff)
{
  this->Open();
  this->DrawSphere();
  const auto isSoftened = [this]
  {
    for (const SceneContact& contact : this->Study->Current().Contacts())
    {
      if (contact.Id == StudyDrawn::StructureId)
      {
        return contact.Effects != nullptr;
      }
    }
    throw std::runtime_error("it is not felt");
  };
  auto* softened = this->Window->findChild<QCheckBox*>("draw-softened");
  EXPECT_TRUE(softened->isChecked());
  EXPECT_TRUE(isSoftened());
  QTest::mouseClick(softened, Qt::LeftButton);
  EXPECT_FALSE(softened->isChecked());
  EXPECT_FALSE(isSoftened());
  QTest::keyClick(this->Window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(softened->isChecked());
  EXPECT_TRUE(isSoftened());
  QTest::mouseClick(this->Window->findChild<QCheckBox*>("draw-touchable"), Qt::LeftButton);
  EXPECT_FALSE(softened->isEnabled()) << "what is not felt is not soft";
}
} // namespace
} // namespace palpate::drawing_panel_test
