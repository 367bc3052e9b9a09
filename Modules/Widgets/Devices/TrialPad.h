#pragma once

#include "Vector3.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace palpate
{
/// Shows a device's workspace from the front, with its pointer and a bar for the depth, and leads
/// the hand of a device that has none of its own: by the pointer, the wheel and a press.
class TrialPad : public QWidget
{
  Q_OBJECT

public:
  explicit TrialPad(QWidget* parent);

  /// mm of the device; empty: not known.
  void SetWorkspace(const Eigen::AlignedBox3d& workspace);
  /// Where the wall begins (mm, z); none: there is none.
  void SetWall(std::optional<double> wall);
  /// Where the pointer is (mm, device), and the force on it (N).
  void ShowPointer(const Vector3& place, double force, double mostForce);
  /// Nothing is known.
  void Clear();
  /// mm of the device, of a place on the front view.
  QPointF PixelOf(const Vector3& place) const;

  QSize sizeHint() const override { return {360, 180}; }
  QSize minimumSizeHint() const override { return {220, 120}; }

Q_SIGNALS:
  void Led(const Vector3& target); ///< mm of the device; may be far from where the hand is

protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  bool event(QEvent* event) override;

private:
  QRectF Front() const;
  QRectF DepthBar() const;
  double PixelsPerMillimeter() const;
  double PixelOfDepth(double z) const;
  void PaintField(QPainter& painter) const;
  void PaintPointer(QPainter& painter) const;
  void Lead();

  Eigen::AlignedBox3d Box;
  std::optional<double> Wall;
  std::optional<Vector3> Pointer;
  std::vector<Vector3> Trace; ///< where it has been
  double Force = 0.0;
  double MostForce = 1.0;
  Vector3 Target = Vector3::Zero(); ///< of a hand that is led
  bool IsPressed = false;
};
} // namespace palpate
