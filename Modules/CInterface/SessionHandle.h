#pragma once

#include "SteadyClock.h"
#include "TouchSession.h"

#include <string>
#include <vector>

/// A session of the C interface.
struct palpate_session
{
  palpate::SteadyClock Clock;
  palpate::TouchSession Session{Clock}; // ends first
  std::vector<int> Ids;                 ///< of the scene's structures
  std::string Problem;
};
