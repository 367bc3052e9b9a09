#pragma once

#include "PalpateSessionModule.h"
#include "Progress.h"
#include "TouchContact.h"
#include "TouchScene.h"

#include <string>
#include <vector>

namespace palpate
{
/// Gives a contact what it is felt by while ticks take too long, as far as that does not depend on
/// the tool: harmonics of half the degree and of a quarter, a fourth of the facets and a sixteenth.
/// What is too simple for that stays alone. Throws Cancelled.
PALPATESESSION_EXPORT void AddStandIns(TouchContact& contact, const ProgressFunction& progress);

/// The degrees that a model of this one is felt by then, falling.
PALPATESESSION_EXPORT std::vector<int> StandInDegrees(int degree);

/// Those of harmonics that are on demand.
PALPATESESSION_EXPORT std::vector<TouchStandIn>
StandInsOnDemand(const std::shared_ptr<OnDemandHarmonics>& harmonics);

/// All that a contact is felt by then with a tool: at a field, a sphere of 26 points and of 6.
PALPATESESSION_EXPORT std::vector<TouchStandIn> StandInsFor(const TouchContact& contact,
                                                            const ToolShape& tool);

/// A sentence for whoever touches: what is felt at a level of stand-ins, and why. Of the structure
/// that is touched, of the first that has stand-ins where none is (-1); empty at level 0.
PALPATESESSION_EXPORT std::string LevelText(const TouchScene& scene, int level, int structure,
                                            double rate);
} // namespace palpate
