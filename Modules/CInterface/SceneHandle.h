#pragma once

#include "TouchScene.h"
#include "Vector3.h"

#include <optional>

/// A scene of the C interface, and where the device's workspace is to be in it.
struct palpate_scene
{
  struct Workspace
  {
    palpate::Vector3 CenterWorld; ///< mm
    double Scale;
  };
  palpate::TouchScene Scene;
  std::optional<Workspace> Place;
};
