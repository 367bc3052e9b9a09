#pragma once

#include <QSize>
#include <QString>
#include <QStringList>

namespace palpate
{
/// The command line of palpate-viewer.
struct ViewerOptions
{
  QStringList Files;
  bool StartsTouch = false;
  bool ShowsDemo = false;
  bool UsesCache = true; ///< see SofteningCache
  QString Screenshot;    ///< PNG file; empty for none
  QSize Size{1280, 800};

  QString Problem; ///< error message on the command line; empty if it is valid
  QString Answer;  ///< what to print instead of opening a window: help or version
};

/// The first argument is the program. Needs a QCoreApplication, whose name help prints.
ViewerOptions ParseViewerOptions(const QStringList& arguments);
} // namespace palpate
