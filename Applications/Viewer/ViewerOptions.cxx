#include "ViewerOptions.h"

#include "SampleData.h"

#include <QCommandLineParser>
#include <QRegularExpression>

namespace palpate
{
namespace
{

constexpr int LargestSide = 16384; // of an OpenGL window

// Empty for an invalid size.
QSize SizeOf(const QString& text)
{
  const auto match = QRegularExpression("^(\\d{2,5})x(\\d{2,5})$").match(text);
  const QSize size(match.captured(1).toInt(), match.captured(2).toInt());
  return match.hasMatch() && size.boundedTo({LargestSide, LargestSide}) == size ? size : QSize();
}
} // namespace

ViewerOptions ParseViewerOptions(const QStringList& arguments)
{
  QCommandLineParser parser;
  parser.setApplicationDescription(
      "Opens volumes, segmentations and studies (.palpate.json) for display and touch.");
  const QCommandLineOption help = parser.addHelpOption();
  const QCommandLineOption version = parser.addVersionOption();
  const QCommandLineOption touch("touch", "Starts touching as soon as a structure is ready.");
  const QCommandLineOption demo("demo", "Opens the Colin 27 head of Debian's mricron-data.");
  const QCommandLineOption image(
      "screenshot", "Writes a screenshot of the window when everything is ready, and exits.",
      "file.png");
  const QCommandLineOption noCache(
      "no-cache",
      "Neither reads nor keeps results in the user's cache folder (organs that yield).");
  const QCommandLineOption size("size", "Size of the window in pixels.", "WxH", "1280x800");
  parser.addOptions({touch, demo, noCache, image, size});
  parser.addPositionalArgument("files", "Files to open; their kinds are detected.", "[files...]");
  ViewerOptions options;
  if (!parser.parse(arguments))
  {
    options.Problem = parser.errorText();
    return options;
  }
  options.Answer = parser.isSet(help) ? parser.helpText() : QString();
  options.Answer = parser.isSet(version) ? "palpate-viewer " PALPATE_VERSION "\n" : options.Answer;
  options.Files = parser.positionalArguments();
  options.StartsTouch = parser.isSet(touch);
  options.ShowsDemo = parser.isSet(demo);
  options.UsesCache = !parser.isSet(noCache);
  options.Screenshot = parser.value(image);
  options.Size = SizeOf(parser.value(size));
  if (options.Size.isEmpty())
  {
    options.Problem = parser.value(size) + " is not a size; write it as 1280x800";
  }
  if (options.ShowsDemo)
  {
    options.Files = SampleData::Head().Files + options.Files;
  }
  return options;
}
} // namespace palpate
