#include "DisplayTest.h"
#include "StudyFile.h"
#include "StudyPhantoms.h"

#include <QCoreApplication>
#include <QProcess>
#include <QProcessEnvironment>

#include <csignal>
#include <cstdint>
#include <fstream>
#include <gtest/gtest.h>
#include <string>

namespace palpate::viewer_ends_test
{
namespace
{
// Whether a process has its own handler for a signal.
bool Handles(qint64 process, int signal)
{
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string word; status >> word;)
  {
    std::uint64_t mask = 0;
    if (word == "SigCgt:" && status >> std::hex >> mask)
    {
      return (mask >> (signal - 1) & 1U) != 0;
    }
  }
  return false;
}

class ViewerEndsTest : public test::DisplayTest
{
protected:
  // Of those that Interruption handles; other libraries, such as UCX, handle SIGHUP before.
  static constexpr int LastHandled = SIGTTOU;
  // The window while touching, ended by a signal as soon as it handles them.
  QProcess& EndBy(int signal)
  {
    const auto session = this->Phantom.Folder / "case.palpate.json";
    WriteStudy(session, this->Phantom.State());
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("XDG_CONFIG_HOME", QString::fromStdString(this->Phantom.Folder.Path()));
    std::signal(signal, SIG_DFL); // the child would inherit an ignored signal
    std::signal(LastHandled, SIG_DFL);
    this->Viewer.setProcessEnvironment(environment);
    this->Viewer.setProcessChannelMode(QProcess::ForwardedChannels);
    this->Viewer.start(PALPATE_VIEWER, {QString::fromStdString(session), "--touch"});
    EXPECT_TRUE(this->Viewer.waitForStarted(-1));
    while (!Handles(this->Viewer.processId(), LastHandled) && !this->Viewer.waitForFinished(5))
    {
    }
    kill(static_cast<pid_t>(this->Viewer.processId()), signal);
    EXPECT_TRUE(this->Viewer.waitForFinished(-1));
    return this->Viewer;
  }

  test::StudyPhantom Phantom;
  QProcess Viewer;
};

TEST_F(ViewerEndsTest, EachSignalClosesWindowWithItsExitCode)
{
  char name[] = "ViewerTests";
  char* all[] = {name, nullptr};
  int count = 1;
  const QCoreApplication application(count, all);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP})
  {
    const QProcess& viewer = this->EndBy(signal);
    EXPECT_EQ(viewer.exitStatus(), QProcess::NormalExit) << signal;
    EXPECT_EQ(viewer.exitCode(), 128 + signal);
  }
}
} // namespace
} // namespace palpate::viewer_ends_test
