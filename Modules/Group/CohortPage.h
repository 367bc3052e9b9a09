#pragma once

#include "CohortGroup.h"
#include "PalpateGroupModule.h"

#include <string>

namespace palpate
{
/// A page shows no more modes.
constexpr int MostPicturedModes = 5;

/// How many modes have pictures: five, or as many as there are.
PALPATEGROUP_EXPORT int PicturedModes(const CohortGroup& group);

/// One HTML page that needs nothing else: the mean shape, the principal modes as the mean and
/// `deviations` standard deviations to either side, all at one scale and coloured by how far they
/// lie outside or inside the mean (mm), what the modes explain, a table of cases, notes.
PALPATEGROUP_EXPORT std::string CohortPage(const CohortGroup& group, double deviations);
} // namespace palpate
