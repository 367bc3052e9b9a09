#pragma once

#include "CheckGroup.h"
#include "CheckedCase.h"

#include <string>
#include <vector>

/// A patient's structures, measured for checks of the C interface.
struct palpate_case
{
  palpate::CheckedCase Patient;
};

/// A group of the C interface's checks.
struct palpate_check_group
{
  palpate::CheckGroup Group;
  std::vector<std::string> Dropped; ///< why; in the order of Group.Dropped
};

/// A case of the C interface that was judged.
struct palpate_checked
{
  palpate::CheckedCase Patient;
  std::vector<palpate::OrganJudgement> Judgements;
  std::vector<std::string> Sentences;             ///< of each organ
  std::vector<std::vector<double>> Probabilities; ///< of each organ's statistics
};
