#pragma once

#include <QPalette>
#include <QString>

#include <array>

namespace palpate
{
/// Light or dark appearance of the program. A setting of the user, not of a study.
enum class WindowLook
{
  System, ///< like other programs
  Light,
  Dark
};
constexpr std::array<WindowLook, 3> AllWindowLooks{
    {WindowLook::System, WindowLook::Light, WindowLook::Dark}};

/// "system", "light", "dark".
QString NameOf(WindowLook look);

/// The look's colours; for System, those of the system.
QPalette PaletteOf(WindowLook look);

/// Applies a look to the program and keeps it for the next start.
void ChooseLook(WindowLook look);
/// The kept look; System if none was kept.
WindowLook ChosenLook();
} // namespace palpate
