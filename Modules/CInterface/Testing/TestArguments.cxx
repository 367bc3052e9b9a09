#include "Handles.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace palpate::arguments_test
{
namespace
{
// Frees what a function made.
template <typename Handle>
void Drop(Handle* made)
{
  if constexpr (!std::is_const_v<Handle>)
  {
    test::Owned<Handle>{made};
  }
}

// What a function returned without an argument: 0, NULL or an empty text where it has no error.
template <typename Result>
bool IsNothing(Result result)
{
  if constexpr (std::is_same_v<Result, const char*>)
  {
    return result == nullptr || *result == '\0';
  }
  return result == Result{};
}

// Calls a function without one of its arguments, and with the others as given. It fails and says
// so, unless it does without that argument.
template <std::size_t Missing, typename Result, typename... Arguments>
void CallWithout(Result (*function)(Arguments...), std::tuple<Arguments...> arguments)
{
  constexpr std::size_t last = sizeof...(Arguments) - 1;
  using Last = std::tuple_element_t<last, std::tuple<Arguments...>>;
  std::get<Missing>(arguments) = nullptr;
  if constexpr (std::is_void_v<Result>)
  {
    std::apply(function, arguments);
  }
  else
  {
    if constexpr (std::is_same_v<Last, palpate_error*> && Missing != last)
    {
      palpate_error error{};
      std::get<last>(arguments) = &error;
      const Result result = std::apply(function, arguments);
      EXPECT_NE(IsNothing(result), error.text[0] == '\0');
      EXPECT_TRUE(!IsNothing(result) || std::strstr(error.text, "is NULL") != nullptr)
          << error.text;
      return;
    }
    const Result result = std::apply(function, arguments);
    constexpr bool hasError = std::is_same_v<Last, palpate_error*>;
    EXPECT_TRUE(Missing > 0 || hasError || IsNothing(result));
    if constexpr (std::is_pointer_v<Result>)
    {
      Drop(result);
    }
  }
}

template <typename Result, typename... Arguments, std::size_t... All>
void CallWithNulls(const char* name, Result (*function)(Arguments...),
                   const std::tuple<Arguments...>& given, std::index_sequence<All...>)
{
  const auto without = [&](auto missing)
  {
    constexpr std::size_t index = decltype(missing)::value;
    if constexpr (std::is_pointer_v<std::tuple_element_t<index, std::tuple<Arguments...>>>)
    {
      SCOPED_TRACE(std::string(name) + ", argument " + std::to_string(index));
      CallWithout<index>(function, given);
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
constexpr double Identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

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
  SURVIVES(palpate_model_create_surface, 1, b.A.data(), e);
  SURVIVES(palpate_model_create_parametric, 1, b.A.data(), e);
  SURVIVES(palpate_model_fit, b.A.data(), 4, Origin, 0, e);
  SURVIVES(palpate_model_fit_mask, b.Mask.data(), Size, Origin, Spacing, Axes, 2, 1, e);
  const double touched[] = {20, 0, 0, -20, 0, 0, 0, 20, 0, 0, -20, 0, 0, 0, 20, 0, 0, -20};
  SURVIVES(palpate_complete, touched, touched, b.Triangles.data(), nullptr, 6, nullptr, 1.0, Origin,
           b.A.data(), b.B.data(), e);
  SURVIVES(palpate_complete_organ, touched, touched, b.Triangles.data(), nullptr, 6, nullptr, 1.0,
           Origin, nullptr, b.A.data(), b.B.data(), e);
  SURVIVES(palpate_correction_of_model, m, e);
  SURVIVES(palpate_correction_of_mask, b.Mask.data(), nullptr, Size, Origin, Spacing, Axes, e);
  test::Owned<palpate_correction> correction(palpate_correction_of_model(m, nullptr));
  palpate_correction* c = correction.get();
  const palpate_pull pull{{20, 0, 0}, 1.0, 0, {0, 0, 0}, 8.0, 0.0};
  std::vector<double> moved(std::size_t{3} * 5762);
  std::size_t points = 0;
  std::size_t triangles = 0;
  SURVIVES(palpate_correction_pull, c, &pull, e);
  SURVIVES(palpate_correction_preview, c, &pull, moved.data(), e);
  SURVIVES(palpate_correction_remove_islands, c, e);
  SURVIVES(palpate_correction_fill, c, e);
  SURVIVES(palpate_correction_smooth, c, 1.0, e);
  SURVIVES(palpate_correction_cut, c, Origin, Axes, e);
  SURVIVES(palpate_correction_undo, c);
  SURVIVES(palpate_correction_surface, c, &points, &triangles, nullptr, nullptr, moved.data(),
           nullptr, e);
  SURVIVES(palpate_correction_mask, c, b.Mask.data(), e);
  SURVIVES(palpate_correction_model, c, e);
  SURVIVES(palpate_correction_free, nullptr);
  const double corners[] = {0, 0, 0, 9, 0, 0, 0, 9, 0};
  const int32_t triangle[] = {0, 1, 2};
  test::Owned<palpate_compared> flat(palpate_compared_of_mesh(corners, 3, triangle, 1, nullptr));
  test::Owned<palpate_geodesics> along(palpate_geodesics_of_body(flat.get(), nullptr));
  palpate_geodesics* g = along.get();
  palpate_geodesic length{};
  SURVIVES(palpate_geodesics_of_model, m, e);
  SURVIVES(palpate_geodesics_of_body, flat.get(), e);
  SURVIVES(palpate_geodesics_find, g, Origin, Axes, &length, b.A.data(), 2, &points, e);
  ASSERT_EQ(palpate_geodesics_map(g, Origin, &points, &triangles, nullptr, nullptr, nullptr, e), 1);
  std::vector<double> places(3 * points);
  std::vector<double> distances(points);
  std::vector<int32_t> faces(3 * triangles);
  SURVIVES(palpate_geodesics_map, g, Origin, &points, &triangles, places.data(), faces.data(),
           distances.data(), e);
  SURVIVES(palpate_geodesics_free, nullptr);
  SURVIVES(palpate_model_read, "absent.json", e);
  SURVIVES(palpate_model_write, m, "/absent/folder/a.json", e);
  SURVIVES(palpate_model_free, m);
  SURVIVES(palpate_model_changes, m);
  SURVIVES(palpate_model_degree, m);
  SURVIVES(palpate_model_is_radial, m);
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
  SURVIVES(palpate_compared_of_mask_shape, b.Mask.data(), Size, Origin, Spacing, Axes, e);
  SURVIVES(palpate_compared_of_mesh, b.A.data(), 3, b.Triangles.data(), 1, e);
  SURVIVES(palpate_compared_of_model, ball.get(), e);
  SURVIVES(palpate_compared_free, compared.get());
  SURVIVES(palpate_compared_point_count, c);
  SURVIVES(palpate_compared_triangle_count, c);
  std::vector<double> points(3 * palpate_compared_point_count(c));
  std::vector<int32_t> triangles(3 * palpate_compared_triangle_count(c));
  SURVIVES(palpate_compared_surface, c, points.data(), triangles.data());
  palpate_comparison comparison{};
  palpate_shape shape{};
  SURVIVES(palpate_compared_shape, c, &shape, e);
  SURVIVES(palpate_compared_thickness, c, points.data(), e);
  SURVIVES(palpate_compared_ray_thickness, c, points.data(), e);
  SURVIVES(palpate_compared_measure, c, &b.Number, &b.Number);
  std::vector<palpate_section> sections(10);
  SURVIVES(palpate_compared_calibre, c, sections.data(), 10, &b.Number, e);
  SURVIVES(palpate_compared_mirror, c, c, &b.Number, b.B.data(), e);
  palpate_motion motion{};
  SURVIVES(palpate_compared_motion, c, c, b.A.data(), 1, &motion, b.B.data(), e);
  palpate_registration registration{};
  SURVIVES(palpate_register_landmarks, b.A.data(), b.B.data(), 5, 0, 0.0, &registration, b.C.data(),
           b.D.data(), e);
  SURVIVES(palpate_register_points, points.data(), 50, c, 0, 0.0, Identity, &registration, e);
  SURVIVES(palpate_register_bodies, c, c, 0, 0.0, Identity, &registration, e);
  palpate_relation relation{};
  SURVIVES(palpate_relate, c, c, 1.0, b.A.data(), 2, &relation, b.B.data(), points.data(), e);
  SURVIVES(palpate_compare, c, c, b.A.data(), 2, &comparison, b.B.data(), points.data(),
           points.data(), e);
}

TEST(Arguments, ChecksSurviveEveryNull)
{
  Buffers b;
  palpate_error* e = &b.Error;
  const std::vector<int32_t> labels(1000, 1);
  const int32_t values[] = {1};
  const char* const names[] = {"a"};
  const std::uint8_t* const masks[] = {b.Mask.data()};
  SURVIVES(palpate_case_of_labels, labels.data(), Size, Origin, Spacing, Axes, 1, values, names, e);
  SURVIVES(palpate_case_of_masks, masks, Size, Origin, Spacing, Axes, 1, names, e);
  const test::Owned<palpate_case> one(
      palpate_case_of_masks(masks, Size, Origin, Spacing, Axes, 1, names, e));
  ASSERT_NE(one, nullptr) << b.Error.text;
  const palpate_case* const cases[] = {one.get(), one.get()};
  SURVIVES(palpate_check_group_create, cases, 2, e);
  SURVIVES(palpate_check_group_read, "absent.json", e);
  SURVIVES(palpate_check_group_write, nullptr, "/absent/folder/a.json", e);
  SURVIVES(palpate_check_group_least_rate, nullptr);
  SURVIVES(palpate_check_group_dropped, nullptr, 0, b.Cases.data());
  SURVIVES(palpate_check_group_free, nullptr);
  SURVIVES(palpate_case_check, one.get(), nullptr, 0.05, e);
  const test::Owned<palpate_checked> checked(palpate_case_check(one.get(), nullptr, 0.05, e));
  palpate_verdict verdict{};
  palpate_rule rule{};
  SURVIVES(palpate_checked_verdict, checked.get(), 0, &verdict);
  SURVIVES(palpate_checked_rule, checked.get(), 0, 0, &rule);
  SURVIVES(palpate_checked_free, checked.get());
  SURVIVES(palpate_case_free, one.get());
}

TEST(Arguments, StatisticsSurviveEveryNull)
{
  Buffers b;
  palpate_error* e = &b.Error;
  const char* const names[] = {"age"};
  const char* const values[] = {"1", "2", "4", "3", "7"};
  const char* const references[] = {"age=1"};
  for (std::size_t i = 0; i < b.A.size(); ++i)
  {
    b.A[i] = std::sin(static_cast<double>(i * i));
  }
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
  SURVIVES(palpate_design_term, d, 0, &term);
  SURVIVES(palpate_design_matrix, d, b.Cases.data(), b.A.data());
  SURVIVES(palpate_design_fit, d, b.A.data(), 3, 0.95, b.B.data(), b.C.data(), b.D.data(), e);
  SURVIVES(palpate_design_test, d, 0, b.A.data(), 3, b.B.data(), b.C.data(), b.D.data(), e);
  const int32_t subjects[] = {1, 1, 2, 2, 2};
  palpate_mixed mixed{};
  mixed.coefficients = b.B.data();
  SURVIVES(palpate_design_fit_mixed, d, subjects, b.C.data(), b.A.data(), 2, 0.95, &mixed, e);
  const auto ball = test::BallModel();
  const palpate_model* const models[] = {ball.get(), ball.get(), ball.get()};
  palpate_asymmetry asymmetry{};
  asymmetry.mean = b.B.data();
  SURVIVES(palpate_find_asymmetry, models, models, 3, 0, 2, 9, 1, &asymmetry, e);
  palpate_multivariate multivariate{};
  SURVIVES(palpate_design_test_together, d, 0, b.A.data(), 2, &multivariate, e);
  SURVIVES(palpate_design_permute, d, 0, b.A.data(), 3, b.B.data(), b.Triangles.data(), 1, 5, 1,
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

// A new function joins the tests above.
TEST(Arguments, EveryFunctionIsTriedWithoutItsArguments)
{
  std::ifstream in(PALPATE_C_INTERFACE "/Testing/TestArguments.cxx");
  const std::string source{std::istreambuf_iterator<char>(in), {}};
  std::ifstream listed(PALPATE_C_INTERFACE "/Testing/functions-" +
                       std::to_string(PALPATE_API_VERSION) + ".txt");
  const std::set<std::string> withoutPointers{"palpate_version", "palpate_api_version",
                                              "palpate_scene_create", "palpate_mesh_point_count",
                                              "palpate_mesh_triangle_count"};
  int count = 0;
  for (std::string name; listed >> name; ++count)
  {
    EXPECT_TRUE(withoutPointers.count(name) > 0 ||
                source.find("SURVIVES(" + name + ",") != std::string::npos)
        << name;
  }
  EXPECT_GT(count, 50);
}

TEST(Arguments, NullIsNamed)
{
  palpate_error error{};
  EXPECT_EQ(palpate_session_open(nullptr, &error), nullptr);
  EXPECT_STREQ(error.text, "the argument 'device' is NULL");
}

// Collects the messages of calls that have to fail.
struct Refusals
{
  palpate_error Error{};
  std::vector<std::string> Messages;

  template <typename Result>
  void operator()(Result result)
  {
    EXPECT_EQ(result, Result{});
    this->Messages.emplace_back(this->Error.text);
    this->Error.text[0] = '\0';
  }

  ~Refusals()
  {
    for (const std::string& message : this->Messages)
    {
      EXPECT_NE(message, "");
      for (const char* foreign : {"::", "bad_alloc", "max_size", "_M_", "basic_string"})
      {
        EXPECT_EQ(message.find(foreign), std::string::npos) << message;
      }
    }
  }
};

TEST(Arguments, AbsurdGridsAndDegreesAreRefusedInOwnWords)
{
  Buffers b;
  constexpr int most = std::numeric_limits<int>::max();
  Refusals refused;
  palpate_error* e = &refused.Error;
  for (const std::array<int, 3>& size :
       {std::array<int, 3>{65536, 65536, 65536}, {most, most, most}, {0, 10, 10}, {-1, -1, 10}})
  {
    const int* s = size.data();
    refused(palpate_model_fit_mask(b.Mask.data(), s, Origin, Spacing, Axes, 8, 0, e));
    refused(palpate_compared_of_mask(b.Mask.data(), s, Origin, Spacing, Axes, e));
    refused(palpate_field_create(s, Origin, Spacing, Axes, b.Values.data(), 0.5, e));
  }
  const auto ball = test::BallModel();
  for (const int absurd : {-1, most, std::numeric_limits<int>::min()})
  {
    refused(palpate_model_create(absurd, b.A.data(), Origin, e));
    refused(palpate_model_create_surface(absurd, b.A.data(), e));
    refused(palpate_model_fit(b.A.data(), 4, Origin, absurd, e));
    refused(palpate_model_fit_mask(b.Mask.data(), Size, Origin, Spacing, Axes, absurd, 0, e));
    refused(palpate_model_fit_mask(b.Mask.data(), Size, Origin, Spacing, Axes, absurd, 1, e));
    refused(palpate_model_mesh(ball.get(), absurd, b.A.data(), nullptr, b.Triangles.data(), e));
    refused(palpate_model_displacement(ball.get(), absurd, b.A.data(), b.B.data(), b.C.data(),
                                       b.Triangles.data(), b.D.data(), e));
  }
}

TEST(Arguments, AbsurdCountsAreRefusedInOwnWords)
{
  Buffers b;
  Refusals refused;
  palpate_error* e = &refused.Error;
  const auto ball = test::BallModel();
  const auto scene = test::BallScene();
  const auto design = Design();
  const char* const text = "1";
  double* a = b.A.data();
  int32_t* t = b.Triangles.data();
  const palpate_evaluation evaluation{};
  palpate_multivariate multivariate{};
  for (const std::size_t count : {SIZE_MAX, SIZE_MAX / 2, SIZE_MAX / 3 + 1, std::size_t{1} << 40U})
  {
    refused(palpate_model_fit(a, count, Origin, 4, e));
    refused(palpate_complete(a, a, t, nullptr, count, nullptr, 1.0, Origin, a, a, e));
    refused(
        palpate_complete_organ(a, a, t, nullptr, count, nullptr, 1.0, Origin, nullptr, a, a, e));
    refused(palpate_model_evaluate(ball.get(), a, count, &evaluation, e));
    refused(palpate_compared_of_mesh(a, count, t, 1, e));
    refused(palpate_compared_of_mesh(a, 3, t, count, e));
    refused(palpate_scene_add_mesh(scene.get(), 1, a, count, t, 1, &test::Stiff, e));
    refused(palpate_scene_add_mesh(scene.get(), 1, a, 3, t, count, &test::Stiff, e));
    refused(palpate_design_create("~ a", count, 3, &text, &text, 0, nullptr, e));
    refused(palpate_design_create("~ a", 1, count, &text, &text, 0, nullptr, e));
    refused(palpate_design_create("~ 1", count, 0, nullptr, nullptr, 0, nullptr, e));
    refused(palpate_design_create("~ a", 1, 1, &text, &text, count, &text, e));
    refused(palpate_design_fit(design.get(), a, count, 0.95, a, a, a, e));
    refused(palpate_design_test(design.get(), 0, a, count, a, a, a, e));
    refused(palpate_design_test_together(design.get(), 0, a, count, &multivariate, e));
    refused(palpate_design_permute(design.get(), 0, a, count, a, t, 1, 5, 1, a, a, a, a, a, a, e));
    refused(palpate_design_permute(design.get(), 0, a, 3, a, t, count, 5, 1, a, a, a, a, a, a, e));
    refused(palpate_design_test(design.get(), count, a, 3, a, a, a, e));
  }
}
} // namespace
} // namespace palpate::arguments_test
