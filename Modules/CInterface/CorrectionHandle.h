#pragma once

#include "CorrectedMask.h"
#include "ModelCorrection.h"

#include <array>
#include <memory>

/// A mask or a model under correction.
struct palpate_correction
{
  std::unique_ptr<palpate::CorrectedMask> Mask; ///< null: a model
  palpate::OrganModel Start;                    ///< of a model
  palpate::SurfaceCorrection Pulls;
  std::array<int, 3> Size{}; ///< of the mask's grid
};
