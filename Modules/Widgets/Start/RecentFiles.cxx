#include "RecentFiles.h"

#include <QSettings>

namespace palpate
{
namespace
{
constexpr int MostRecent = 10;
constexpr const char* RecentKey = "recent";
} // namespace

QStringList RecentFiles()
{
  return QSettings().value(RecentKey).toStringList();
}

void RememberRecent(const QString& file)
{
  QSettings settings;
  QStringList files = RecentFiles();
  files.removeAll(file);
  files.prepend(file);
  settings.setValue(RecentKey, QStringList(files.mid(0, MostRecent)));
}
} // namespace palpate
