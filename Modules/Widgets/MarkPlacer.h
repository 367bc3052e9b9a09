#pragma once

#include "StudyController.h"
#include "StudyMeasuring.h"
#include "ViewContents.h"

#include <QElapsedTimer>
#include <QObject>

#include <optional>
#include <vector>

namespace palpate
{
/// Places landmarks and the points of measurements, by click and by touch. While a measurement is
/// open, its value with the point under the pointer or the tool is shown in the views. Points on a
/// surface that is being prepared (MeasuredSurfaces) are placed when it is.
class MarkPlacer : public QObject
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  MarkPlacer(StudyController& study, ViewContents& contents, QObject* parent);

  /// What is placed next; none: landmarks.
  void Choose(std::optional<MeasurementKind> kind);
  /// Of previewed values.
  void SetLengthUnit(LengthUnit unit) { this->Unit = unit; }
  std::optional<MeasurementKind> Chosen() const { return this->Kind; }

  /// World, mm.
  void Place(const Vector3& pointWorld) { this->Place(PlacedPoint{pointWorld, 0}); }
  /// At the contact of the tool, or at the tool itself without contact.
  void PlaceWhereTouched();
  /// There: the nearest point of the displayed surface of the touched structure, if it has one.
  PlacedPoint TouchedPoint();
  /// Ends the open curve. Without two points it is removed.
  void End();
  /// Whether there is a curve to end.
  bool HasOpenCurve() const;

  /// For a pointer at this point (world, mm).
  void Preview(const Vector3& pointWorld) { this->Preview(PlacedPoint{pointWorld, 0}); }
  void ClearPreview();

Q_SIGNALS:
  /// Name and value of the measurement as previewed; empty if there is none.
  void Previewed(const QString& text);

private:
  void Place(const PlacedPoint& point);
  void Preview(const PlacedPoint& point);
  void PlaceWaiting();
  void ShowPreparing();
  void FollowTouch();
  void TakeSurfaces();

  StudyController& Study;
  ViewContents& Contents;
  MeasuredSurfaces Surfaces{this->Study.Current().Jobs()};
  std::optional<MeasurementKind> Kind;
  LengthUnit Unit = LengthUnit::Millimeter;
  std::vector<PlacedPoint> Waiting; ///< for a surface that is being prepared
  QElapsedTimer SincePreview;
  qint64 Pause = 0; ///< ms from one preview to the next
};
} // namespace palpate
