#pragma once

#include "Call.h"

#include <mutex>
#include <pybind11/pybind11.h>

namespace palpate
{
/// palpate.Scene.
struct BoundScene
{
  Owned<palpate_scene> Handle{palpate_scene_create()};
  std::mutex Busy; // while one thread uses the handle
  int LastId = 0;
};

/// palpate.Tracker.
struct BoundTracker
{
  Owned<palpate_tracker> Handle;
  std::mutex Busy;
};

void BindScenes(pybind11::module_& module);
} // namespace palpate
