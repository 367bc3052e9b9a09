#include "ErrorText.h"
#include "palpate.h"

#include <gtest/gtest.h>

#include <dlfcn.h>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

namespace palpate::compatibility_test
{
namespace
{
std::string TextOf(const std::string& file)
{
  std::ifstream in(PALPATE_C_INTERFACE "/" + file);
  EXPECT_TRUE(in.good()) << file;
  return {std::istreambuf_iterator<char>(in), {}};
}

// Change the version with the list: programs were compiled against these.
TEST(CInterface, FunctionsAreThoseOfItsVersion)
{
  const std::string listed =
      TextOf("Testing/functions-" + std::to_string(PALPATE_API_VERSION) + ".txt");
  std::set<std::string> wanted;
  const std::regex line("\\w+");
  for (std::sregex_iterator i(listed.begin(), listed.end(), line), end; i != end; ++i)
  {
    wanted.insert(i->str());
  }
  std::set<std::string> declared;
  const std::string header = TextOf("palpate.h");
  const std::regex call("\\b(palpate_\\w+)\\(");
  for (std::sregex_iterator i(header.begin(), header.end(), call), end; i != end; ++i)
  {
    declared.insert((*i)[1].str());
  }
  EXPECT_EQ(declared, wanted);
  for (const std::string& name : declared)
  {
    EXPECT_NE(dlsym(RTLD_DEFAULT, name.c_str()), nullptr) << name;
  }
  EXPECT_EQ(palpate_api_version(), PALPATE_API_VERSION);
}

TEST(CInterface, StructuresHaveTheSizesOfItsVersion)
{
  EXPECT_EQ(sizeof(palpate_error), 512U);
  EXPECT_EQ(sizeof(palpate_law), 32U);
  EXPECT_EQ(sizeof(palpate_contact), 88U);
  EXPECT_EQ(sizeof(palpate_state), 136U);
}

TEST(CInterface, LongMessagesEndAtACharacter)
{
  std::string message(510, 'x');
  message += "\u00e9\u00e9"; // two bytes each
  palpate_error error;
  SetError(&error, message);
  EXPECT_EQ(std::string(error.text), std::string(510, 'x'));
  SetError(nullptr, message);
}
} // namespace
} // namespace palpate::compatibility_test
