#pragma once

#include "PalpateStudyModule.h"
#include "SceneProtection.h"
#include "StudyPipeline.h"
#include "StudyState.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// What no drill may remove, as a state and its products have it.
struct StudyForbidden
{
  int Id = 0;
  std::string Name;
  double AlarmDistance = 0.0;                                  ///< mm
  StudyStepState State;                                        ///< of its protection
  std::shared_ptr<const SceneProtection> Protection = nullptr; ///< null until it is up to date

  bool IsReady() const { return this->Protection != nullptr; }
};

/// All forbidden structures of a state, whether they are visible, touchable or neither, in its
/// order.
PALPATESTUDY_EXPORT std::vector<StudyForbidden> ForbiddenOf(const StudyState& state,
                                                            const StudyPipeline& pipeline);

/// Why nothing may be drilled while these are not ready, and the way out, for the user; empty where
/// there are none.
PALPATESTUDY_EXPORT std::string DrillHoldText(const std::vector<StudyForbidden>& unready);

/// How a structure's protection stands, in a few words: "Protected", "Protection: 40 %", ...
PALPATESTUDY_EXPORT std::string ProtectionText(const StudyForbidden& forbidden);
} // namespace palpate
