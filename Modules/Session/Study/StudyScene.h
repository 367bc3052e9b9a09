#pragma once

#include "PalpateSessionModule.h"
#include "StudyPipeline.h"
#include "StudyState.h"
#include "TouchScene.h"
#include "TouchStructures.h"
#include "WorkspaceFrame.h"

#include <memory>
#include <vector>

namespace palpate
{
/// A structure of a study that can be touched now.
struct StudyContact
{
  int Label = 0;
  std::shared_ptr<const TouchContact> Contact;
  DrillSource Drilled = {}; ///< without a field: it is not drilled, or cannot be yet
};

/// Those of the state's touchable structures whose newest model is there.
PALPATESESSION_EXPORT std::vector<StudyContact> ContactsOf(const StudyState& state,
                                                           const StudyPipeline& pipeline);

/// Those of `contacts` whose structures the state has and wants touchable.
PALPATESESSION_EXPORT std::vector<StudyContact>
TouchableOf(const StudyState& state, const std::vector<StudyContact>& contacts);

/// What a hand is to feel: a structure for each of `contacts`, which are touchable. Throws
/// InputError for a tool that is none.
PALPATESESSION_EXPORT TouchScene MakeStudyScene(const StudyState& state,
                                                const std::vector<StudyContact>& contacts,
                                                const WorkspaceFrame& frame);
} // namespace palpate
