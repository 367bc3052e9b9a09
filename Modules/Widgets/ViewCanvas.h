#pragma once

#include <QVTKOpenGLNativeWidget.h>

namespace palpate
{
/// VTK's canvas in a window. Its interactor draws only when Qt paints: a style that asks to render
/// at each mouse move triggers only a RenderEvent.
class ViewCanvas : public QVTKOpenGLNativeWidget
{
public:
  explicit ViewCanvas(QWidget* parent);

protected:
  void paintGL() override;
};
} // namespace palpate
