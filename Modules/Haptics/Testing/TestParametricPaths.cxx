#include "ContactCases.h"
#include "ParametricContactModel.h"
#include "ParametricPath.h"
#include "ParametricPhantoms.h"
#include "SurfaceTouchTruth.h"

#include <algorithm>

namespace palpate::parametric_paths_test
{
namespace
{
using test::At;
using test::Random;
using test::TrackerOf;

std::shared_ptr<const ContactModel> PathContact(const ParametricSphericalSurface& surface)
{
  std::shared_ptr<const ContactModel> contact;
  const Status status = ParametricContactModel::Make(surface, contact);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return contact;
}

struct PathPhantom
{
  const char* Name;
  ParametricSphericalSurface Surface;
};

std::vector<PathPhantom> PathPhantoms()
{
  Random random(5);
  return {{"OpenRing", test::OpenRing()},
          {"Bowl", test::Bowl()},
          {"BumpyTube", test::BumpyTube(random)}};
}

std::shared_ptr<const ParametricTouchSurface>
PathSurfaceOf(const ParametricSphericalSurface& surface)
{
  std::shared_ptr<const ParametricTouchSurface> touch;
  const Status status = ParametricTouchSurface::Make(surface, touch);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return touch;
}

// Of 10^5 paths over phantoms and patients' zones by Testing/Benchmarks/SurfaceTouch.
TEST(ParametricPaths, PathsAgreeWithSearchesOfTheWholeSurface)
{
  std::vector<PathPhantom> phantoms = PathPhantoms();
  phantoms.push_back({"CleftBlob", test::CleftBlob()});
  for (const auto& [name, surface] : phantoms)
  {
    const auto touch = PathSurfaceOf(surface);
    const auto model = PathContact(surface);
    for (const double toolRadius : {0.0, 1.0, 4.0})
    {
      Random random(9112);
      const auto tracker = TrackerOf(*model, ToolShape::Sphere(toolRadius));
      test::SurfaceTouchTruth truth(touch, toolRadius);
      test::SurfaceTouchTruth::Counts counts;
      for (int path = 0; path < 40; ++path)
      {
        tracker->Release();
        int tick = 0;
        bool isFree = false;
        test::FollowSurfacePath(surface, toolRadius, random,
                                [&](const Vector3& probe)
                                {
                                  const Contact& contact = tracker->Follow(At(probe));
                                  isFree = tick++ == 0 ? truth.Begin(probe) : isFree;
                                  if (isFree)
                                  {
                                    truth.Judge(probe, contact, counts);
                                  }
                                });
      }
      EXPECT_GT(counts.Unique, 38 * 20) << name << " " << toolRadius;
      EXPECT_EQ(counts.Inexact, 0) << name << " " << toolRadius << " " << counts.Error.Value();
      EXPECT_EQ(counts.Late, 0) << name << " " << toolRadius << " " << counts.LateDepth.Value();
      EXPECT_EQ(counts.Early, 0) << name << " " << toolRadius;
      // What an unknown wall may overlap, and more where the next proof found it.
      EXPECT_LE(counts.Overlap.Value(), 5e-3 * touch->SmallestRadius())
          << name << " " << toolRadius;
    }
  }
}

// All minima are about equal there, so that no proof ends.
TEST(ParametricPaths, ContactBeginsInAHollowAsRoundAsTheTool)
{
  const ParametricSphericalSurface surface = test::Bowl();
  const auto touch = PathSurfaceOf(surface);
  const auto model = PathContact(surface);
  const Vector3 centre(-25.0, 0.0, 10.0); // of the hollow, 16 mm
  for (const double gap : {0.05, 0.1, 0.2, 0.4})
  {
    const double toolRadius = touch->Search().Nearest(centre).SignedDistance - gap;
    const auto tracker = TrackerOf(*model, ToolShape::Sphere(toolRadius));
    Random random(9113);
    int late = 0;
    int longest = 0;
    for (int path = 0; path < 25; ++path)
    {
      tracker->Release();
      const Vector3 along = test::RandomDirection(random);
      const double upwards = std::max(0.0, -along.z());
      for (double length = 0.0; length < gap + 1.0; length += 0.05)
      {
        const Vector3 probe = centre + length * (along + 2.0 * upwards * Vector3::UnitZ());
        const Contact& contact = tracker->Follow(At(probe));
        const double depth = toolRadius - touch->Search().Nearest(probe, 5000).SignedDistance;
        late = depth > 0.01 && !contact.IsTouching ? late + 1 : 0;
        longest = std::max(longest, late);
      }
    }
    EXPECT_LE(longest, 2) << gap; // ticks
  }
}
} // namespace
} // namespace palpate::parametric_paths_test
