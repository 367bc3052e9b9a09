#pragma once

#include "CorrectionPanel.h"
#include "WindowTest.h"

#include <QTest>

#include <array>
#include <cmath>
#include <cstdlib>
#include <variant>
#include <vector>

namespace palpate::test
{
/// The last is 1600 x 1000 at scale 2.
inline const std::array<QSize, 3> PullSizes{QSize(1280, 800), QSize(1024, 700), QSize(800, 500)};

/// Label 1 of the phantom, a sphere of 9 mm around (-15, 0, 0), is corrected.
class CorrectionTest : public WindowTest
{
protected:
  void Open(const QSize& size = QSize(1280, 800))
  {
    this->Window->resize(size);
    this->OpenPhantom();
    Activate(*this->Window);
    this->Window->Contents().Crosshair()->SetPositionWorld(this->Center.data());
    QTest::keyClick(this->Axial()->Canvas(), Qt::Key_G);
    ASSERT_TRUE(this->Action("Push and pull")->isChecked());
    this->WaitForSurface();
    this->Window->findChild<QDoubleSpinBox*>("correct-width")->setValue(3.0);
  }
  void WaitForSurface()
  {
    WaitUntil([this] { return this->Shape().IsReady() && !this->Shape().IsWorking(); });
    DrawAll(*this->Window->Views());
  }
  SlicePane* Axial() const { return this->Window->Views()->Slice(SliceOrientation::Axial); }
  SpacePane* Space() const { return this->Window->Views()->Space(); }
  StudyCorrected& Shape() { return this->Study->Current().Corrected(); }
  const std::vector<CorrectionStep>& Steps() const { return this->Study->State().Correction.Steps; }
  const SurfacePull& LastPull() const { return std::get<SurfacePull>(this->Steps().back()); }
  static void Drag(ViewPane* pane, const QPointF& from, const QPointF& to, bool isReleased = true)
  {
    constexpr int Moves = 8;
    SendMouse(pane->Canvas(), QEvent::MouseMove, from, Qt::NoButton, Qt::NoButton);
    SendMouse(pane->Canvas(), QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
    for (int n = 1; n <= Moves; ++n)
    {
      SendMouse(pane->Canvas(), QEvent::MouseMove, from + (to - from) * n / Moves, Qt::NoButton,
                Qt::LeftButton);
    }
    if (isReleased)
    {
      SendMouse(pane->Canvas(), QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
    }
  }
  void DragInSlice(const Vector3& from, const Vector3& to, bool isReleased = true)
  {
    Drag(this->Axial(), PlaceIn(*this->Axial(), from), PlaceIn(*this->Axial(), to), isReleased);
  }
  // The wheel, which pushes otherwise, is the width's.
  void TouchTheTop()
  {
    this->FeelUntil(
        [this]
        {
          this->Study->Current().Touch().MoveHand(this->Center + Vector3(0, 10.0, 0));
          return this->Study->Reading().TouchedId == 1;
        });
  }
  // The largest distance from the sphere's centre of what is shown.
  double LargestRadius() const
  {
    double largest = 0.0;
    vtkPolyData* surface = this->Shown()->GetSurface();
    for (vtkIdType n = 0; n < surface->GetNumberOfPoints(); ++n)
    {
      largest = std::max(largest, (Vector3(surface->GetPoint(n)) - this->Center).norm());
    }
    return largest;
  }
  vtkSurfaceDisplay* Shown() const { return this->Window->Contents().Correction().Display(); }
  double Width() const
  {
    return this->Window->findChild<QDoubleSpinBox*>("correct-width")->value();
  }
  QString Line() const { return this->Window->findChild<QLabel*>("correct-line")->text(); }
  bool HasRing() const { return !this->Window->Contents().Landmarks()->GetCurves().empty(); }
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
  const Vector3 Top{-15.0, 9.0, 0.0}; // towards the back
};
} // namespace palpate::test
