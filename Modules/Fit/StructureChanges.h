#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"

#include <string>

namespace palpate
{
/// What the model of a result leaves out, joins, fills or cuts of its structure, whatever its kind:
/// a radial model fills cavities and, like a surface model of one component, leaves out the others
/// unless one was asked for by its number.
PALPATEFIT_EXPORT TopologyReport ChangesOf(const FitResult& result);

/// Those in words, see ChangeText of a report; empty without changes.
PALPATEFIT_EXPORT std::string ChangeText(const FitResult& result);

/// The one rule by which structures are accepted for models of any kind: within TopologyLimits, or
/// with Repairs. Otherwise refuses the result, with a way out, and returns false.
bool AcceptChanges(const TopologyReport& changes, FitResult& result);

/// Of a fitted result: the changes as its message, and a note on each limit of acceptance of which
/// less than a tenth is left, since a mask of another grid may be refused.
void RemarkOnAcceptance(FitResult& result);
} // namespace palpate
