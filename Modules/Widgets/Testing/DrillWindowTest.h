#pragma once

#include "StructureTableModel.h"
#include "WindowTest.h"

#include "vtkSubVoxelVolumeMapper.h"

#include <QKeyEvent>
#include <QTableView>

namespace palpate::test
{
/// A window in which the phantom's sphere is drilled.
class DrillWindowTest : public WindowTest
{
protected:
  QAbstractItemModel* Table() const
  {
    return this->Window->findChild<QTableView*>("structures")->model();
  }
  void Choose(int row, int role)
  {
    this->Table()->setData(this->Table()->index(row, StructureTableModel::DrillColumn), role);
  }
  std::string StatusOf(int row) const
  {
    return this->Table()
        ->index(row, StructureTableModel::StatusColumn)
        .data()
        .toString()
        .toStdString();
  }
  /// Starts touching the sphere alone, as soft tissue.
  void StartDrilling()
  {
    this->OpenPhantom();
    StudyState next = this->Study->State();
    next.Structures.resize(1);
    next.Structures[0].Drill.Wear = 2.0;
    next.Tool.Radius = 3.0;
    this->Study->Change("Drill the ball", next);
    this->Settle();
    this->StartTouch();
  }
  void StartTouch()
  {
    DrawAll(*this->Window->Views());
    this->Window->Messages()->Clear(); // on structures that cannot be modelled
    this->Button("start-touch")->click();
    WaitUntil([this] { return this->Study->IsTouching() || !this->Messages().empty(); });
    ASSERT_TRUE(this->Study->IsTouching()) << this->Messages();
  }
  double Removed() const
  {
    const auto& drilled = this->Study->Reading().Drill.Drilled;
    return drilled.empty() ? -1.0 : drilled[0].RemovedVolume;
  }
  void Key(QEvent::Type type, int key)
  {
    QKeyEvent event(type, key, Qt::NoModifier);
    QApplication::sendEvent(this->Window->Views(), &event);
  }
  /// Presses the hand into the sphere with the pedal down until `volume` is removed.
  void Drill(double volume)
  {
    const Vector3 hand = this->Study->Current().Touch().HandWorld();
    const Vector3 inward = (this->SphereCenter - hand).normalized();
    constexpr double Step = 0.025; // mm a tick
    this->Key(QEvent::KeyPress, Qt::Key_D);
    const std::uint64_t first = this->Study->Reading().Newest.Tick.Number;
    this->FeelUntil(
        [&]
        {
          const std::uint64_t ticks = this->Study->Reading().Newest.Tick.Number - first;
          const double path =
              std::min(Step * static_cast<double>(ticks), (this->SphereCenter - hand).norm());
          this->Study->Current().Touch().MoveHand(hand + path * inward);
          return this->Removed() > volume;
        });
    this->Key(QEvent::KeyRelease, Qt::Key_D);
    WaitUntil([this] { return !this->Study->Reading().Newest.IsDrilling; });
  }
  /// The field that the 3-D view shows of a structure, or null.
  std::shared_ptr<const ScalarField> Shown(int id = 1) const
  {
    const auto& fields = this->Window->Contents().Fields();
    const auto one = fields.find(id);
    return one == fields.end()
               ? nullptr
               : vtkSubVoxelVolumeMapper::SafeDownCast(one->second->GetMapper())->GetField();
  }

  const Vector3 SphereCenter{-15.0, 0.0, 0.0};
};
} // namespace palpate::test
