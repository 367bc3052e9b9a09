#pragma once

#include "JudgementText.h"
#include "MaskChecks.h"
#include "PalpateComparisonModule.h"

#include <string>

namespace palpate
{
/// A page's style for it: "good", "poor" or "bad".
const char* VerdictStyle(OrganJudgement::Verdict verdict);

/// "L 12.3, A 4.0, S 55.1": a place in the patient, mm.
PALPATECOMPARISON_EXPORT std::string PatientPlace(const Vector3& world);

/// What the command prints: a line for each structure that is not plausible, the worst case first.
PALPATECOMPARISON_EXPORT std::string CheckText(const MaskChecks& checks);
/// "8 structures of 3 cases: 6 plausible, 1 to look at, 1 implausible".
PALPATECOMPARISON_EXPORT std::string CheckTally(const MaskChecks& checks);
/// By what was judged, with the rate of false alarms.
PALPATECOMPARISON_EXPORT std::string CheckBasis(const MaskChecks& checks);
/// Why a group cannot hold a rate of false alarms (0..1) and the limits apply; empty if it can.
PALPATECOMPARISON_EXPORT std::string TooFewCasesText(const CheckGroup& group, double rate);
} // namespace palpate
