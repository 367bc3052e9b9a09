#include "CommandRegistry.h"
#include "DeclaredCommand.h"
#include "ManualPage.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>
#include <sstream>

namespace palpate::manual_page_test
{
namespace
{
using namespace palpate::cli;

TEST(DeclaredOption, KnowsKindRangeAndDefault)
{
  CLI::App app("", "app");
  int whole = 3;
  bool flag = false;
  std::string word;
  std::vector<double> list;
  const DeclaredOption integer(*app.add_option("--whole", whole, "a number")
                                    ->type_name("N")
                                    ->check(CLI::Range(-2, 9))
                                    ->capture_default_str());
  EXPECT_EQ(integer.Type, DeclaredOption::Kind::Integer);
  EXPECT_EQ(integer.Range, (std::array{-2.0, 9.0}));
  EXPECT_EQ(integer.Default, "3");
  EXPECT_EQ(integer.Word, "N");
  EXPECT_EQ(DeclaredOption(*app.add_flag("--flag", flag)).Type, DeclaredOption::Kind::Flag);
  const DeclaredOption choice(
      *app.add_option("--choice", word)->check(CLI::IsMember({"a", "b-c"})));
  EXPECT_EQ(choice.Values, (std::vector<std::string>{"a", "b-c"}));
  EXPECT_FALSE(choice.Range);
  const DeclaredOption numbers(*app.add_option("--list", list)->delimiter(','));
  EXPECT_TRUE(numbers.IsList && numbers.IsCommaSeparated);
  EXPECT_EQ(numbers.Type, DeclaredOption::Kind::Real);
  const DeclaredOption file(
      *app.add_option("--file", word)->check(FileType::Output("geometry", ".vtp")));
  EXPECT_EQ(file.Type, DeclaredOption::Kind::File);
  EXPECT_TRUE(file.File->IsOutput);
  EXPECT_EQ(file.File->Content + file.File->Ending, "geometry.vtp");
}

TEST(ManualPage, NamesEveryOptionOfEveryCommand)
{
  CLI::App app("About", "palpate");
  const auto commands = MakeCommands();
  for (const auto& command : commands)
  {
    command->DeclareOptions(*app.add_subcommand(command->Name(), command->Summary()));
  }
  const std::string page = ManualPage(app, "1.2");
  EXPECT_NE(page.find("palpate 1.2"), std::string::npos);
  for (const DeclaredCommand& command : DeclaredCommands(app))
  {
    EXPECT_NE(page.find("\n.SS " + command.Name + "\n"), std::string::npos);
    for (const DeclaredOption& option : command.Options)
    {
      std::string name = option.IsPositional() ? option.Place : option.Names.back();
      for (std::size_t at = 0; (at = name.find('-', at)) != std::string::npos; at += 2)
      {
        name.insert(at, 1, '\\');
      }
      EXPECT_NE(page.find(name), std::string::npos) << name;
    }
  }
}

TEST(ManualPage, EscapesWhatRoffInterprets)
{
  CLI::App app("About", "palpate");
  app.add_subcommand("run", ".hidden\n'quoted \\x");
  const std::string page = ManualPage(app, "1");
  EXPECT_NE(page.find("\n\\&.hidden\n\\&'quoted \\ex."), std::string::npos) << page;
}
} // namespace
} // namespace palpate::manual_page_test
