#pragma once

#include <QIcon>

namespace palpate
{
/// What a button of the toolbar does, or a column holds.
enum class ToolSign
{
  Open,
  Save,
  Layout,
  WindowLevel,
  Fit,
  Landmark,
  Draw,
  Pull,
  Match,
  Screenshot,
  Touch,
  Record,
  Recording, ///< red
  Eye
};

/// Lines in the colour of the palette's text, so that they follow light and dark, at any size.
QIcon ToolIcon(ToolSign sign);
} // namespace palpate
