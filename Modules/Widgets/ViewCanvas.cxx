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

// VTK's widget has its first picture, and that of a new size, drawn here by the interactor; without
// it, nothing of later ones is ever seen.
void ViewCanvas::paintGL()
{
  this->interactor()->EnableRenderOn();
  QVTKOpenGLNativeWidget::paintGL();
  this->interactor()->EnableRenderOff();
}
} // namespace palpate
