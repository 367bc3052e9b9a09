#pragma once

#include "ContactTracker.h"

#include <memory>
#include <vector>

/// A tool in a scene of the C interface.
struct palpate_tracker
{
  struct Structure
  {
    int Id;
    double Stiffness; ///< N/mm
    std::unique_ptr<palpate::ContactTracker> Tracker;
  };
  std::vector<Structure> Structures;
};
