#include "OpenGLDriver.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include <algorithm>
#include <array>

namespace palpate
{
QString OpenGLDriver()
{
  QOffscreenSurface surface;
  surface.create();
  QOpenGLContext context;
  if (!context.create() || !context.makeCurrent(&surface))
  {
    return {};
  }
  const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
  return QString::fromLatin1(name);
}

bool IsGraphicsCard(const QString& driver)
{
  constexpr std::array<const char*, 6> Software{
      {"llvmpipe", "softpipe", "swrast", "swiftshader", "software", "gdi generic"}};
  return !driver.isEmpty() && std::none_of(Software.begin(), Software.end(),
                                           [&driver](const char* name)
                                           { return driver.contains(name, Qt::CaseInsensitive); });
}
} // namespace palpate
