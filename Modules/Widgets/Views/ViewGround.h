#pragma once

#include <array>

#include <QString>

class vtkRenderer;

namespace palpate
{
/// Background of the 3-D view. A setting of the user, not of a study.
enum class ViewGround
{
  Theme, ///< dark or light as the window is
  Dark,
  Light,
  White ///< for print
};
constexpr std::array<ViewGround, 4> AllViewGrounds{
    {ViewGround::Theme, ViewGround::Dark, ViewGround::Light, ViewGround::White}};

/// "theme", "dark", "light", "white".
QString NameOf(ViewGround ground);
/// The first one for an unknown name.
ViewGround ViewGroundOf(const QString& name);

/// Dark and light grounds become lighter upwards, as under a sky.
void Lay(ViewGround ground, bool isThemeDark, vtkRenderer* renderer);
} // namespace palpate
