#pragma once

#include "CheckGroup.h"

#include <cstddef>
#include <string>

namespace palpate
{
/// "plausible", "look here" or "implausible".
const char* VerdictWord(OrganJudgement::Verdict verdict);

/// What is suspicious about a structure, in one sentence without its name: "has a hole of 1.2 ml
/// (7 % of its volume)"; of a plausible one "shows nothing unusual".
std::string JudgementSentence(const OrganJudgement& judgement);

/// Why a case does not describe its group: "liver has an odd shape".
std::string OddCaseText(const CheckGroup::Odd& odd);

/// Why so many cases make no group.
std::string FewCasesText(std::size_t cases);
} // namespace palpate
