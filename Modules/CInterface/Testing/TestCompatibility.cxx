#include "ErrorText.h"
#include "palpate.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cstddef>
#include <dlfcn.h>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
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

// The names before an opening parenthesis that begin like the interface's functions.
std::set<std::string> FunctionsIn(const std::string& header)
{
  const auto isOfName = [](char c)
  { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  std::set<std::string> names;
  for (std::size_t end = header.find('('); end != std::string::npos;
       end = header.find('(', end + 1))
  {
    std::size_t begin = end;
    while (begin > 0 && isOfName(header[begin - 1]))
    {
      --begin;
    }
    const std::string name = header.substr(begin, end - begin);
    if (name.rfind("palpate_", 0) == 0)
    {
      names.insert(name);
    }
  }
  return names;
}

// Change the version with the list: programs were compiled against these.
TEST(CInterface, FunctionsAreThoseOfItsVersion)
{
  std::istringstream listed(
      TextOf("Testing/functions-" + std::to_string(PALPATE_API_VERSION) + ".txt"));
  const std::set<std::string> wanted{std::istream_iterator<std::string>(listed), {}};
  const std::set<std::string> declared =
      FunctionsIn(TextOf("palpate.h") + TextOf("palpate_shape.h"));
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
  EXPECT_EQ(sizeof(palpate_evaluation), 64U);
  EXPECT_EQ(sizeof(palpate_body), 136U);
  EXPECT_EQ(sizeof(palpate_law), 32U);
  EXPECT_EQ(sizeof(palpate_contact), 88U);
  EXPECT_EQ(sizeof(palpate_state), 136U);
  EXPECT_EQ(sizeof(palpate_term), 32U);
  EXPECT_EQ(sizeof(palpate_multivariate), 160U);
  EXPECT_EQ(sizeof(palpate_section), 80U);
  EXPECT_EQ(sizeof(palpate_motion), 40U);
  EXPECT_EQ(sizeof(palpate_registration), 168U);
  EXPECT_EQ(sizeof(palpate_verdict), 72U);
  EXPECT_EQ(sizeof(palpate_rule), 56U);
  EXPECT_EQ(sizeof(palpate_mixed), 88U);
  EXPECT_EQ(sizeof(palpate_asymmetry), 120U);
  EXPECT_EQ(sizeof(palpate_pull), 80U);
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
