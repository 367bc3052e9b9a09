#include "TrialActivity.h"

#include "LandmarkActivity.h"
#include "NoduleActivity.h"
#include "OutlineActivity.h"
#include "PathActivity.h"

#include <array>

namespace palpate
{
namespace
{
using ActivityMaker = TrialActivity* (*)(const TrialPlace& place, QWidget* strip);

template <typename Activity>
TrialActivity* MakeActivity(const TrialPlace& place, QWidget* strip)
{
  return new Activity(place, strip);
}

// In the order of TaskKind. A mask is to be corrected by the mode that pushes and pulls, a body to
// be docked by the one that holds it: null until the window has them.
constexpr std::array<ActivityMaker, 6> ActivityMakers{MakeActivity<NoduleActivity>,
                                                      MakeActivity<LandmarkActivity>,
                                                      MakeActivity<OutlineActivity>,
                                                      nullptr,
                                                      nullptr,
                                                      MakeActivity<PathActivity>};
} // namespace

bool HasTrialActivity(TaskKind kind)
{
  return ActivityMakers.at(static_cast<std::size_t>(kind)) != nullptr;
}

TrialActivity* MakeTrialActivity(TaskKind kind, const TrialPlace& place, QWidget* strip)
{
  const ActivityMaker make = ActivityMakers.at(static_cast<std::size_t>(kind));
  return make != nullptr ? make(place, strip) : nullptr;
}
} // namespace palpate
