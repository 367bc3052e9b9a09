#include "Handles.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace palpate::arguments_test
{
namespace
{
// Calls a function of the interface with each of its pointers in turn as NULL, and the others as
// given.
template <typename Function, typename Arguments, std::size_t... All>
void CallWithNulls(const char* name, Function function, const Arguments& given,
                   std::index_sequence<All...>)
{
  const auto without = [&](auto missing)
  {
    Arguments arguments = given;
    auto& argument = std::get<decltype(missing)::value>(arguments);
    using Kind = std::remove_reference_t<decltype(argument)>;
    if constexpr (std::is_pointer_v<Kind>)
    {
      argument = nullptr;
      SCOPED_TRACE(std::string(name) + ", argument " + std::to_string(decltype(missing)::value));
      static_cast<void>(std::apply(function, arguments));
    }
  };
  (without(std::integral_constant<std::size_t, All>{}), ...);
}

template <typename Result, typename... Arguments, typename... Given>
void Survives(const char* name, Result (*function)(Arguments...), Given... given)
{
  static_assert(sizeof...(Arguments) == sizeof...(Given));
  CallWithNulls(name, function, std::tuple<Arguments...>(given...),
                std::index_sequence_for<Arguments...>{});
}
#define SURVIVES(function, ...) Survives(#function, function, __VA_ARGS__)

// Enough of everything that functions write.
struct Buffers
{
  std::vector<double> A = std::vector<double>(1000, 1.0);
  std::vector<double> B = std::vector<double>(1000, 1.0);
  std::vector<double> C = std::vector<double>(1000, 1.0);
  std::vector<double> D = std::vector<double>(1000, 1.0);
  std::vector<double> E = std::vector<double>(1000, 1.0);
  std::vector<int32_t> Triangles = std::vector<int32_t>(3000, 0);
  std::vector<std::size_t> Cases = std::vector<std::size_t>(100, 0);
  std::vector<std::uint8_t> Mask = std::vector<std::uint8_t>(1000, 1);
  std::vector<float> Values = std::vector<float>(1000, 1.0F);
  double Number = 0.0;
  palpate_error Error{};
};

constexpr double Origin[3] = {0.0, 0.0, 0.0};
constexpr double Spacing[3] = {1.0, 1.0, 1.0};
constexpr double Axes[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
constexpr int Size[3] = {10, 10, 10};

test::Owned<palpate_design> Design()
{
  const char* const names[] = {"age"};
  const char* const values[] = {"1", "2", "4", "3", "7"};
  return test::Owned<palpate_design>(
      palpate_design_create("~ age", 5, 1, names, values, 0, nullptr, nullptr));
}

TEST(Arguments, ModelFunctionsSurviveEveryNull)
{
  Buffers b;
  palpate_error* e = &b.Error;
  const auto ball = test::BallModel();
  palpate_model* m = ball.get();
  SURVIVES(palpate_model_create, 0, b.A.data(), Origin, e);
  SURVIVES(palpate_model_create_parametric, 1, b.A.data(), e);
  SURVIVES(palpate_model_fit, b.A.data(), 4, Origin, 0, e);
  SURVIVES(palpate_model_fit_mask, b.Mask.data(), Size, Origin, Spacing, Axes, 2, 1, e);
  SURVIVES(palpate_model_read, "absent.json", e);
  SURVIVES(palpate_model_write, m, "/absent/folder/a.json", e);
  SURVIVES(palpate_model_free, m);
  SURVIVES(palpate_model_degree, m);
  SURVIVES(palpate_model_is_star_shaped, m);
  SURVIVES(palpate_model_yields, m);
  SURVIVES(palpate_model_coefficients, m, b.A.data(), 10);
  SURVIVES(palpate_model_center, m, b.A.data());
  SURVIVES(palpate_model_point, m, b.A.data(), b.B.data(), b.C.data(), e);
  const palpate_evaluation evaluation{b.B.data(), b.C.data(), nullptr, nullptr,
                                      nullptr,    nullptr,    nullptr, nullptr};
  SURVIVES(palpate_model_evaluate, m, b.A.data(), 3, &evaluation, e);
  palpate_body body{};
  SURVIVES(palpate_model_body, m, &body, e);
  SURVIVES(palpate_model_spectrum, m, b.A.data(), e);
  SURVIVES(palpate_model_measure, m, &b.Number, &b.Number, e);
  SURVIVES(palpate_model_nearest, m, b.A.data(), b.B.data(), b.C.data(), &b.Number, e);
  SURVIVES(palpate_model_mesh, m, 2, b.A.data(), b.B.data(), b.Triangles.data(), e);
  SURVIVES(palpate_model_displacement, m, 2, b.A.data(), b.B.data(), b.C.data(), b.Triangles.data(),
           b.D.data(), e);
}

TEST(Arguments, ComparisonsSurviveEveryNull)
{
  Buffers b;
  palpate_error* e = &b.Error;
  const auto ball = test::BallModel();
  const test::Owned<palpate_compared> compared(palpate_compared_of_model(ball.get(), e));
  ASSERT_NE(compared, nullptr);
  const palpate_compared* c = compared.get();
  SURVIVES(palpate_compared_of_mask, b.Mask.data(), Size, Origin, Spacing, Axes, e);
  SURVIVES(palpate_compared_of_mesh, b.A.data(), 3, b.Triangles.data(), 1, e);
  SURVIVES(palpate_compared_of_model, ball.get(), e);
  SURVIVES(palpate_compared_free, compared.get());
  SURVIVES(palpate_compared_point_count, c);
  SURVIVES(palpate_compared_triangle_count, c);
  std::vector<double> points(3 * palpate_compared_point_count(c));
  std::vector<int32_t> triangles(3 * palpate_compared_triangle_count(c));
  SURVIVES(palpate_compared_surface, c, points.data(), triangles.data());
  palpate_comparison comparison{};
  SURVIVES(palpate_compare, c, c, b.A.data(), 2, &comparison, b.B.data(), points.data(),
           points.data(), e);
}

TEST(Arguments, StatisticsSurviveEveryNull)
{
  Buffers b;
  palpate_error* e = &b.Error;
  const char* const names[] = {"age"};
  const char* const values[] = {"1", "2", "4", "3", "7"};
  const char* const references[] = {"age=1"};
  const auto design = Design();
  ASSERT_NE(design, nullptr);
  const palpate_design* d = design.get();
  SURVIVES(palpate_design_create, "~ age", 5, 1, names, values, 1, references, e);
  SURVIVES(palpate_design_free, design.get());
  SURVIVES(palpate_design_case_count, d);
  SURVIVES(palpate_design_column_count, d);
  SURVIVES(palpate_design_term_count, d);
  SURVIVES(palpate_design_column_name, d, 0);
  palpate_term term{};
  SURVIVES(palpate_design_term, d, 1, &term);
  SURVIVES(palpate_design_matrix, d, b.Cases.data(), b.A.data());
  SURVIVES(palpate_design_fit, d, b.A.data(), 3, 0.95, b.B.data(), b.C.data(), b.D.data(), e);
  SURVIVES(palpate_design_test, d, 1, b.A.data(), 3, b.B.data(), b.C.data(), b.D.data(), e);
  palpate_multivariate multivariate{};
  SURVIVES(palpate_design_test_together, d, 1, b.A.data(), 2, &multivariate, e);
  SURVIVES(palpate_design_permute, d, 1, b.A.data(), 3, b.B.data(), b.Triangles.data(), 1, 5, 1,
           b.C.data(), b.C.data(), b.D.data(), b.E.data(), &b.Number, &b.Number, e);
  const char* const missing[] = {"1", "2", nullptr, "3", "7"};
  EXPECT_EQ(palpate_design_create("~ age", 5, 1, names, missing, 0, nullptr, e), nullptr);
  EXPECT_STREQ(e->text, "a text of 'values' is NULL");
}

TEST(Arguments, ScenesAndSessionsSurviveEveryNull)
{
  Buffers b;
  palpate_error* e = &b.Error;
  const auto ball = test::BallModel();
  const auto scene = test::BallScene();
  const test::Owned<palpate_field> field(
      palpate_field_create(Size, Origin, Spacing, Axes, b.Values.data(), 0.5, e));
  SURVIVES(palpate_field_create, Size, Origin, Spacing, Axes, b.Values.data(), 0.5, e);
  SURVIVES(palpate_field_is_inside, field.get(), Origin);
  SURVIVES(palpate_field_free, field.get());
  SURVIVES(palpate_scene_free, scene.get());
  SURVIVES(palpate_scene_add_model, scene.get(), 1, ball.get(), &test::Stiff, e);
  SURVIVES(palpate_scene_add_field, scene.get(), 2, field.get(), &test::Stiff, e);
  SURVIVES(palpate_scene_add_mesh, scene.get(), 3, b.A.data(), 3, b.Triangles.data(), 1,
           &test::Stiff, e);
  SURVIVES(palpate_scene_set_tool_radius, scene.get(), 1.0, e);
  SURVIVES(palpate_scene_set_workspace, scene.get(), Origin, 1.0, e);
  const test::Owned<palpate_tracker> tracker(palpate_tracker_create(scene.get(), e));
  palpate_contact contact{};
  SURVIVES(palpate_tracker_create, scene.get(), e);
  SURVIVES(palpate_tracker_follow, tracker.get(), Origin, &contact);
  SURVIVES(palpate_tracker_release, tracker.get());
  SURVIVES(palpate_tracker_free, tracker.get());
  const test::Owned<palpate_session> session(palpate_session_open("simulated", e));
  ASSERT_NE(session, nullptr);
  palpate_state state{};
  SURVIVES(palpate_session_open, "absent", e);
  SURVIVES(palpate_session_show, session.get(), scene.get(), 0, e);
  SURVIVES(palpate_session_read, session.get(), &state);
  SURVIVES(palpate_session_problem, session.get());
  SURVIVES(palpate_session_stop_force, session.get());
  SURVIVES(palpate_session_allow_force, session.get());
  SURVIVES(palpate_session_lead_hand, session.get(), Origin);
  SURVIVES(palpate_session_free, session.get());
}

TEST(Arguments, NullIsNamed)
{
  palpate_error error{};
  EXPECT_EQ(palpate_session_open(nullptr, &error), nullptr);
  EXPECT_STREQ(error.text, "the argument 'device' is NULL");
}

TEST(Arguments, AbsurdSizesAreRefusedInOwnWords)
{
  Buffers b;
  const int absurd[3] = {65536, 65536, 65536};
  const int most = std::numeric_limits<int>::max();
  const int beyond[3] = {most, most, most};
  std::vector<std::string> messages;
  const auto refused = [&](const void* made)
  {
    EXPECT_EQ(made, nullptr);
    messages.emplace_back(b.Error.text);
    b.Error.text[0] = '\0';
  };
  palpate_error* e = &b.Error;
  for (const int* size : {absurd, beyond})
  {
    refused(palpate_model_fit_mask(b.Mask.data(), size, Origin, Spacing, Axes, 8, 0, e));
    refused(palpate_compared_of_mask(b.Mask.data(), size, Origin, Spacing, Axes, e));
    refused(palpate_field_create(size, Origin, Spacing, Axes, b.Values.data(), 0.5, e));
  }
  for (const std::size_t count : {SIZE_MAX, SIZE_MAX / 2, SIZE_MAX / 3 + 1, std::size_t{1} << 40U})
  {
    refused(palpate_model_fit(b.A.data(), count, Origin, 4, e));
    refused(palpate_compared_of_mesh(b.A.data(), count, b.Triangles.data(), 1, e));
    refused(palpate_compared_of_mesh(b.A.data(), 3, b.Triangles.data(), count, e));
    const char* const text = "1";
    refused(palpate_design_create("~ a", count, 3, &text, &text, 0, nullptr, e));
    refused(palpate_design_create("~ a", 1, count, &text, &text, 0, nullptr, e));
    EXPECT_EQ(palpate_model_evaluate(test::BallModel().get(), b.A.data(), count, nullptr, e), 0);
    EXPECT_EQ(palpate_scene_add_mesh(test::BallScene().get(), 1, b.A.data(), count,
                                     b.Triangles.data(), 1, &test::Stiff, e),
              0);
  }
  refused(palpate_model_create(-1, b.A.data(), Origin, e));
  refused(palpate_model_fit(b.A.data(), 4, Origin, most, e));
  for (const std::string& message : messages)
  {
    EXPECT_NE(message, "");
    for (const char* foreign : {"std::", "bad_alloc", "max_size", "_M_", "basic_string"})
    {
      EXPECT_EQ(message.find(foreign), std::string::npos) << message;
    }
  }
}
} // namespace
} // namespace palpate::arguments_test
