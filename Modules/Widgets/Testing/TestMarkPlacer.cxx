#include "BodyGeodesics.h"
#include "FitResult.h"
#include "ModelFile.h"
#include "WindowTest.h"

#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>
#include <QTableWidget>
#include <QWindow>

#include "vtkCamera.h"

#include <cmath>

namespace palpate::mark_placer_test
{
namespace
{
// A window of 1280 x 800 with the phantom: label 1 is a sphere of 9 mm around (-15, 0, 0).
class MarkPlacerTest : public test::WindowTest
{
protected:
  void Open()
  {
    this->Window->resize(1280, 800);
    this->OpenPhantom();
  }
  void Type(QWidget* widget, Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    QKeyEvent press(QEvent::KeyPress, key, modifiers);
    QApplication::sendEvent(widget, &press);
    QKeyEvent release(QEvent::KeyRelease, key, modifiers);
    QApplication::sendEvent(widget, &release);
  }
  // By keyboard, in the panel that placing opens.
  void PlaceNext(MeasurementKind kind)
  {
    this->Action("Add landmarks by click")->setChecked(true);
    auto* next = this->Window->findChild<QComboBox*>("next-mark");
    this->Type(next, Qt::Key_Home);
    for (int i = 0; i <= static_cast<int>(kind); ++i)
    {
      this->Type(next, Qt::Key_Down);
    }
    ASSERT_EQ(next->currentText().toStdString(), NameOf(kind));
    DrawAll(*this->Window->Views());
  }
  // What `palpate measure` finds between the curve's ends, on the saved model.
  double AlongModel(const StudyMeasurement& curve) const
  {
    const auto fit =
        this->Study->Current().Pipeline().Newest<FitResult>(SceneStep::Model, curve.StructureId);
    const std::filesystem::path file = this->Phantom.Folder / "sphere.json";
    WriteModel(file, {fit->Model, {}});
    const ComparedFile saved = ComparedFile::Read(file, {});
    return BodyGeodesics(saved, saved.Structures().front())
        .Find(curve.PointsWorld.front(), curve.PointsWorld.back(),
              [](double, const std::string&) { return true; })
        .Along;
  }
  SlicePane* Axial() const { return this->Window->Views()->Slice(SliceOrientation::Axial); }
  // In an axial slice, mm from its middle.
  QPointF AxialPlace(double right, double down) const
  {
    const double scale =
        this->Axial()->Canvas()->devicePixelRatioF() * this->Axial()->View()->GetPixelMillimeters();
    const QSize size = this->Axial()->Canvas()->size();
    return {0.5 * size.width() + right / scale, 0.5 * size.height() + down / scale};
  }
  void ClickAxial(double right, double down)
  {
    Click(this->Axial()->Canvas(), this->AxialPlace(right, down));
  }
  void ClickSpace(const Vector3& world)
  {
    Click(this->Window->Views()->Space()->Canvas(), this->PlaceOf(world));
  }
  // The point of a surface that is nearest to the camera.
  Vector3 Foremost(vtkPolyData& surface) const
  {
    vtkRenderer* renderer = this->Window->Views()->Space()->View()->GetRenderer();
    const Vector3 camera(renderer->GetActiveCamera()->GetPosition());
    Vector3 nearest(surface.GetPoint(0));
    for (vtkIdType i = 1; i < surface.GetNumberOfPoints(); ++i)
    {
      const Vector3 point(surface.GetPoint(i));
      nearest = (point - camera).norm() < (nearest - camera).norm() ? point : nearest;
    }
    return nearest;
  }
  std::vector<StudyMeasurement> Measured() const { return this->Study->State().Measurements; }
  std::string Cell(int row, int column) const
  {
    auto* table = this->Window->findChild<QTableWidget*>("landmarks");
    return table->item(row, column)->text().toStdString();
  }
  std::string LiveValue() const
  {
    return this->Window->findChild<QLabel*>("live-value")->text().toStdString();
  }
  // Written where PALPATE_PICTURES says, for people to look at.
  void Show(const char* name)
  {
    DrawAll(*this->Window->Views());
    if (const char* folder = std::getenv("PALPATE_PICTURES"))
    {
      EXPECT_TRUE(this->Window->SaveScreenshot(QString(folder) + "/" + name));
      this->Window->grab().save(QString(folder) + "/window-" + name);
    }
  }

  const Vector3 SphereCenter{-15.0, 0.0, 0.0};
};

TEST_F(MarkPlacerTest, ThreeClicksMakeAnAngleAndEachCanBeUndone)
{
  this->Open();
  this->PlaceNext(MeasurementKind::Angle);
  this->ClickAxial(12.0, 0.0);
  this->ClickAxial(0.0, 0.0);
  ASSERT_EQ(this->Measured().size(), 1U);
  EXPECT_TRUE(this->Measured()[0].IsOpen);
  EXPECT_EQ(this->Cell(0, 1), "Angle (2 of 3 points)");
  this->ClickAxial(0.0, 12.0);
  ASSERT_EQ(this->Measured().size(), 1U);
  const StudyMeasurement angle = this->Measured()[0];
  EXPECT_FALSE(angle.IsOpen);
  EXPECT_NEAR(*ValueOf(angle), 90.0, 3.0) << "a pixel of 12 mm";
  EXPECT_EQ(this->Cell(0, 1), "Angle");
  EXPECT_EQ(this->Cell(0, 3), "deg");
  this->Show("angle.png");
  for (std::size_t left = 2; left > 0; --left)
  {
    this->Study->Undo();
    ASSERT_EQ(this->Measured().size(), 1U);
    EXPECT_EQ(this->Measured()[0].PointsWorld.size(), left);
  }
  this->Study->Undo();
  EXPECT_TRUE(this->Measured().empty());
  for (int i = 0; i < 3; ++i)
  {
    this->Study->Redo();
  }
  EXPECT_EQ(this->Measured(), std::vector<StudyMeasurement>{angle});
}

TEST_F(MarkPlacerTest, ReturnInAViewEndsACurve)
{
  this->Open();
  Activate(*this->Window);
  this->PlaceNext(MeasurementKind::Curve);
  EXPECT_FALSE(this->Button("end-curve")->isEnabled());
  this->ClickAxial(-5.0, 0.0);
  this->ClickAxial(0.0, 3.0);
  this->ClickAxial(5.0, 0.0);
  EXPECT_TRUE(this->Button("end-curve")->isEnabled());
  EXPECT_EQ(this->Cell(0, 1), "Curve (open, 3 points)");
  this->Axial()->Canvas()->setFocus();
  QKeyEvent press(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
  QApplication::sendEvent(this->Window->windowHandle(), &press);
  ASSERT_EQ(this->Measured().size(), 1U);
  EXPECT_FALSE(this->Measured()[0].IsOpen);
  EXPECT_NEAR(*ValueOf(this->Measured()[0]), 2.0 * std::hypot(5.0, 3.0), 1.0);
  EXPECT_FALSE(this->Button("end-curve")->isEnabled());
}

TEST_F(MarkPlacerTest, CurveOverTheSphereIsAnArc)
{
  this->Open();
  this->PlaceNext(MeasurementKind::SurfaceCurve);
  this->ClickSpace(this->SphereCenter + Vector3(5.0, 0.0, 4.0));
  this->ClickSpace(this->SphereCenter + Vector3(-5.0, 0.0, -4.0));
  ASSERT_EQ(this->Measured().size(), 1U) << this->Messages();
  const StudyMeasurement curve = this->Measured()[0];
  ASSERT_EQ(curve.PointsWorld.size(), 2U);
  EXPECT_EQ(curve.StructureId, 1);
  const Vector3 from = (curve.PointsWorld[0] - this->SphereCenter).normalized();
  const Vector3 to = (curve.PointsWorld[1] - this->SphereCenter).normalized();
  const double arc = 9.0 * std::acos(from.dot(to));
  EXPECT_GT(arc, 8.0);
  EXPECT_NEAR(*ValueOf(curve), arc, 0.05 * arc) << "a model of voxels of 1 mm";
  EXPECT_GT(*ValueOf(curve), (curve.PointsWorld[1] - curve.PointsWorld[0]).norm());
  EXPECT_NEAR(*ValueOf(curve), this->AlongModel(curve), 1e-9) << "as palpate measure has it";
  this->Button("end-curve")->click();
  this->Show("arc.png");
  EXPECT_FALSE(this->Measured()[0].IsOpen);
}

TEST_F(MarkPlacerTest, DistanceOfStructuresIsThatOfTheirSurfaces)
{
  this->Open();
  this->PlaceNext(MeasurementKind::Gap);
  const auto& surfaces = this->Window->Contents().Surfaces();
  ASSERT_GE(surfaces.size(), 2U);
  for (const auto& one : {surfaces.begin(), std::prev(surfaces.end())})
  {
    this->ClickSpace(this->Foremost(*one->second->GetSurface()));
  }
  ASSERT_EQ(this->Measured().size(), 1U) << this->Messages();
  const StudyMeasurement gap = this->Measured()[0];
  EXPECT_FALSE(gap.IsOpen) << this->Messages();
  this->Show("gap.png");
}

TEST_F(MarkPlacerTest, PointerOnASliceShowsTheValueBeforeTheClick)
{
  this->Open();
  this->PlaceNext(MeasurementKind::Line);
  this->ClickAxial(0.0, 0.0);
  Move(this->Axial()->Canvas(), this->AxialPlace(10.0, 0.0));
  EXPECT_NE(this->LiveValue().find("Line 1: "), std::string::npos) << this->LiveValue();
  EXPECT_EQ(this->Window->Contents().Landmarks()->GetCurves().size(), 1U);
  EXPECT_EQ(this->Measured()[0].PointsWorld.size(), 1U) << "nothing is placed";
  this->Show("preview.png");
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(this->Axial()->Canvas(), &leave);
  EXPECT_EQ(this->LiveValue(), "");
  EXPECT_TRUE(this->Window->Contents().Landmarks()->GetCurves().empty());
}

// The tool shows the thickness under it; the key keeps it.
TEST_F(MarkPlacerTest, ThicknessIsMeasuredWhileTouching)
{
  this->Open();
  StudyState next = this->Study->State();
  next.Structures.resize(1);
  this->Study->Change("Keep the ball", next);
  this->BeginTouch();
  this->PlaceNext(MeasurementKind::Thickness);
  this->Press(this->SphereCenter, 0.5);
  this->FeelUntil([this] { return this->LiveValue().find("Thickness: 1") != std::string::npos; });
  this->Show("touch.png");
  Activate(*this->Window);
  QKeyEvent press(QEvent::KeyPress, Qt::Key_A, Qt::ShiftModifier, "A");
  QApplication::sendEvent(this->Window->windowHandle(), &press);
  ASSERT_EQ(this->Measured().size(), 1U) << this->Messages();
  EXPECT_NEAR(*ValueOf(this->Measured()[0]), 18.0, 1.0);
  EXPECT_NEAR((this->Measured()[0].PointsWorld[0] - this->SphereCenter).norm(), 9.0, 0.5)
      << "the contact, not the tool's centre";
  EXPECT_TRUE(this->Study->IsTouching());
}

TEST_F(MarkPlacerTest, PointsFarFromAnySurfaceAreRefused)
{
  this->Open();
  this->PlaceNext(MeasurementKind::Thickness);
  this->Window->findChild<MarkPlacer*>()->Place(Vector3(0.0, 0.0, 500.0));
  EXPECT_TRUE(this->Measured().empty());
  EXPECT_NE(this->Messages().find("10 mm"), std::string::npos);
}

TEST_F(MarkPlacerTest, SessionKeepsMeasurementsAndTheOpenOne)
{
  this->Open();
  this->PlaceNext(MeasurementKind::SurfaceCurve);
  this->ClickSpace(this->SphereCenter + Vector3(5.0, 0.0, 4.0));
  this->ClickSpace(this->SphereCenter + Vector3(-5.0, 0.0, -4.0));
  this->PlaceNext(MeasurementKind::Plane);
  this->ClickAxial(5.0, 0.0);
  ASSERT_EQ(this->Measured().size(), 2U);
  EXPECT_TRUE(this->Measured()[1].IsOpen);
  this->ExpectSameStudyAfterReopening();
  EXPECT_EQ(this->Window->Contents().Landmarks()->GetCurves().size(), 1U);
  this->ClickAxial(0.0, 5.0);
  this->ClickAxial(0.0, 0.0);
  EXPECT_FALSE(this->Measured()[1].IsOpen) << "it goes on";
}

TEST_F(MarkPlacerTest, MarkupsOfSlicerAreAddedAsOneStep)
{
  this->Open();
  const auto file = this->Phantom.Folder / "slicer.mrk.json";
  test::WriteAll(file, R"({"markups": [
    {"type": "Fiducial", "coordinateSystem": "RAS", "controlPoints": [
      {"label": "apex", "position": [15, 0, 0]}]},
    {"type": "Line", "name": "width", "coordinateSystem": "LPS", "controlPoints": [
      {"position": [0, 0, 0]}, {"position": [0, 3, 4]}]}]})");
  this->Opened = QStringList{QString::fromStdString(file.string())};
  this->Window->Messages()->Clear();
  this->Button("import-landmarks")->click();
  WaitUntil([this] { return !this->Measured().empty() || !this->Messages().empty(); });
  ASSERT_EQ(this->Measured().size(), 1U) << this->Messages();
  EXPECT_EQ(this->Study->State().Landmarks.at(0).PositionWorld, this->SphereCenter);
  EXPECT_EQ(this->Cell(1, 2), "5.00");
  this->Study->Undo();
  EXPECT_TRUE(this->Measured().empty());
  EXPECT_TRUE(this->Study->State().Landmarks.empty());
}

TEST_F(MarkPlacerTest, TableTellsSidesByLettersAndShowsTheNewRow)
{
  this->Open();
  StudyState next = this->Study->State();
  for (int n = 0; n < 40; ++n)
  {
    next.Landmarks.push_back({"F-" + std::to_string(n + 1), Vector3(-18.35, 2.0, 0.0)});
  }
  this->Action("Add landmarks by click")->setChecked(true); // which opens the panel
  auto* table = this->Window->findChild<QTableWidget*>("landmarks");
  DrawAll(*this->Window->Views());
  EXPECT_TRUE(table->isVisible());
  this->Study->Change("Add many", next);
  QApplication::processEvents();
  EXPECT_EQ(table->item(39, 4)->text(), "R 18.35");
  EXPECT_EQ(table->item(39, 5)->text(), "P 2.00");
  EXPECT_EQ(table->item(39, 6)->text(), "S 0.00");
  const QRect last = table->visualItemRect(table->item(39, 0));
  EXPECT_TRUE(table->viewport()->rect().intersects(last))
      << last.y() << " of " << table->viewport()->height();
}
} // namespace
} // namespace palpate::mark_placer_test
