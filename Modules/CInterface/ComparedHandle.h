#pragma once

#include "ComparedBody.h"

/// A body of the C interface's comparisons.
struct palpate_compared
{
  palpate::ComparedBody Body;
};
