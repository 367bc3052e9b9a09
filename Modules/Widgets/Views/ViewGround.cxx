#include "ViewGround.h"

#include "vtkRenderer.h"

#include <cstddef>

namespace palpate
{
QString NameOf(ViewGround ground)
{
  constexpr std::array<const char*, 4> Names{"theme", "dark", "light", "white"};
  return Names.at(static_cast<std::size_t>(ground));
}

ViewGround ViewGroundOf(const QString& name)
{
  for (const ViewGround ground : AllViewGrounds)
  {
    if (name == NameOf(ground))
    {
      return ground;
    }
  }
  return ViewGround::Theme;
}

void Lay(ViewGround ground, bool isThemeDark, vtkRenderer* renderer)
{
  if (ground == ViewGround::Theme)
  {
    ground = isThemeDark ? ViewGround::Dark : ViewGround::Light;
  }
  renderer->SetGradientBackground(ground != ViewGround::White);
  if (ground == ViewGround::Dark)
  {
    renderer->SetBackground(0.08, 0.09, 0.11);
    renderer->SetBackground2(0.27, 0.30, 0.35);
  }
  else if (ground == ViewGround::Light)
  {
    renderer->SetBackground(0.76, 0.79, 0.83);
    renderer->SetBackground2(0.95, 0.96, 0.97);
  }
  else
  {
    renderer->SetBackground(1.0, 1.0, 1.0);
  }
}
} // namespace palpate
