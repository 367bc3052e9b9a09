#pragma once

#include "DrillContext.h"
#include "PalpateStudyModule.h"
#include "StudyPipeline.h"
#include "StudyState.h"

#include <string>
#include <vector>

namespace palpate
{
/// A forbidden structure with the state of its protection, which is null until it is up to date.
struct StudyForbidden : DrillProtection
{
  int Id = 0;
  StudyStepState State; ///< of its protection

  bool IsReady() const { return this->Protection != nullptr; }
};

/// All forbidden structures of a state, whether they are visible, touchable or neither, in its
/// order.
PALPATESTUDY_EXPORT std::vector<StudyForbidden> ForbiddenOf(const StudyState& state,
                                                            const StudyPipeline& pipeline);

/// Message for the user: why drilling is off while these are not ready, and what to do; empty if
/// there are none.
PALPATESTUDY_EXPORT std::string DrillHoldText(const std::vector<StudyForbidden>& unready);

/// State of a structure's protection: "Protected", "Protection: 40 %", ...
PALPATESTUDY_EXPORT std::string ProtectionText(const StudyForbidden& forbidden);
} // namespace palpate
