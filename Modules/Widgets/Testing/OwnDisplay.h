#pragma once

#include <QProcess>

#include <csignal>
#include <sys/prctl.h>

namespace palpate::test
{
/// An X server for this process alone: of programs that share one, each takes the focus of the
/// others, which lifts their hands. Without Xvfb, the display stays that of the environment.
class OwnDisplay
{
public:
  OwnDisplay()
  {
    this->Server.start("Xvfb", {"-displayfd", "1", "-screen", "0", "1280x1024x24", "-noreset",
                                "-nolisten", "tcp"});
    QByteArray number;
    while (!number.endsWith('\n') && this->Server.waitForReadyRead())
    {
      number += this->Server.readAllStandardOutput();
    }
    if (number.endsWith('\n'))
    {
      qputenv("DISPLAY", ":" + number.trimmed());
      qunsetenv("XAUTHORITY"); // of the former display
    }
  }
  ~OwnDisplay()
  {
    this->Server.kill();
    this->Server.waitForFinished();
  }
  OwnDisplay(const OwnDisplay&) = delete;
  OwnDisplay& operator=(const OwnDisplay&) = delete;

private:
  struct EndsWithThisProcess : QProcess
  {
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
    void setupChildProcess() override
    {
      EndsWithThisProcess::AskForTheEnd();
    }
#else
    EndsWithThisProcess()
    {
      this->setChildProcessModifier(&EndsWithThisProcess::AskForTheEnd);
    }
#endif
    static void AskForTheEnd()
    {
      prctl(PR_SET_PDEATHSIG, SIGTERM);
    }
  };

  EndsWithThisProcess Server;
};
} // namespace palpate::test
