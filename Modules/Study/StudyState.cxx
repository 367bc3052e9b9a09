#include "StudyState.h"

#include <tuple>

namespace palpate
{
namespace
{
auto Fields(const StudyLandmark& l)
{
  return std::tie(l.Name, l.PositionWorld);
}

auto Fields(const StudyDistance& d)
{
  return std::tie(d.Name, d.FromWorld, d.ToWorld);
}

auto Fields(const StudyView& v)
{
  return std::tie(v.CrosshairWorld, v.Window, v.Level, v.Layout, v.OverlayOpacity, v.UsesVolumeAxes,
                  v.SlicesFollowProbe);
}

auto Fields(const StudyState& s)
{
  return std::tie(s.VolumeFile, s.DicomSeries, s.SegmentationFile, s.Landmarks, s.Distances,
                  s.View);
}
} // namespace

bool operator==(const StudyLandmark& a, const StudyLandmark& b)
{
  return Fields(a) == Fields(b);
}

bool operator==(const StudyDistance& a, const StudyDistance& b)
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

std::filesystem::path StudyPath(const std::filesystem::path& file)
{
  return file.empty() ? file : std::filesystem::absolute(file).lexically_normal();
}

} // namespace palpate
