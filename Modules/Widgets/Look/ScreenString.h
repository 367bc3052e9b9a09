#pragma once

#include <QString>

#include <string>

namespace palpate
{
/// Text with names from files, on one line, without invisible characters or ones that change the
/// text direction. For widgets that show plain text; set labels to that by setTextFormat.
QString ScreenString(const std::string& text);

/// The same for a tool tip, which Qt would otherwise interpret as HTML if it looks like that. Keeps
/// line breaks.
QString PlainToolTip(const QString& text);

/// The same for a menu entry, in which & marks a key.
QString MenuString(const QString& text);

/// The same for a window title, in which [*] marks a change.
QString TitleString(const QString& text);
} // namespace palpate
