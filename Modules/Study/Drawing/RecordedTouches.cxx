#include "RecordedTouches.h"

#include "TouchRecording.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace palpate
{
namespace
{
constexpr double LeastDepth = 1e-3; // mm, that has a direction

// The hand pushes the tool from its place on the surface inwards, along the normal.
std::optional<Vector3> NormalAt(const TouchState& tick)
{
  const Vector3 outwards = Vector3(tick.ProxyWorld) - Vector3(tick.ProbeWorld);
  const bool isContact = tick.HasSample && tick.Structure >= 0 && !tick.IsClutched &&
                         !tick.IsBuried && tick.PatchRadius == 0.0;
  const bool hasNormal = isContact && outwards.allFinite() && outwards.norm() >= LeastDepth;
  return hasNormal ? std::optional(Vector3(outwards.normalized())) : std::nullopt;
}

std::vector<SurfaceTouch> AllTouches(const TouchRecording& recording,
                                     const RecordedTouchSettings& settings)
{
  std::map<int, std::size_t> counts;
  for (const TouchState& tick : recording.Ticks)
  {
    counts[tick.Structure] += NormalAt(tick) ? 1 : 0;
  }
  const auto longest =
      std::max_element(counts.begin(), counts.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  std::vector<SurfaceTouch> touches;
  for (const TouchState& tick : recording.Ticks)
  {
    const auto normal = NormalAt(tick);
    if (normal && tick.Structure == longest->first)
    {
      touches.push_back(
          {Vector3(tick.ProxyWorld) - settings.ToolRadius * *normal, settings.Deviation, normal});
    }
  }
  return touches;
}

// Those that are this far from all before them; one more than `most` if there are more.
std::vector<SurfaceTouch> Thinned(const std::vector<SurfaceTouch>& touches, double spacing,
                                  std::size_t most)
{
  std::vector<SurfaceTouch> kept;
  for (auto touch = touches.begin(); touch != touches.end() && kept.size() <= most; ++touch)
  {
    const bool isNew =
        std::none_of(kept.begin(), kept.end(),
                     [&](const SurfaceTouch& other)
                     { return (other.PointWorld - touch->PointWorld).norm() < spacing; });
    if (isNew)
    {
      kept.push_back(*touch);
    }
  }
  return kept;
}
} // namespace

std::vector<SurfaceTouch> TouchesOf(const TouchRecording& recording,
                                    const RecordedTouchSettings& settings)
{
  const std::vector<SurfaceTouch> all = AllTouches(recording, settings);
  double spacing = settings.Spacing;
  std::vector<SurfaceTouch> kept = Thinned(all, spacing, settings.Most);
  while (kept.size() > settings.Most)
  {
    spacing *= std::sqrt(2.0); // about half as many
    kept = Thinned(all, spacing, settings.Most);
  }
  return kept;
}
} // namespace palpate
