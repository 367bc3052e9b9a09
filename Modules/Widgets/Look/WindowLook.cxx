#include "WindowLook.h"

#include <QApplication>
#include <QSettings>

namespace palpate
{
namespace
{
constexpr const char* LookKey = "look";

struct LookColors
{
  const char* Window;
  const char* Base;
  const char* Alternate;
  const char* Button;
  const char* Text;
  const char* Faint; ///< disabled and placeholder text
  const char* Highlight;
  const char* Link;
};
constexpr LookColors Light{"#f0f0f0", "#ffffff", "#f5f5f5", "#e8e8e8",
                           "#1a1a1a", "#7a7a7a", "#1f6fb2", "#0b5ea8"};
constexpr LookColors Dark{"#2b2b2b", "#1e1e1e", "#262626", "#3a3a3a",
                          "#e6e6e6", "#8c8c8c", "#1f6fb2", "#6cb4ee"};

QPalette MakePalette(const LookColors& colors)
{
  // Edges and shadows are derived from button and window.
  QPalette palette(QColor(colors.Button), QColor(colors.Window));
  const QColor text(colors.Text);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                                         QPalette::ToolTipText, QPalette::BrightText})
  {
    palette.setColor(role, text);
    palette.setColor(QPalette::Disabled, role, QColor(colors.Faint));
  }
  palette.setColor(QPalette::Base, QColor(colors.Base));
  palette.setColor(QPalette::AlternateBase, QColor(colors.Alternate));
  palette.setColor(QPalette::ToolTipBase, QColor(colors.Base));
  palette.setColor(QPalette::PlaceholderText, QColor(colors.Faint));
  palette.setColor(QPalette::Highlight, QColor(colors.Highlight));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, QColor(colors.Link));
  palette.setColor(QPalette::LinkVisited, QColor(colors.Link));
  return palette;
}
} // namespace

QString NameOf(WindowLook look)
{
  constexpr std::array<const char*, 3> Names{"system", "light", "dark"};
  return Names.at(static_cast<std::size_t>(look));
}

QPalette PaletteOf(WindowLook look)
{
  switch (look)
  {
  case WindowLook::Light:
    return MakePalette(Light);
  case WindowLook::Dark:
    return MakePalette(Dark);
  case WindowLook::System:
    break;
  }
  return {}; // restores the system's palette
}

void ChooseLook(WindowLook look)
{
  QSettings().setValue(LookKey, NameOf(look));
  QApplication::setPalette(PaletteOf(look));
}

WindowLook ChosenLook()
{
  const QString kept = QSettings().value(LookKey).toString();
  for (const WindowLook look : AllWindowLooks)
  {
    if (kept == NameOf(look))
    {
      return look;
    }
  }
  return WindowLook::System;
}
} // namespace palpate
