#pragma once

#include "Call.h"

#include <mutex>
#include <pybind11/pybind11.h>

namespace palpate
{
/// palpate.Session.
struct BoundSession
{
  Owned<palpate_session> Handle; // empty once it is closed
  std::mutex Busy;
};

void BindSessions(pybind11::module_& module);
} // namespace palpate
