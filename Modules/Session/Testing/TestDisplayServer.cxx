#include "DisplayServer.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

using palpate::DisplayServer;

namespace
{
// Sets a variable of the environment for one scope.
class Variable
{
public:
  Variable(const char* name, const char* value) : Name(name)
  {
    if (const char* former = std::getenv(name))
    {
      this->HadValue = true;
      this->Former = former;
    }
    if (value)
    {
      setenv(name, value, 1);
    }
    else
    {
      unsetenv(name);
    }
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  ~Variable()
  {
    if (this->HadValue)
    {
      setenv(this->Name, this->Former.c_str(), 1);
    }
    else
    {
      unsetenv(this->Name);
    }
  }

private:
  const char* Name;
  bool HadValue = false;
  std::string Former;
};

bool HasXvfb()
{
  try
  {
    const Variable none("DISPLAY", nullptr);
    return DisplayServer().IsPrivate();
  }
  catch (const std::runtime_error&)
  {
    return false;
  }
}

// Neither running nor left as a zombie. The display's number says nothing: another program's server
// may have taken it since.
bool HasNoChild()
{
  return waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD;
}
} // namespace

TEST(DisplayServer, WithoutADisplayAPrivateServerIsStartedAndEnded)
{
  if (!HasXvfb())
  {
    GTEST_SKIP() << "Xvfb is not installed";
  }
  const Variable none("DISPLAY", nullptr);
  {
    const DisplayServer server;
    EXPECT_TRUE(server.IsPrivate());
    EXPECT_TRUE(DisplayServer::CanReachDisplay());
    EXPECT_FALSE(HasNoChild());
  }
  EXPECT_EQ(std::getenv("DISPLAY"), nullptr);
  EXPECT_TRUE(HasNoChild());
}

// What a terminal sends is sent to a whole group.
TEST(DisplayServer, CtrlCOfATerminalDoesNotReachAPrivateServer)
{
  const Variable none("DISPLAY", nullptr);
  const pid_t child = fork();
  if (child == 0)
  {
    setpgid(0, 0);
    const DisplayServer server;
    std::signal(SIGINT, SIG_IGN);
    kill(0, SIGINT);
    kill(0, SIGINT);
    _exit(server.IsPrivate() && DisplayServer::CanReachDisplay() ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(DisplayServer, ADisplayThatDoesNotAnswerIsReplacedAndRestored)
{
  if (!HasXvfb())
  {
    GTEST_SKIP() << "Xvfb is not installed";
  }
  const Variable dead("DISPLAY", ":98765");
  {
    const DisplayServer server;
    EXPECT_TRUE(server.IsPrivate());
    EXPECT_TRUE(DisplayServer::CanReachDisplay());
  }
  EXPECT_STREQ(std::getenv("DISPLAY"), ":98765");
}

TEST(DisplayServer, ADisplayThatAnswersIsUsed)
{
  if (!HasXvfb())
  {
    GTEST_SKIP() << "Xvfb is not installed";
  }
  const Variable none("DISPLAY", nullptr);
  const DisplayServer outer;
  const DisplayServer inner;
  EXPECT_FALSE(inner.IsPrivate());
}

TEST(DisplayServer, WithoutDisplayAndXvfbTheWayOutIsNamed)
{
  const Variable none("DISPLAY", nullptr);
  const Variable nowhere("PATH", "/nonexistent");
  try
  {
    const DisplayServer server;
    FAIL() << "a server was made from nothing";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("install Xvfb"), std::string::npos);
  }
}
