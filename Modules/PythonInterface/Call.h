#pragma once

#include "palpate.h"

#include <memory>
#include <stdexcept>

namespace palpate
{
/// A message of the C interface; becomes palpate.Error in Python.
class CallError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Calls a function of the C interface that can fail, with its arguments before `error`; returns
/// its result, or throws CallError.
template <typename Function, typename... Arguments>
auto Call(Function function, Arguments... arguments)
{
  palpate_error error{};
  auto result = function(arguments..., &error);
  if (!result)
  {
    throw CallError(error.text);
  }
  return result;
}

struct FreeOwned
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
using Owned = std::unique_ptr<Handle, FreeOwned>;
} // namespace palpate
