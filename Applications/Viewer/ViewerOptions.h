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
  QString Screenshot; ///< PNG file; empty for none
  QSize Size{1280, 800};

  QString Problem; ///< a sentence where the command line is wrong; empty without
  QString Answer;  ///< what to print instead of opening a window: help or version
};

/// The first argument is the program. Needs a QCoreApplication, whose name help tells.
ViewerOptions ParseViewerOptions(const QStringList& arguments);
} // namespace palpate
