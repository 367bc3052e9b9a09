#pragma once

#include "CheckGroup.h"
#include "CheckedCase.h"
#include "CheckedMask.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace palpate
{
/// The masks of one patient's structures, each made when it is needed.
struct CaseMasks
{
  struct Structure
  {
    std::string Name; ///< empty: "label N" is its name
    int Label = 0;    ///< N
    int Layer = 0;    ///< structures of one layer share no voxels
  };

  std::vector<Structure> Structures;
  /// Of a structure by its place in the list; called by several threads at once.
  std::function<CheckedMask(std::size_t)> MaskOf;
  bool IsOriented = true;   ///< see CheckedCase
  bool AreOnOneGrid = true; ///< all layers
  std::size_t LayerCount = 1;

  /// The voxels of all structures; they have one grid, and there is one at least.
  CheckedMask Union() const;
};

/// Measures each structure (`atATime` threads); two to eight that have one body together as one,
/// too (CheckedCase::WholeName); between layers "overlap": the largest share of the smaller of two
/// structures that is in both, unless that is more than nine tenths (a part of an organ may be a
/// structure of its own; Amount: mm^3); what islands lie against (NameIslandNeighbours); and sides
/// (MeasureSides). `report`, which may be empty, receives the part of the structures that are
/// measured. Rethrows what it and MaskOf throw.
CheckedCase MeasureCase(const CaseMasks& masks, const RadialProbe& probe, std::size_t atATime,
                        const std::function<void(double)>& report = {});

/// Of each organ of a case: against a group at a rate of false alarms (CheckGroup::Judge), or
/// without one (null) by fixed limits.
std::vector<OrganJudgement> JudgeCase(CheckedCase& patient, const CheckGroup* group, double rate);
} // namespace palpate
