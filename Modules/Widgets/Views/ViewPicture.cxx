#include "ViewPicture.h"

#include "AtomicFile.h"
#include "Refusal.h"

#include "vtkCamera.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkMath.h"
#include "vtkOpenGLState.h"
#include "vtkUnsignedCharArray.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
constexpr int Gap = 2; // pixels between views

// Gives a view another size until it ends.
class ChangedView
{
public:
  ChangedView(ViewPane& pane, const QSize& size, PictureGround ground)
      : Pane(pane), Slice(qobject_cast<SlicePane*>(&pane)), Space(qobject_cast<SpacePane*>(&pane)),
        Window(vtkGenericOpenGLRenderWindow::SafeDownCast(pane.Canvas()->renderWindow()))
  {
    // One that was never shown has nothing to draw on before this.
    if (!pane.Canvas()->isValid())
    {
      pane.Canvas()->grabFramebuffer();
    }
    this->Points = this->Window->GetDPI();
    std::copy_n(this->Window->GetSize(), 2, this->Size.begin());
    const QSize shown = pane.isVisible() ? QSize(this->Size[0], this->Size[1]) : size;
    const double across = static_cast<double>(size.width()) / std::max(1, shown.width());
    const double down = static_cast<double>(size.height()) / std::max(1, shown.height());
    this->Window->SetSize(size.width(), size.height());
    this->Window->SetDPI(
        std::max(1, static_cast<int>(std::lround(std::min(across, down) * this->Points))));
    // A view keeps its height; in a narrower one everything becomes smaller.
    this->Zoomed = std::min(1.0, across / down);
    this->Zoom(this->Zoomed);
    this->Look(ground);
  }
  ~ChangedView()
  {
    this->Zoom(1.0 / this->Zoomed);
    vtkRenderer* renderer = this->Pane.Renderer();
    renderer->SetBackground(this->Ground.data());
    renderer->SetGradientBackground(this->WasGraded);
    if (this->Space != nullptr)
    {
      this->Space->View()->SetAntialiasing(this->WasSmooth);
      this->Space->View()->SetMoving(this->WasMoving);
    }
    else
    {
      this->Slice->View()->TitleVisibilityOff();
    }
    this->Window->SetDPI(this->Points);
    this->Window->SetSize(this->Size[0], this->Size[1]);
    this->Pane.Settle();
  }
  ChangedView(const ChangedView&) = delete;
  ChangedView& operator=(const ChangedView&) = delete;

  vtkGenericOpenGLRenderWindow* Canvas() const { return this->Window; }

private:
  void Look(PictureGround ground)
  {
    vtkRenderer* renderer = this->Pane.Renderer();
    std::copy_n(renderer->GetBackground(), 3, this->Ground.begin());
    this->WasGraded = renderer->GetGradientBackground();
    if (ground != PictureGround::AsShown)
    {
      const double grey = ground == PictureGround::White ? 1.0 : 0.0;
      renderer->SetBackground(grey, grey, grey);
      renderer->GradientBackgroundOff();
    }
    if (this->Space != nullptr)
    {
      this->WasSmooth = this->Space->View()->GetAntialiasing();
      this->WasMoving = this->Space->View()->GetMoving();
      this->Space->View()->AntialiasingOn();
      this->Space->View()->MovingOff();
    }
    else
    {
      this->Slice->View()->TitleVisibilityOn();
    }
  }
  // Around the view's centre.
  void Zoom(double factor)
  {
    if (this->Slice != nullptr)
    {
      const int* size = this->Window->GetSize();
      this->Slice->View()->Zoom(factor, 0.5 * (size[0] - 1), 0.5 * (size[1] - 1));
      return;
    }
    vtkCamera* camera = this->Pane.Renderer()->GetActiveCamera();
    const double half = vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle());
    camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(std::tan(half) / factor)));
    camera->SetParallelScale(camera->GetParallelScale() / factor);
  }

  ViewPane& Pane;
  SlicePane* Slice;
  SpacePane* Space;
  vtkGenericOpenGLRenderWindow* Window;
  int Points = 0; // per inch
  std::array<int, 2> Size{};
  double Zoomed = 1.0;
  std::array<double, 3> Ground{};
  bool WasGraded = false;
  bool WasSmooth = false;
  bool WasMoving = false;
};
} // namespace

QImage PictureOf(ViewPane& pane, const QSize& size, PictureGround ground)
{
  const ChangedView changed(pane, size, ground);
  vtkGenericOpenGLRenderWindow* window = changed.Canvas();
  window->Render();
  // Qt has bound its own buffer, which VTK does not notice.
  window->GetState()->ResetFramebufferBindings();
  vtkNew<vtkUnsignedCharArray> pixels;
  const int right = size.width() - 1;
  const int top = size.height() - 1;
  constexpr int Back = 0;
  constexpr int Mono = 0;
  const bool isTransparent = ground == PictureGround::Transparent;
  if (isTransparent)
  {
    window->GetRGBACharPixelData(0, 0, right, top, Back, pixels.Get(), Mono);
  }
  else
  {
    window->GetPixelData(0, 0, right, top, Back, pixels.Get(), Mono);
  }
  const auto format = isTransparent ? QImage::Format_RGBA8888_Premultiplied : QImage::Format_RGB888;
  const int rowBytes = pixels->GetNumberOfComponents() * size.width();
  // VTK's rows begin at the bottom.
  return QImage(pixels->GetPointer(0), size.width(), size.height(), rowBytes, format).mirrored();
}

QImage PictureOf(const ViewGrid& views, const QSize& size, PictureGround ground)
{
  const int left = std::max(1, (size.width() - Gap) / 2);
  const int top = std::max(1, (size.height() - Gap) / 2);
  const int right = std::max(1, size.width() - Gap - left);
  const int bottom = std::max(1, size.height() - Gap - top);
  const std::array<std::pair<ViewPane*, QRect>, 4> places{
      {{views.Slice(SliceOrientation::Axial), {0, 0, left, top}},
       {views.Space(), {left + Gap, 0, right, top}},
       {views.Slice(SliceOrientation::Coronal), {0, top + Gap, left, bottom}},
       {views.Slice(SliceOrientation::Sagittal), {left + Gap, top + Gap, right, bottom}}}};
  const bool isTransparent = ground == PictureGround::Transparent;
  QImage all(size, isTransparent ? QImage::Format_RGBA8888_Premultiplied : QImage::Format_RGB888);
  all.fill(isTransparent ? Qt::transparent : Qt::darkGray);
  QPainter painter(&all);
  for (const auto& [pane, place] : places)
  {
    painter.drawImage(place, PictureOf(*pane, place.size(), ground));
  }
  return all;
}

QImage PictureOf(const ViewGrid& views, QWidget& window)
{
  for (ViewPane* pane : views.Panes())
  {
    pane->Settle();
  }
  return window.grab().toImage();
}

void WritePicture(const QImage& picture, const std::filesystem::path& file)
{
  AtomicFile output(file);
  if (!picture.save(QString::fromStdString(output.TemporaryPath().string()), "PNG"))
  {
    Refuse(file, "cannot be written", "choose a smaller picture, or a disk with more space");
  }
  output.Commit();
}
} // namespace palpate
