#include "ViewCanvas.h"

#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"

namespace palpate
{
ViewCanvas::ViewCanvas(QWidget* parent) : QVTKOpenGLNativeWidget(parent)
{
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  this->setRenderWindow(window);
  this->interactor()->EnableRenderOff();
  this->setMouseTracking(true);
  this->setFocusPolicy(Qt::StrongFocus);
}

// VTK's widget expects the interactor to draw the first frame, and that of a new size, here;
// otherwise later ones are never shown.
void ViewCanvas::paintGL()
{
  this->interactor()->EnableRenderOn();
  QVTKOpenGLNativeWidget::paintGL();
  this->interactor()->EnableRenderOff();
}
} // namespace palpate
