#include "TrialActivity.h"

#include "DockActivity.h"
#include "LandmarkActivity.h"
#include "MaskActivity.h"
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

// In the order of TaskKind.
constexpr std::array<ActivityMaker, 6> ActivityMakers{
    MakeActivity<NoduleActivity>, MakeActivity<LandmarkActivity>, MakeActivity<OutlineActivity>,
    MakeActivity<MaskActivity>,   MakeActivity<DockActivity>,     MakeActivity<PathActivity>};
} // namespace

TrialActivity* MakeTrialActivity(TaskKind kind, const TrialPlace& place, QWidget* strip)
{
  return ActivityMakers.at(static_cast<std::size_t>(kind))(place, strip);
}
} // namespace palpate
