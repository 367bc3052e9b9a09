#include "DrillScript.h"

#include "InputError.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

#include <gtest/gtest.h>

namespace palpate::drill_script_test
{
namespace
{
class DrillScript : public testing::Test
{
protected:
  std::vector<DrillAction> Read(const std::string& text)
  {
    WriteWholeFile(this->Path, text);
    return ReadDrillScript(this->Path);
  }
  std::string Refusal(const std::string& text)
  {
    try
    {
      this->Read(text);
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return {};
  }
  static std::string Of(const std::string& actions)
  {
    return R"({"format": "palpate-drill", "actions": [)" + actions + "]}";
  }

  test::TemporaryFolder Folder;
  std::filesystem::path Path = Folder / "drill.json";
};

TEST_F(DrillScript, ReadsEveryAction)
{
  const auto actions = this->Read(Of(R"({"time_s": 0.5, "do": "start"}, {"time_s": 1, "do": "stop"},
    {"time_s": 1, "do": "end-stroke"}, {"time_s": 2, "do": "undo"}, {"time_s": 3, "do": "redo"},
    {"time_s": 4, "do": "reset"})"));
  ASSERT_EQ(actions.size(), 6u);
  EXPECT_EQ(actions[0].Time, 0.5);
  const DrillCommand commands[] = {DrillCommand::None, DrillCommand::None, DrillCommand::EndStroke,
                                   DrillCommand::Undo, DrillCommand::Redo, DrillCommand::Reset};
  for (std::size_t n = 0; n < actions.size(); ++n)
  {
    EXPECT_EQ(static_cast<int>(actions[n].Do), static_cast<int>(n));
    EXPECT_EQ(CommandOf(actions[n].Do), commands[n]);
  }
}

TEST_F(DrillScript, RejectsMalformedScripts)
{
  for (const std::string& text :
       {std::string("{"), std::string("[]"), std::string(R"({"format": "palpate-scene"})"),
        std::string(R"({"format": "palpate-drill"})"), Of(""), Of("7"), Of(R"({"time_s": 1})"),
        Of(R"({"time_s": -1, "do": "start"})"), Of(R"({"time_s": 1, "do": "dance"})"),
        Of(R"({"time_s": 1, "do": "start", "why": 1})"),
        Of(R"({"time_s": 2, "do": "start"}, {"time_s": 1, "do": "stop"})")})
  {
    const std::string refusal = this->Refusal(text);
    EXPECT_EQ(refusal.find(this->Path.string()), 0u) << text << ": " << refusal;
    EXPECT_EQ(refusal.back(), '.');
  }
}
} // namespace
} // namespace palpate::drill_script_test
