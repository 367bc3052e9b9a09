#pragma once

#include <QStringList>

namespace palpate
{
/// The files that were opened or saved last, the last one first; kept by QSettings.
QStringList RecentFiles();
void RememberRecent(const QString& file);
} // namespace palpate
