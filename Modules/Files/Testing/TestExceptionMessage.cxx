#include "ExceptionMessage.h"

#include "InputError.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

namespace palpate::exception_message_test
{
namespace
{
TEST(ExceptionMessage, PassesOnOurOwnSentences)
{
  EXPECT_EQ(MessageOf(InputError("a.nrrd is empty; give another")),
            "a.nrrd is empty; give another");
  EXPECT_EQ(MessageOf(std::runtime_error("the fit failed")), "the fit failed");
}

TEST(ExceptionMessage, SaysInOwnWordsThatMemoryIsShort)
{
  const std::string told = MessageOf(std::bad_alloc());
  EXPECT_NE(told.find("not enough memory"), std::string::npos) << told;
  EXPECT_EQ(MessageOf(std::length_error("cannot create std::vector larger than max_size()")), told);
}

TEST(ExceptionMessage, KeepsTextsOfLibrariesFromUsers)
{
  EXPECT_EQ(MessageOf(std::out_of_range("vector::_M_range_check: __n")).find("_M_"),
            std::string::npos);
  EXPECT_EQ(MessageOf(std::invalid_argument("stoi")).find("stoi"), std::string::npos);
}

TEST(ExceptionMessage, NamesTheFileAndTheReasonOfTheSystem)
{
  const std::string told = MessageOf(std::filesystem::filesystem_error(
      "cannot open", "/data/a.json", std::make_error_code(std::errc::permission_denied)));
  EXPECT_EQ(told.rfind("/data/a.json cannot be used (", 0), 0U) << told;
  EXPECT_EQ(told.find("cannot open"), std::string::npos) << told;
}
} // namespace
} // namespace palpate::exception_message_test
