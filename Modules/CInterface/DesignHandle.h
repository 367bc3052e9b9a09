#pragma once

#include "LinearDesign.h"

/// A linear model's design of the C interface.
struct palpate_design
{
  palpate::LinearDesign Design;
  std::size_t GivenCases = 0;
};
