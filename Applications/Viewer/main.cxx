#include "Application.h"
#include "DisplayCheck.h"
#include "ExceptionMessage.h"
#include "Interruption.h"
#include "ScreenText.h"
#include "SofteningCache.h"
#include "SteadyClock.h"
#include "ViewerOptions.h"
#include "ViewerRun.h"

#include <QSurfaceFormat>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

namespace
{
int Run(int argc, char* argv[], const palpate::ViewerOptions& options)
{
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0) // later versions always do
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
  QApplication::setApplicationName("palpate-viewer");
  QApplication::setOrganizationName("Palpate");
  const palpate::Application application(argc, argv);
  palpate::SteadyClock clock;
  palpate::StudyController study(clock);
  palpate::MainWindow window(study);
  window.resize(options.Size);
  window.show();
  // A program that only takes a picture changes nothing.
  palpate::RecoveryLink* recovery = options.Screenshot.isEmpty()
                                        ? window.KeepRecovery(palpate::RecoveryLink::UserFolder())
                                        : nullptr;
  const palpate::ViewerRun run(study, window, options);
  const int code = QApplication::exec();
  if (recovery != nullptr)
  {
    recovery->End(code == 0); // a signal ends it without a question to the user
  }
  if (!study.HasEnded() && !study.Close())
  {
    // Some work does not react to cancellation; do not wait for it.
    std::_Exit(code);
  }
  return code;
}
} // namespace

int main(int argc, char* argv[])
{
  const palpate::ViewerOptions options = [&]
  {
    // An application without windows, since none may be needed.
    const QCoreApplication parsing(argc, argv);
    return palpate::ParseViewerOptions(QCoreApplication::arguments());
  }();
  if (!options.Problem.isEmpty())
  {
    std::cerr << palpate::Printable(options.Problem.toStdString()) << '\n';
    return 2;
  }
  if (!options.Answer.isEmpty())
  {
    std::cout << options.Answer.toStdString();
    return 0;
  }
  try
  {
    palpate::RequireDisplay();
    // A closed terminal must not close the window.
    std::signal(SIGPIPE, SIG_IGN);
    // A file that exceeds a size limit gives a message, as on a full disk.
    std::signal(SIGXFSZ, SIG_IGN);
    const palpate::Interruption interruption;
    if (options.UsesCache)
    {
      palpate::SofteningCache::UseInProcess(palpate::SofteningCache::UserFolder());
    }
    return Run(argc, argv, options);
  }
  catch (const std::exception& error)
  {
    std::cerr << palpate::Printable(palpate::MessageOf(error)) << '\n';
    return 1;
  }
}
