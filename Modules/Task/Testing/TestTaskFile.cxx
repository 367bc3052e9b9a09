#include "InputError.h"
#include "MessageOf.h"
#include "TaskCases.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>

namespace palpate::task_file_test
{
namespace
{
using namespace palpate::test;
using Json = nlohmann::json;

constexpr std::array<TaskKind, 6> Kinds{{TaskKind::Nodule, TaskKind::Landmarks, TaskKind::Outline,
                                         TaskKind::Mask, TaskKind::Dock, TaskKind::Path}};

class TaskFileTest : public testing::Test
{
protected:
  Json TextOf(TaskKind kind) const
  {
    return Json::parse(TaskText(TaskOf(kind), this->Folder.Path()));
  }
  TaskSettings Read(const Json& json) const { return this->Read(json.dump()); }
  TaskSettings Read(const std::string& text) const
  {
    WriteAll(this->Folder / "task.json", text);
    return ReadTask(this->Folder / "task.json");
  }
  void ExpectRefused(const Json& json, const std::string& word) const
  {
    const std::string message = MessageOf([&] { this->Read(json); });
    EXPECT_NE(message.find(word), std::string::npos) << message;
    EXPECT_NE(message.find("task.json"), std::string::npos) << message;
    EXPECT_EQ(message.back(), '.') << message;
  }

  TemporaryFolder Folder;
};

TEST_F(TaskFileTest, ReadsWhatItWrites)
{
  for (const TaskKind kind : Kinds)
  {
    const TaskSettings task = this->Read(this->TextOf(kind));
    EXPECT_EQ(task.Kind, kind);
    EXPECT_EQ(TaskText(task, this->Folder.Path()), TaskText(TaskOf(kind), this->Folder.Path()));
    EXPECT_EQ(TaskDigest(task), TaskDigest(TaskOf(kind)));
  }
}

TEST_F(TaskFileTest, DigestNoticesEveryNumber)
{
  const std::string before = TaskDigest(TaskOf(TaskKind::Landmarks));
  TaskSettings task = TaskOf(TaskKind::Landmarks);
  task.Targets[1].Points[1].PointWorld[2] += 1e-9;
  EXPECT_NE(TaskDigest(task), before);
  task = TaskOf(TaskKind::Landmarks);
  task.Conditions[1].HasForce = true;
  EXPECT_NE(TaskDigest(task), before);
}

TEST_F(TaskFileTest, IsRecordedUnlessItSaysOtherwise)
{
  TaskSettings task = TaskOf(TaskKind::Landmarks);
  const std::filesystem::path folder = std::filesystem::current_path();
  EXPECT_EQ(TaskText(task, folder).find("record"), std::string::npos) << "as earlier digests";
  task.IsRecorded = false;
  EXPECT_NE(TaskText(task, folder).find("\"record\": false"), std::string::npos);
  EXPECT_NE(TaskDigest(task), TaskDigest(TaskOf(TaskKind::Landmarks)));
}

TEST_F(TaskFileTest, RefusesQuestionsAboutIdentity)
{
  for (const char* text : {"Name", "What is your last name?", "first_name", "your e-mail",
                           "Initials:", "date of BIRTH", "patient number", "Phone"})
  {
    Json json = this->TextOf(TaskKind::Landmarks);
    json["ask"][0]["text"] = text;
    this->ExpectRefused(json, "no names are stored");
  }
  for (const char* key : {"name", "sur_name", "e-mail", "FirstName_name"})
  {
    EXPECT_TRUE(AsksForIdentity(key)) << key;
  }
  for (const char* key : {"years", "hand", "experience with renamed files", "filename", ""})
  {
    EXPECT_FALSE(AsksForIdentity(key)) << key;
  }
}

TEST_F(TaskFileTest, RefusesContradictions)
{
  Json json = this->TextOf(TaskKind::Landmarks);
  json["conditions"][1]["id"] = "force";
  this->ExpectRefused(json, "two \"conditions\" named force");
  json = this->TextOf(TaskKind::Landmarks);
  json["conditions"] = Json::array();
  this->ExpectRefused(json, "0 \"conditions\"");
  json = this->TextOf(TaskKind::Landmarks);
  for (Json& target : json["targets"])
  {
    target["training"] = true;
  }
  this->ExpectRefused(json, "training");
  json = this->TextOf(TaskKind::Outline);
  json["targets"][0]["points"][5]["at_mm"][2] = 4.0;
  this->ExpectRefused(json, "no flat outline");
  json = this->TextOf(TaskKind::Path);
  json["targets"][0]["points"].erase(json["targets"][0]["points"].begin() + 1,
                                     json["targets"][0]["points"].end());
  this->ExpectRefused(json, "1 \"points\"");
  json = this->TextOf(TaskKind::Nodule);
  json["targets"][0].erase("points");
  this->ExpectRefused(json, "diameter_mm");
  json = this->TextOf(TaskKind::Nodule);
  json["targets"][0]["side"] = {0, 2e-1, 0};
  this->ExpectRefused(json, "side");
}

TEST_F(TaskFileTest, RefusesUnknownAndBadEntries)
{
  const std::vector<std::pair<const char*, Json>> bad{{"version", 2},
                                                      {"kind", "juggle"},
                                                      {"id", "../a"},
                                                      {"id", ""},
                                                      {"trials", 0},
                                                      {"trials", 1.5},
                                                      {"trials", 1e9},
                                                      {"most_seconds", -1},
                                                      {"conditions", "force"},
                                                      {"targets", {1, 2, 3}},
                                                      {"format", "palpate-scene"},
                                                      {"surprise", 1}};
  for (const auto& [key, value] : bad)
  {
    Json json = this->TextOf(TaskKind::Landmarks);
    json[key] = value;
    EXPECT_THROW(this->Read(json), InputError) << key << value;
  }
  for (const char* key : {"kind", "id", "format", "targets"})
  {
    Json json = this->TextOf(TaskKind::Landmarks);
    json.erase(key);
    EXPECT_THROW(this->Read(json), InputError) << key;
  }
}

// Nothing but a refusal comes of any damage.
TEST_F(TaskFileTest, DamagedFilesAreReadOrRefused)
{
  std::mt19937 random(1);
  int refused = 0;
  for (int i = 0; i < 300; ++i)
  {
    std::string text = this->TextOf(Kinds.at(static_cast<std::size_t>(i) % 6)).dump();
    for (int change = 0; change < 3; ++change)
    {
      text[random() % text.size()] = "0-{}[]\",:eE9 \x80"[random() % 14];
    }
    try
    {
      this->Read(text);
    }
    catch (const InputError&)
    {
      ++refused;
    }
  }
  EXPECT_GT(refused, 150);
}
} // namespace
} // namespace palpate::task_file_test
