#include "DisplayCheck.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <optional>
#include <stdexcept>
#include <string>

namespace palpate::display_check_test
{
namespace
{
class DisplayCheck : public testing::Test
{
protected:
  DisplayCheck()
  {
    if (const char* name = std::getenv("DISPLAY"))
    {
      this->Former = name;
    }
  }
  ~DisplayCheck() override
  {
    unsetenv("DISPLAY");
    if (this->Former)
    {
      setenv("DISPLAY", this->Former->c_str(), 1);
    }
  }
  static std::string Message()
  {
    try
    {
      RequireDisplay();
      return {};
    }
    catch (const std::runtime_error& error)
    {
      return error.what();
    }
  }

private:
  std::optional<std::string> Former;
};

TEST_F(DisplayCheck, AcceptsTestDisplay)
{
  EXPECT_EQ(Message(), "");
}

TEST_F(DisplayCheck, MissingDisplayGivesFix)
{
  unsetenv("DISPLAY");
  EXPECT_NE(Message().find("xvfb-run -a"), std::string::npos) << Message();
  setenv("DISPLAY", "", 1);
  EXPECT_NE(Message().find("xvfb-run -a"), std::string::npos) << Message();
}

TEST_F(DisplayCheck, NamesUnresponsiveDisplay)
{
  setenv("DISPLAY", ":98765", 1);
  EXPECT_NE(Message().find("DISPLAY=:98765 does not answer"), std::string::npos) << Message();
}
} // namespace
} // namespace palpate::display_check_test
