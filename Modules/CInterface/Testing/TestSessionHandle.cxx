#include "Handles.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <thread>

namespace palpate::session_handle_test
{
namespace
{
using Session = test::Owned<palpate_session>;

Session Simulated()
{
  palpate_error error{};
  Session session(palpate_session_open("simulated", &error));
  EXPECT_NE(session, nullptr) << error.text;
  return session;
}

// Reads until that holds, for at most ten seconds.
palpate_state ReadUntil(palpate_session* session,
                        const std::function<bool(const palpate_state&)>& holds)
{
  using namespace std::chrono;
  palpate_state state{};
  const auto end = steady_clock::now() + seconds(10);
  while (!(palpate_session_read(session, &state) != 0 && holds(state)))
  {
    if (steady_clock::now() > end)
    {
      ADD_FAILURE() << "it did not happen: " << palpate_session_problem(session);
      break;
    }
    std::this_thread::sleep_for(milliseconds(1));
  }
  return state;
}

double SizeOf(const double force[3])
{
  return std::hypot(force[0], force[1], force[2]);
}

// Leads the hand from above onto the ball of 20 mm, 1 mm deep with the tool of 1 mm.
void PressBall(palpate_session* session)
{
  const double above[3] = {0.0, 25.0, 0.0};
  const double pressed[3] = {0.0, 20.0, 0.0};
  ASSERT_EQ(palpate_session_lead_hand(session, above), 1);
  ReadUntil(session, [](const palpate_state& now) { return now.probe[1] > 24.0; });
  ASSERT_EQ(palpate_session_lead_hand(session, pressed), 1);
}

TEST(SessionHandle, HandIsPushedOut)
{
  const Session session = Simulated();
  palpate_error error{};
  ASSERT_EQ(palpate_session_show(session.get(), test::BallScene().get(), 0, &error), 1)
      << error.text;
  PressBall(session.get());
  const palpate_state state =
      ReadUntil(session.get(), [](const palpate_state& now)
                { return now.is_armed != 0 && now.is_ramping == 0 && SizeOf(now.force) > 0.05; });
  EXPECT_EQ(state.id, 7);
  EXPECT_GT(state.depth, 0.0);
  EXPECT_GT(state.force[1], 0.0);
  EXPECT_GE(std::hypot(state.proxy[0], state.proxy[1], state.proxy[2]), 21.0 - 1e-6);
  EXPECT_STREQ(palpate_session_problem(session.get()), "");
}

TEST(SessionHandle, StoppedForceStaysOffUntilItIsAllowed)
{
  const Session session = Simulated();
  ASSERT_EQ(palpate_session_show(session.get(), test::BallScene().get(), 0, nullptr), 1);
  PressBall(session.get());
  ReadUntil(session.get(), [](const palpate_state& now) { return SizeOf(now.force) > 0.02; });
  palpate_session_stop_force(session.get());
  const palpate_state off =
      ReadUntil(session.get(), [](const palpate_state& now) { return now.is_armed == 0; });
  EXPECT_EQ(SizeOf(off.force), 0.0);
  EXPECT_NE(std::strlen(palpate_session_problem(session.get())), 0U);
  palpate_session_allow_force(session.get());
  ReadUntil(session.get(), [](const palpate_state& now) { return now.is_armed != 0; });
}

TEST(SessionHandle, AnotherSceneReplacesTheFirst)
{
  const Session session = Simulated();
  ASSERT_EQ(palpate_session_show(session.get(), test::BallScene().get(), 0, nullptr), 1);
  const test::Owned<palpate_scene> next(palpate_scene_create());
  const auto ball = test::BallModel();
  ASSERT_EQ(palpate_scene_add_model(next.get(), 12, ball.get(), &test::Stiff, nullptr), 1);
  ASSERT_EQ(palpate_session_show(session.get(), next.get(), 1, nullptr), 1);
  PressBall(session.get());
  ReadUntil(session.get(), [](const palpate_state& now) { return now.id == 12; });
}

TEST(SessionHandle, WithoutASceneNothingIsRead)
{
  const Session session = Simulated();
  palpate_state state{};
  EXPECT_EQ(palpate_session_read(session.get(), &state), 0);
  EXPECT_STREQ(palpate_session_problem(session.get()), "");
  palpate_session_stop_force(session.get());
  palpate_session_allow_force(session.get());
  const double place[3] = {0.0, 0.0, 0.0};
  EXPECT_EQ(palpate_session_lead_hand(session.get(), place), 0);
}

TEST(SessionHandle, UnknownDevicesGiveAMessage)
{
  palpate_error error{};
  EXPECT_EQ(palpate_session_open("teapot", &error), nullptr);
  EXPECT_NE(std::strstr(error.text, "teapot"), nullptr) << error.text;
}
} // namespace
} // namespace palpate::session_handle_test
