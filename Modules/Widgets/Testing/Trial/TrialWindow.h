#pragma once

#include "DrillWindowTest.h"

#include <QDropEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QTest>

#include <cmath>
#include <random>

namespace palpate::test
{
/// A window, and files to work with: a CT of a round mastoid with air cells, through which a nerve
/// runs upwards; the nerve as a label on a coarser grid; an MR volume on an oblique and anisotropic
/// grid.
class TrialWindow : public DrillWindowTest
{
protected:
  static constexpr double BoneRadius = 10.0; // mm
  static constexpr double NerveRadius = 2.0; // mm
  static constexpr double Voxel = 0.8;       // mm

  void SetUp() override
  {
    DrillWindowTest::SetUp();
    std::mt19937_64 random(23);
    LabelGrid grid;
    grid.Size = {{40, 40, 40}};
    grid.Spacing = {{Voxel, Voxel, Voxel}};
    grid.CenterOnOrigin();
    const auto ct = MakeLabelImage<short>(grid, [](double x, double y, double z)
                                          { return std::hypot(x, y, z) < BoneRadius; });
    auto* values = static_cast<short*>(ct->GetScalarPointer());
    std::uniform_int_distribution<int> noise(-20, 20); // HU
    for (vtkIdType voxel = 0; voxel < ct->GetNumberOfPoints(); ++voxel)
    {
      const Vector3 place(ct->GetPoint(voxel));
      const bool isCell = (place - Vector3(0.0, 4.0, 5.0)).norm() < 1.5;
      values[voxel] =
          static_cast<short>((values[voxel] == 0 || isCell ? -1000 : 1200) + noise(random));
    }
    WriteImage(this->Ct, ct);
    grid.Size = {{20, 20, 32}};
    grid.Spacing = {{1.0, 1.0, 1.0}};
    grid.CenterOnOrigin();
    WriteImage(this->Nerve, MakeLabelImage(grid, [](double x, double y, double)
                                           { return std::hypot(x, y) < NerveRadius; }));
    grid.Size = {{36, 30, 12}};
    grid.Spacing = {{1.1, 1.3, 4.0}};
    grid.Direction = RandomRotation(random);
    grid.CenterOnOrigin();
    WriteImage(this->Mr, MakeLabelImage<short>(
                             grid, [](double x, double, double z) { return x + z < 0.0; }, 100));
    Activate(*this->Window);
  }
  // A key combination of the menus.
  void Type(Qt::Key key, Qt::KeyboardModifiers modifiers)
  {
    Activate(*this->Window);
    this->Window->setFocus();
    QTest::keyClick(this->Window.get(), key, modifiers);
  }
  static void ClickOn(QWidget* widget)
  {
    ASSERT_NE(widget, nullptr);
    QTest::mouseClick(widget, Qt::LeftButton);
    QApplication::processEvents();
  }
  void Drop(const std::filesystem::path& file)
  {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(QString::fromStdString(file.string()))});
    QDragEnterEvent enter({300, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(this->Window.get(), &enter);
    QDropEvent drop(QPointF(300.0, 300.0), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(this->Window.get(), &drop);
  }
  void Choose(const std::filesystem::path& file)
  {
    this->Opened = QStringList(QString::fromStdString(file.string()));
  }

  std::filesystem::path Ct = this->Phantom.Folder / "ct.nrrd";
  std::filesystem::path Nerve = this->Phantom.Folder / "nerve.nrrd";
  std::filesystem::path Mr = this->Phantom.Folder / "mr.nrrd";
  std::filesystem::path MovedMr = this->Phantom.Folder / "moved.nrrd";
};
} // namespace palpate::test
