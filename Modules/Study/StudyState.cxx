#include "StudyState.h"

#include <algorithm>
#include <tuple>

namespace palpate
{
namespace
{
auto Fields(const StudyLandmark& l)
{
  return std::tie(l.Name, l.PositionWorld);
}

auto Fields(const StudyView& v)
{
  return std::tie(v.CrosshairWorld, v.Window, v.Level, v.Layout, v.OverlayOpacity, v.UsesVolumeAxes,
                  v.SlicesFollowProbe, v.Mixing, v.Curtain, v.ErrorScale);
}

auto Fields(const StudyVolume& v)
{
  return std::tie(v.Id, v.File, v.Series, v.Transform, v.IsVisible, v.Window, v.Level, v.Colors,
                  v.Opacity, v.HidesBelow, v.Rendering);
}

auto Fields(const StudyState& s)
{
  return std::tie(s.VolumeFile, s.DicomSeries, s.Rendering, s.Volumes, s.SegmentationFile,
                  s.Landmarks, s.Measurements, s.Drawing, s.Correction, s.View);
}
} // namespace

bool operator==(const StudyLandmark& a, const StudyLandmark& b)
{
  return Fields(a) == Fields(b);
}

bool operator==(const StudyRendering& a, const StudyRendering& b)
{
  return a.IsShown == b.IsShown && a.Preset == b.Preset;
}

bool operator==(const StudyVolume& a, const StudyVolume& b)
{
  return Fields(a) == Fields(b);
}

bool operator==(const StudyView& a, const StudyView& b)
{
  return Fields(a) == Fields(b);
}

bool operator==(const StudyState& a, const StudyState& b)
{
  const SceneSettings& scene = a;
  return scene == static_cast<const SceneSettings&>(b) && Fields(a) == Fields(b);
}

const StudyVolume* FindVolume(const StudyState& state, int id)
{
  const auto found = std::find_if(state.Volumes.begin(), state.Volumes.end(),
                                  [id](const StudyVolume& one) { return one.Id == id; });
  return found != state.Volumes.end() ? &*found : nullptr;
}

StudyVolume* FindVolume(StudyState& state, int id)
{
  return const_cast<StudyVolume*>(FindVolume(static_cast<const StudyState&>(state), id));
}

SceneMove MoveOf(const StudyState& state, const StudyVolume& volume)
{
  return volume.Transform.empty() ? SceneMove{} : SceneMove{volume.Transform, state.VolumeFile};
}

StudyState WithTransform(const StudyState& state, int volumeId,
                         const std::filesystem::path& transform)
{
  StudyState next = state;
  StudyVolume& volume = *FindVolume(next, volumeId);
  const SceneMove before = MoveOf(next, volume);
  volume.Transform = StudyPath(transform);
  if (MoveOf(next, volume).IsSet())
  {
    ReadMove(MoveOf(next, volume), volume.File);
  }
  for (SceneStructure& structure : next.Structures)
  {
    const bool isOfVolume =
        structure.Iso && structure.File == volume.File && structure.Series == volume.Series;
    const bool goesAlong = structure.Move == before && (before.IsSet() || isOfVolume);
    structure.Move = goesAlong ? MoveOf(next, volume) : structure.Move;
  }
  return next;
}

StudyState WithNextVolume(const StudyState& state)
{
  StudyState next = state;
  const auto shown = std::find_if(next.Volumes.begin(), next.Volumes.end(),
                                  [](const StudyVolume& one) { return one.IsVisible; });
  const auto after = shown != next.Volumes.end() ? std::next(shown) : next.Volumes.begin();
  const auto number = after - next.Volumes.begin();
  for (auto one = next.Volumes.begin(); one != next.Volumes.end(); ++one)
  {
    one->IsVisible = one - next.Volumes.begin() == number;
  }
  return next;
}

std::filesystem::path StudyPath(const std::filesystem::path& file)
{
  return file.empty() ? file : std::filesystem::absolute(file).lexically_normal();
}

} // namespace palpate
