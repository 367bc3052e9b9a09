#pragma once

#include "PointerPlace.h"
#include "ViewBanner.h"
#include "ViewHeader.h"

#include "vtkEventQtSlotConnect.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <QAction>
#include <QMouseEvent>
#include <QVTKOpenGLNativeWidget.h>
#include <QWheelEvent>
#include <QWidget>

#include <utility>

class vtkInteractorStyle;
class vtkLinkedView;
class vtkSurfaceDisplay;

namespace palpate
{
class ViewContents;

/// VTK's canvas in a window. Its interactor draws only when Qt paints: a style that asks to render
/// at each mouse move triggers only a RenderEvent.
class ViewCanvas : public QVTKOpenGLNativeWidget
{
public:
  explicit ViewCanvas(QWidget* parent);

protected:
  void paintGL() override;
};

/// A view with its header. It draws at most once per turn of the event loop, however often it is
/// asked to, and not at all while hidden.
class ViewPane : public QWidget
{
  Q_OBJECT

public:
  ViewPane(const QString& name, const QColor& color, QWidget* parent);

  /// The widget that VTK draws in and that receives the mouse.
  ViewCanvas* Canvas() const { return this->RasterImage; }
  vtkRenderer* Renderer() const { return this->Scene; }
  /// Over its upper edge.
  void ShowNotice(const TouchNotice& notice) { this->Banner->Show(notice); }
  const QString& Name() const { return this->Title; }
  /// An entry of the header's context menu.
  template <typename Function>
  void AddToHeader(const QString& text, Function&& run)
  {
    auto* action = new QAction(text, this->Bar);
    connect(action, &QAction::triggered, this, std::forward<Function>(run));
    this->Bar->addAction(action);
  }
  /// Draws now if a frame is due.
  void RenderNow();
  /// Draws now, as at rest.
  virtual void Settle()
  {
    this->RequestFrame();
    this->RenderNow();
  }
  /// Number of frames drawn.
  int RenderCount() const { return this->Drawn; }

  /// Whether left presses and turns of the wheel are offered first (StrokeBegun, WheelTurned): what
  /// is accepted there, the style does not get, nor the drag that follows.
  virtual void SetStrokes(bool areOn);
  bool HasStrokes() const { return this->AreStrokesOn; }
  void Accept() { this->IsAccepted = true; }

  void AddSurface(vtkSurfaceDisplay* surface);
  void RemoveSurface(vtkSurfaceDisplay* surface);
  void SetAlongImage(bool isAlongImage);
  void SetLengthUnit(LengthUnit unit);

  /// Draws whenever the object is modified, until the pane ends.
  void Follow(vtkObject* shared);
  void Unfollow(vtkObject* shared);

public Q_SLOTS:
  /// Draws soon.
  void RequestRender();

Q_SIGNALS:
  void MaximizeAsked();
  /// Over the canvas, in its pixels from the lower left.
  void PointerMoved(double x, double y);
  void PointerLeft();
  void Clicked(double x, double y);
  /// Clicked and released at the same place, and not dragged.
  void Tapped(double x, double y);
  void Rendered();
  ///@{
  /// A stroke, which may be a click; and whether Ctrl was held where it began.
  void StrokeBegun(double x, double y, bool hasControl);
  void StrokeMoved(double x, double y);
  void StrokeEnded(bool hadControl);
  ///@}
  /// By notches, away from the user; with Shift or Ctrl the wheel is always the style's.
  void WheelTurned(double x, double y, double notches);

protected:
  ViewHeader* Header() const { return this->Bar; }
  void SetStyle(vtkInteractorStyle* style);
  /// Sets the view that the pane draws, of `contents`, which outlive it.
  void Show(vtkLinkedView* view, const ViewContents& contents);
  bool eventFilter(QObject* object, QEvent* event) override;
  /// Before a frame is requested because something changed.
  virtual void Stir() {}
  /// Draws soon, without Stir.
  void RequestFrame();
  /// The pointer over the canvas, in its pixels from the lower left.
  QPointF PlaceOf(const QMouseEvent& mouse) const { return this->OnCanvas(PointerPlace(mouse)); }

private:
  QPointF OnCanvas(const QPointF& place) const;
  bool TakeStroke(QEvent* event);
  bool TakeWheel(const QWheelEvent& wheel);
  bool TakeMouse(QEvent* event);

  QString Title;
  ViewHeader* Bar;
  ViewCanvas* RasterImage;
  ViewBanner* Banner;
  vtkNew<vtkRenderer> Scene;
  vtkNew<vtkEventQtSlotConnect> Links; ///< to the followed objects
  vtkSmartPointer<vtkLinkedView> Shown;
  QPoint Pressed;
  bool IsPressed = false;
  bool AreStrokesOn = false;
  bool IsAccepted = false;
  bool IsStroke = false;
  bool HadControl = false;
  bool IsDue = false;
  int Drawn = 0;
};
} // namespace palpate
