#pragma once

#include "PalpateSessionModule.h"
#include "Progress.h"
#include "StudyProduct.h"
#include "StudyStamps.h"
#include "StudyState.h"

#include <functional>
#include <string>
#include <vector>

namespace palpate
{
/// From files to touch. Volume, segmentation and tool are of the whole study, the others of a
/// structure.
enum class StudyStep
{
  Volume,
  Segmentation,
  Structures, ///< those of the state, found in the segmentation
  Surface,
  Samples,
  Model,
  Field,      ///< for sub-voxel structures
  Protection, ///< of a forbidden structure from the drill; nothing is drilled before it
  Touch,      ///< the contact model
  Cost,       ///< what that costs a tick, measured; nothing waits for it
  Trade, ///< what each rung of the dial would cost, and how true it is; an automatic dial goes by
         ///< it
  Tool   ///< one that is a surface from a file
};

/// "volume", "segmentation", ...
PALPATESESSION_EXPORT const char* NameOf(StudyStep step);

/// One thing to be made.
struct StudyNode
{
  StudyStep Step = StudyStep::Volume;
  int Label = 0; ///< of the structure; 0 for the whole study
  /// What it is made from, in full: two nodes of one key have the same product. Empty where that is
  /// not decided yet.
  std::string Key;
  std::vector<std::string> Inputs; ///< keys
  /// Where something else does its work: a sentence that says what, and why. It has failed then, or
  /// what it is made from has, and that is no failure of the study's. Empty without.
  std::string Advice;
  std::string Replacement; ///< the key of what does its work
  /// Throws what has a sentence for the user, and Cancelled.
  std::function<StudyProduct(const std::vector<StudyProduct>& inputs,
                             const ProgressFunction& progress)>
      Make;
};

/// The product of a key that is there already, or nothing.
using StudyLookup = std::function<const StudyProduct*(const std::string& key)>;

/// All that a state wants to be made, inputs before what is made from them: only what its
/// representations need of structures that are shown or touched, and the protection of all that are
/// forbidden.
PALPATESESSION_EXPORT std::vector<StudyNode>
PlanStudy(const StudyState& state, const StudyStamps& stamps, const StudyLookup& lookup);
} // namespace palpate
