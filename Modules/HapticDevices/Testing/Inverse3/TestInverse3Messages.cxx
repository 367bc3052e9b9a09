#include "Inverse3Messages.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <random>

namespace palpate::inverse3_messages_test
{
namespace
{
using Json = nlohmann::json;

// The example of docs.haply.co (realtime/websocket-protocol), with other numbers.
const char* const Inventory = R"({"session_id": 7, "inverse3": [{"device_id": "049D",
  "config": {"type": "inverse3", "preset": "defaults", "basis": {"permutation": "XYZ"}},
  "state": {"cursor_position": {"x": 0.01, "y": -0.12, "z": 0.15},
            "current_cursor_force": {"x": 0.5, "y": 1.0, "z": 2.0},
            "body_orientation": {"w": 1.0, "x": 0, "y": 0, "z": 0}, "control_mode": "idle"}}],
  "wireless_verse_grip": [{"device_id": "61576",
  "state": {"orientation": {"x": 0.0, "y": 0.0, "z": 0.6, "w": 0.8},
            "buttons": {"a": true, "b": false, "c": true}}}]})";

TEST(Inverse3Messages, StateIsReadInThisProgramsFrame)
{
  const auto frame = ReadInverse3Frame(Inventory, "");
  ASSERT_TRUE(frame.has_value());
  EXPECT_EQ(frame->Id, "049D");
  EXPECT_TRUE(frame->IsFull);
  EXPECT_TRUE(frame->HasPresets);
  EXPECT_FALSE(frame->IsSmall);
  EXPECT_TRUE(frame->IsIdle);
  ASSERT_TRUE(frame->Position.has_value());
  EXPECT_LT((*frame->Position - Vector3(10.0, 150.0, 120.0)).norm(), 1e-9) << "right, up, back";
  EXPECT_EQ(frame->Displayed, Vector3(0.5, 2.0, -1.0));
  EXPECT_EQ(frame->Buttons, 5u);
  // About the service's z, which is up: about y here.
  ASSERT_TRUE(frame->Orientation.has_value());
  EXPECT_LT((frame->Orientation->vec() - Vector3(0.0, 0.6, 0.0)).norm(), 1e-12);
}

TEST(Inverse3Messages, OtherIdsAndShapesAreNothing)
{
  EXPECT_FALSE(ReadInverse3Frame(Inventory, "other").has_value());
  for (const char* text :
       {"", "{", "[]", "null", "7", R"({"inverse3":{}})", R"({"inverse3":[]})",
        R"({"inverse3":[1]})", R"({"inverse3":[{"device_id":3}]})", R"({"inverse3":"x"})"})
  {
    EXPECT_FALSE(ReadInverse3Frame(text, "").has_value()) << text;
  }
  const auto bare = ReadInverse3Frame(R"({"inverse3":[{"device_id":"1"}]})", "");
  ASSERT_TRUE(bare.has_value());
  EXPECT_FALSE(bare->Position.has_value());
  EXPECT_FALSE(bare->Orientation.has_value());
}

TEST(Inverse3Messages, DamagedStatesNeverCrashOrGiveNonsense)
{
  std::mt19937 random(7);
  const std::string whole = Inventory;
  for (int n = 0; n < 4000; ++n)
  {
    std::string text = whole;
    for (int change = 0; change < 3; ++change)
    {
      text[random() % text.size()] = static_cast<char>(random() % 256);
    }
    text.resize(text.size() - (n % 3 == 0 ? random() % text.size() : 0));
    const auto frame = ReadInverse3Frame(text, "");
    if (frame)
    {
      EXPECT_TRUE(!frame->Position || frame->Position->allFinite());
      EXPECT_TRUE(!frame->Orientation || std::abs(frame->Orientation->norm() - 1.0) < 1e-12);
    }
  }
}

TEST(Inverse3Messages, ForceIsWrittenInTheServicesFrame)
{
  const Vector3 force(1.0, 2.0, 3.0);
  const Json newer = Json::parse(Inverse3ForceMessage("049D", force, true, false, true));
  EXPECT_EQ(newer, Json::parse(R"({"inverse3":[{"device_id":"049D","commands":
      {"set_cursor_force":{"vector":{"x":1.0,"y":-3.0,"z":2.0}}}}]})"));
  const Json older = Json::parse(Inverse3ForceMessage("049D", force, false, true, false));
  EXPECT_EQ(older["session"]["configure"]["profile"]["name"], "palpate");
  EXPECT_EQ(older["inverse3"][0]["commands"]["set_cursor_force"]["values"]["z"], 2.0);
  EXPECT_FALSE(older["inverse3"][0].contains("configure"));
  const Json first = Json::parse(Inverse3ForceMessage("049D", force, true, true, true));
  EXPECT_EQ(first["inverse3"][0]["configure"]["preset"], "arm_front_centered");
}

TEST(Inverse3Messages, AlarmsAreThoseOfThisDevice)
{
  const auto event = [](const std::string& name, const std::string& level, const std::string& id)
  {
    return R"({"name":")" + name + R"(","category":"device","level":")" + level +
           R"(","data":{"device_id":")" + id + R"("},"message":"said"})";
  };
  const auto alarm = Inverse3Alarm(event("device-safety-triggered", "error", "1"), "1");
  ASSERT_TRUE(alarm.has_value());
  EXPECT_NE(alarm->find("said"), std::string::npos);
  EXPECT_TRUE(Inverse3Alarm(event("device-disconnected", "warning", "1"), "1").has_value());
  EXPECT_TRUE(Inverse3Alarm(event("device-busy", "warning", "1"), "1").has_value());
  EXPECT_FALSE(Inverse3Alarm(event("device-safety-triggered", "info", "1"), "1").has_value());
  EXPECT_FALSE(Inverse3Alarm(event("device-safety-triggered", "notice", "1"), "1").has_value())
      << "the brake is released";
  EXPECT_FALSE(Inverse3Alarm(event("device-disconnected", "warning", "2"), "1").has_value());
  EXPECT_FALSE(Inverse3Alarm(event("device-battery-low", "warning", "1"), "1").has_value());
  EXPECT_FALSE(Inverse3Alarm("{", "1").has_value());
}
} // namespace
} // namespace palpate::inverse3_messages_test
