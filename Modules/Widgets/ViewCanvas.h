#pragma once

#include <QVTKOpenGLNativeWidget.h>

namespace palpate
{
/// Where VTK draws in a window. Its interactor draws only when Qt paints: a style that asks for a
/// picture at each move of the mouse gets none at once, but a RenderEvent.
class ViewCanvas : public QVTKOpenGLNativeWidget
{
public:
  explicit ViewCanvas(QWidget* parent);

protected:
  void paintGL() override;
};
} // namespace palpate
