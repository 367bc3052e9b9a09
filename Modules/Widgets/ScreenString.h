#pragma once

#include <QString>

#include <string>

namespace palpate
{
/// Text that holds names from files, on one line and without what is invisible or turns the order
/// of letters. For widgets that show plain text; labels are told so by setTextFormat.
QString ScreenString(const std::string& text);

/// The same for a tool tip, which Qt otherwise takes for HTML where it looks like that. Line breaks
/// stay.
QString PlainToolTip(const QString& text);

/// The same for a menu's entry, where & marks a key.
QString MenuString(const QString& text);

/// The same for a window's title, where [*] marks a change.
QString TitleString(const QString& text);
} // namespace palpate
