#pragma once

#include "palpate.h"

#include <array>
#include <cmath>
#include <memory>

namespace palpate::test
{
/// Frees a handle at the end.
struct FreeHandle
{
  void operator()(palpate_model* handle) const { palpate_model_free(handle); }
  void operator()(palpate_field* handle) const { palpate_field_free(handle); }
  void operator()(palpate_scene* handle) const { palpate_scene_free(handle); }
  void operator()(palpate_tracker* handle) const { palpate_tracker_free(handle); }
  void operator()(palpate_compared* handle) const { palpate_compared_free(handle); }
  void operator()(palpate_case* handle) const { palpate_case_free(handle); }
  void operator()(palpate_check_group* handle) const { palpate_check_group_free(handle); }
  void operator()(palpate_checked* handle) const { palpate_checked_free(handle); }
  void operator()(palpate_design* handle) const { palpate_design_free(handle); }
  void operator()(palpate_session* handle) const { palpate_session_free(handle); }
  void operator()(palpate_geodesics* handle) const { palpate_geodesics_free(handle); }
  void operator()(palpate_correction* handle) const { palpate_correction_free(handle); }
};
template <typename Handle>
using Owned = std::unique_ptr<Handle, FreeHandle>;

constexpr palpate_law Stiff{0.5, 0.0, 0.0, 0.0}; // N/mm

/// A sphere of 20 mm around the origin.
inline Owned<palpate_model> BallModel()
{
  const double coefficient = 20.0 * std::sqrt(4.0 * 3.14159265358979323846);
  const double center[3] = {0.0, 0.0, 0.0};
  return Owned<palpate_model>(palpate_model_create(0, &coefficient, center, nullptr));
}

/// With that sphere as structure 7.
inline Owned<palpate_scene> BallScene()
{
  Owned<palpate_scene> scene(palpate_scene_create());
  palpate_scene_add_model(scene.get(), 7, BallModel().get(), &Stiff, nullptr);
  return scene;
}
} // namespace palpate::test
