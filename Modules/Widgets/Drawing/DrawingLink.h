#pragma once

#include "StudyController.h"
#include "ViewContents.h"
#include "ViewGrid.h"

#include <QAction>
#include <QElapsedTimer>
#include <QObject>

#include <array>
#include <functional>
#include <vector>

namespace palpate
{
/// The mode in which clicks, strokes on slices and the tool's contacts draw an organ. The study
/// completes it; the views show its surface and, in the mode, touches and where to touch next.
class DrawingLink : public QObject
{
  Q_OBJECT

public:
  /// What a click is.
  enum class Next
  {
    Surface, ///< a touch on the organ, or a stroke
    Outside, ///< a point that the organ does not reach
    Center   ///< the organ's middle
  };
  static constexpr std::array<Next, 3> AllNext{{Next::Surface, Next::Outside, Next::Center}};

  /// Keeps the addresses. `contact` is the place of the tool's contact (world, mm).
  DrawingLink(StudyController& study, ViewContents& contents, ViewGrid& views,
              std::function<Vector3()> contact, QObject* parent);

  /// Switches the mode.
  QAction* Mode() const { return this->Drawing; }
  /// Adds a touch where the tool touches.
  QAction* TouchTool() const { return this->Touched; }
  void Choose(Next next);
  Next Chosen() const { return this->Meant; }
  /// Whether a contact of the tool that lasts adds a touch by itself.
  void TakeContacts(bool areTaken) { this->AreContactsTaken = areTaken; }

Q_SIGNALS:
  void ChoiceChanged();

private:
  void FollowSlice(SlicePane* slice);
  void ShowMode();
  void ShowDrawing();
  void TakeStroke(bool isOutside);
  void TakePoint(Next meant, const Vector3& pointWorld);
  void TakeSpace(double x, double y);
  void TouchWhereTouched();
  void FollowTouch();
  void Add(const QString& message, std::vector<SurfaceTouch> touches);

  StudyController& Study;
  ViewContents& Contents;
  ViewGrid& Views;
  std::function<Vector3()> Contact;
  QAction* Drawing;
  QAction* Touched;
  Next Meant = Next::Surface;
  std::vector<Vector3> Stroke; ///< world, mm; while it is drawn
  double StrokePixel = 1.0;    ///< size of a pixel there, mm
  bool AreContactsTaken = true;
  bool IsContactTaken = false; ///< the present one
  QElapsedTimer SinceContact;
};
} // namespace palpate
