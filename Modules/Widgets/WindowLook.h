#pragma once

#include <QPalette>
#include <QString>

#include <array>

namespace palpate
{
/// Whether a program is dark on light or light on dark. It is the user's, and of no study.
enum class WindowLook
{
  System, ///< as other programs are
  Light,
  Dark
};
constexpr std::array<WindowLook, 3> AllWindowLooks{
    {WindowLook::System, WindowLook::Light, WindowLook::Dark}};

/// "system", "light", "dark".
QString NameOf(WindowLook look);

/// The look's colours; those of the system's look are the system's.
QPalette PaletteOf(WindowLook look);

/// Shows the program in a look and keeps it for the next time.
void ChooseLook(WindowLook look);
/// The one that was kept; System where none was.
WindowLook ChosenLook();
} // namespace palpate
