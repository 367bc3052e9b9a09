#include "StudyForbidden.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
using Kind = StudyStepState::Kind;

// "Pallidum_L", "Pallidum_L and 4 more".
std::string NamesOf(const std::vector<StudyForbidden>& forbidden)
{
  const std::size_t others = forbidden.size() - 1;
  return forbidden.front().Name +
         (others > 0 ? " and " + std::to_string(others) + " more" : std::string());
}
} // namespace

std::vector<StudyForbidden> ForbiddenOf(const StudyState& state, const StudyPipeline& pipeline)
{
  std::vector<StudyForbidden> forbidden;
  for (const SceneStructure& structure : state.Structures)
  {
    if (structure.IsForbidden)
    {
      StudyForbidden one{{TitleOf(structure), structure.AlarmDistance, nullptr},
                         structure.Id,
                         pipeline.StateOf(SceneStep::Protection, structure.Id)};
      // The newest product may belong to a previous state.
      if (one.State.Is == Kind::UpToDate)
      {
        one.Protection = pipeline.Newest<SceneProtection>(SceneStep::Protection, structure.Id);
      }
      forbidden.push_back(std::move(one));
    }
  }
  return forbidden;
}

std::string DrillHoldText(const std::vector<StudyForbidden>& unready)
{
  if (unready.empty())
  {
    return {};
  }
  const auto failed =
      std::find_if(unready.begin(), unready.end(),
                   [](const StudyForbidden& one) { return one.State.Is == Kind::Failed; });
  if (failed != unready.end())
  {
    return "Drilling is off, because " + failed->Name +
           " cannot be protected: " + failed->State.Message +
           ". Give it another drill role, or fix this and press \"Again\" next to \"protection\".";
  }
  const auto cancelled =
      std::find_if(unready.begin(), unready.end(),
                   [](const StudyForbidden& one) { return one.State.IsCancelled; });
  if (cancelled != unready.end())
  {
    return "Drilling is off, because the protection of " + cancelled->Name +
           " was cancelled. Press \"Again\" in the pipeline, or give it another drill role.";
  }
  return "Drilling waits for the protection of " + NamesOf(unready) + ".";
}

std::string ProtectionText(const StudyForbidden& forbidden)
{
  switch (forbidden.State.Is)
  {
  case Kind::UpToDate:
  case Kind::Replaced:
    return "Protected";
  case Kind::Running:
    return "Protection: " + std::to_string(std::lround(100.0 * forbidden.State.Fraction)) + " %";
  case Kind::Failed:
    return "Not protected: " + forbidden.State.Message;
  case Kind::NeedsUpdate:
  case Kind::NotWanted:
    break;
  }
  return forbidden.State.IsCancelled ? "Protection cancelled" : "Protection waits";
}
} // namespace palpate
