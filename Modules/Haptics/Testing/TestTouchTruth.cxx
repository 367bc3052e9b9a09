// Rendered contacts compared with exact ones, on 100,000 short paths over bodies that are known
// exactly.
#include "BumpyBody.h"
#include "ClosestPointSearch.h"
#include "ForceQuality.h"
#include "MeshCases.h"
#include "TouchPaths.h"
#include "WorstCase.h"

#include <sstream>
#include <string>

namespace palpate::touch_truth_test
{
namespace
{
using test::At;
using test::FieldWalk;
using test::ForceQuality;
using test::RadialWalk;
using test::Random;
using test::TrackerOf;
using test::WorstCase;

constexpr double Stiffness = 0.5; // N/mm
constexpr double Degree = M_PI / 180.0;
constexpr double Seizure = 2.0; // mm, of the proxy from the true one

struct Bounds
{
  double ForceError = 0.01;        // N, RMS
  double MeanAngle = 0.5 * Degree; // rad
  double MostAngle = 2.0 * Degree; // rad
  double Jump = 1.2;               // relative to the exact one's
};
constexpr Bounds AskedFor;

// The exact place of a tool, by the certified search over the whole surface.
Vector3 TrueProxy(const ClosestPointSearch& search, const Vector3& probe, double toolRadius)
{
  const ClosestPoint nearest = search.Nearest(probe);
  return nearest.SignedDistance < toolRadius
             ? Vector3(nearest.PointWorld + toolRadius * nearest.Normal)
             : probe;
}

void ExpectTruth(const ForceQuality& quality, const Bounds& most)
{
  const double jump = quality.FeltJumps().Maximum() / quality.IdealJumps().Maximum();
  const double meanJump = quality.FeltJumps().Mean() / quality.IdealJumps().Mean();
  EXPECT_LE(quality.ErrorRms(), most.ForceError);
  EXPECT_LE(quality.MeanAngle(), most.MeanAngle);
  EXPECT_LE(quality.AngleQuantile(1.0), most.MostAngle);
  EXPECT_LE(jump, most.Jump);
  EXPECT_LE(meanJump, most.Jump);
  std::ostringstream text;
  text << quality.Ticks() << " ticks: " << quality.ErrorRms() << " N RMS, "
       << quality.MeanAngle() / Degree << " degrees mean, " << quality.AngleQuantile(1.0) / Degree
       << " most, jumps " << meanJump << " and " << jump << " of the exact one's";
  ::testing::Test::RecordProperty("forces", text.str());
}

// One path of a tracker that starts without contact, compared with the exact proxies. Forces below
// `felt` (N) are ignored: their direction is dominated by the solver's tolerance.
template <typename Walk, typename Truth>
void CompareOnPath(ContactTracker& tracker, const Walk& walk, double toolRadius, double felt,
                   const Truth& trueProxy, ForceQuality& quality)
{
  tracker.Release();
  quality.BeginPath();
  test::FollowTouchPath(walk, toolRadius,
                        [&](const Vector3& probe)
                        {
                          const Vector3 proxy = tracker.Follow(At(probe)).ProxyWorld;
                          const Vector3 ideal = Stiffness * (trueProxy(probe) - probe);
                          if (ideal.norm() > felt)
                          {
                            quality.Add(Stiffness * (proxy - probe), ideal);
                          }
                        });
}

struct RadialCase
{
  const char* Name;
  RadialModel Model;
};

std::vector<RadialCase> RadialCases()
{
  Random random(8101);
  const Matrix3 turned = Eigen::AngleAxisd(0.7, Vector3(1.0, 2.0, 3.0).normalized()).matrix();
  std::vector<RadialCase> cases{
      {"Sphere", test::Sphere(20.0, {30.0, -80.0, 12.0})},
      {"Ellipsoid", test::Ellipsoid({25.0, 20.0, 16.0}, turned, 24)},
      {"OffCenterSphere", test::OffCenterSphere(20.0, {6.0, -3.0, 4.0}, 24)}};
  cases.push_back({"Bumpy", test::BumpyBody(random)});
  cases.push_back({"Organ", test::RandomOrgan(random, 12)});
  return cases;
}

class TouchTruthOnHarmonics : public ::testing::TestWithParam<RadialCase>
{
protected:
  RadialModel Body = GetParam().Model;
  ClosestPointSearch Search{test::Shared(Body)};
  std::shared_ptr<const ContactModel> Model = test::RadialContact(Body);
};

// 5 bodies, 3 tools, 7,000 paths each: 105,000.
TEST_P(TouchTruthOnHarmonics, ForcesAreThoseOfTheNearestPointForAnyRadius)
{
  constexpr int Paths = 7000;
  for (const double toolRadius : {0.0, 1.0, 4.0})
  {
    SCOPED_TRACE(toolRadius);
    Random random(8102);
    const auto tracker = TrackerOf(*this->Model, ToolShape::Sphere(toolRadius));
    const auto truth = [&](const Vector3& probe)
    { return TrueProxy(this->Search, probe, toolRadius); };
    ForceQuality quality;
    for (int path = 0; path < Paths; ++path)
    {
      CompareOnPath(*tracker, RadialWalk(this->Body, random), toolRadius, 1e-3, truth, quality);
    }
    EXPECT_GE(quality.Ticks(), Paths * 26U); // of 29, the first two are above the surface
    ExpectTruth(quality, AskedFor);
  }
}

// 5 bodies, 200,000 ticks each: 1,000,000.
TEST_P(TouchTruthOnHarmonics, ProxyNeverGetsStuck)
{
  constexpr int Ticks = 200000;
  constexpr double ToolRadius = 1.0;
  Random random(8103);
  const auto tracker = TrackerOf(*this->Model, ToolShape::Sphere(ToolRadius));
  test::WanderingDirection wandering(random);
  int seizures = 0;
  int touches = 0;
  for (int tick = 0; tick < Ticks; ++tick)
  {
    // 20 to 100 mm/s; from 3 mm deep to 0.5 mm above the surface.
    const double speed = 0.06 + 0.04 * std::sin(1.7e-3 * tick);
    const Vector3 u = wandering.Next(speed / 20.0);
    const double depth = 1.25 + 1.75 * std::sin(4.1e-3 * tick);
    const Vector3 probe = this->Body.PointWorld(u) + (ToolRadius - depth) * this->Body.Normal(u);
    const Contact& contact = tracker->Follow(At(probe));
    const double error = (contact.ProxyWorld - TrueProxy(this->Search, probe, ToolRadius)).norm();
    seizures += error <= Seizure ? 0 : 1;
    touches += contact.IsTouching ? 1 : 0;
  }
  EXPECT_EQ(seizures, 0);
  EXPECT_GT(touches, Ticks / 2);
}

TEST_P(TouchTruthOnHarmonics, ForcesAreIndependentOfTheUnitOfLength)
{
  constexpr double Scale = 1e-3;
  std::vector<double> coefficients = this->Body.Coefficients();
  for (double& c : coefficients)
  {
    c *= Scale;
  }
  const RadialModel metres(this->Body.Degree(), coefficients, Scale * this->Body.CenterWorld());
  const auto small = test::RadialContact(metres);
  Random random(8104);
  for (const double toolRadius : {0.0, 1.0})
  {
    const auto here = TrackerOf(*this->Model, ToolShape::Sphere(toolRadius));
    const auto there = TrackerOf(*small, ToolShape::Sphere(Scale * toolRadius));
    WorstCase difference;
    for (int path = 0; path < 500; ++path)
    {
      here->Release();
      there->Release();
      test::FollowTouchPath(RadialWalk(this->Body, random), toolRadius,
                            [&](const Vector3& probe)
                            {
                              const Contact& one = here->Follow(At(probe));
                              const Contact& other = there->Follow(At(Scale * probe));
                              difference.Add(Stiffness *
                                             (one.ProxyWorld - other.ProxyWorld / Scale).norm());
                            });
    }
    // Tracking ends within 1e-5 mm, and may end a step earlier at one scale by rounding.
    EXPECT_LE(difference.Value(), 1e-5) << toolRadius;
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, TouchTruthOnHarmonics, ::testing::ValuesIn(RadialCases()),
                         [](const auto& each) { return std::string(each.param.Name); });

TEST(TouchTruth, ForcesOnConvexBodiesAreIndependentOfTheRadius)
{
  Random random(8105);
  const RadialModel body = test::Ellipsoid({25.0, 20.0, 16.0}, Matrix3::Identity(), 24);
  const auto model = test::RadialContact(body);
  const auto point = TrackerOf(*model, ToolShape::Sphere(0.0));
  for (const double toolRadius : {0.1, 1.0, 10.0})
  {
    const auto sphere = TrackerOf(*model, ToolShape::Sphere(toolRadius));
    WorstCase difference;
    for (int path = 0; path < 1000; ++path)
    {
      const RadialWalk walk(body, random);
      std::vector<Vector3> forces;
      point->Release();
      sphere->Release();
      test::FollowTouchPath(walk, 0.0,
                            [&](const Vector3& probe)
                            { forces.push_back(point->Follow(At(probe)).ProxyWorld - probe); });
      std::size_t tick = 0;
      test::FollowTouchPath(
          walk, toolRadius,
          [&](const Vector3& probe) {
            difference.Add((sphere->Follow(At(probe)).ProxyWorld - probe - forces[tick++]).norm());
          });
    }
    // Two trackings, each within 1e-5 mm, and normals that turn by 1e-6 rad in that.
    EXPECT_LE(difference.Value(), 2e-5 + 1e-5 * toolRadius) << toolRadius;
  }
}

// Half axes in index coordinates; values in voxels along the shortest.
struct EllipsoidField
{
  Vector3 Center;
  Vector3 HalfAxes;

  double Value(const Vector3& p) const
  {
    return this->HalfAxes.minCoeff() * (1.0 - (p - this->Center).cwiseQuotient(HalfAxes).norm());
  }
};

const Vector3 FieldCenter(31.3, 32.1, 30.7); // index, of a grid of 64 nodes of 0.5 mm
const Vector3 FieldHalfAxes(24.0, 20.0, 18.0);
constexpr double VoxelSize = 0.5;

struct FieldCase
{
  const char* Name;
  std::shared_ptr<const ScalarField> (*Make)(FieldInterpolation);
  // Of the body in mm around the centre; null if the exact nearest point is unknown.
  RadialModel (*Truth)();
};

template <typename Procedure>
std::shared_ptr<const ScalarField> Sampled(const Procedure& field, FieldInterpolation interpolation)
{
  return test::SampledField(test::FineGrid(64), field, interpolation);
}

const FieldCase FieldCases[] = {
    {"Sphere",
     [](FieldInterpolation kind) {
       return Sampled(test::SphereField{FieldCenter, 24.0}, kind);
     },
     [] { return test::Sphere(24.0 * VoxelSize, test::FineGrid(64).PointWorld(FieldCenter)); }},
    {"Ellipsoid",
     [](FieldInterpolation kind) {
       return Sampled(EllipsoidField{FieldCenter, FieldHalfAxes}, kind);
     },
     []
     {
       const Vector3 axes = VoxelSize * FieldHalfAxes;
       return test::Project(
           24, [axes](const Vector3& u) { return 1.0 / u.cwiseQuotient(axes).norm(); },
           test::FineGrid(64).PointWorld(FieldCenter));
     }},
    {"Gyroid", [](FieldInterpolation kind) { return Sampled(test::GyroidField{24.0}, kind); },
     nullptr}};

class TouchTruthOnFields
    : public ::testing::TestWithParam<std::tuple<FieldCase, FieldInterpolation>>
{
protected:
  const FieldCase& Case() const { return std::get<0>(GetParam()); }

  // Start of a walk, far enough from the grid's border.
  Vector3 Beginning(Random& random) const
  {
    std::uniform_real_distribution<double> aside(-14.0, 14.0);
    const Vector3 index = FieldCenter + Vector3(aside(random), aside(random), aside(random));
    return this->Field->Grid().PointWorld(
        this->Case().Truth != nullptr ? Vector3(FieldCenter + 20.0 * test::RandomDirection(random))
                                      : index);
  }

  std::shared_ptr<const ScalarField> Field = std::get<0>(GetParam()).Make(std::get<1>(GetParam()));
  FieldSampler Sampler{Field};
  std::shared_ptr<const ContactModel> Model = test::FieldContact(Field);
};

TEST_P(TouchTruthOnFields, ToolAtItsProxyOnlyTouchesTheSurface)
{
  const ToolShape dense = ToolShape::SpherePoints(1.0, 1000);
  for (const double toolRadius : {0.0, 1.0})
  {
    Random random(8106);
    const auto tracker = TrackerOf(*this->Model, ToolShape::Sphere(toolRadius));
    WorstCase off;
    for (int path = 0; path < 1000; ++path)
    {
      const int looksAt = 2 + static_cast<int>(random() % (test::TouchPath::Ticks - 2));
      int tick = 0;
      tracker->Release();
      const auto visit = [&](const Vector3& probe)
      {
        const Contact& contact = tracker->Follow(At(probe));
        if (tick++ == looksAt && contact.IsTouching)
        {
          double nearest = INFINITY;
          for (const Vector3& point : dense.Points())
          {
            const Vector3 place = contact.ProxyWorld + toolRadius * point;
            nearest = std::min(nearest, test::FieldDistance(this->Sampler, place));
          }
          off.Add(nearest / VoxelSize);
        }
      };
      test::FollowTouchPath(FieldWalk(this->Sampler, this->Beginning(random), random), toolRadius,
                            visit);
    }
    RecordProperty("voxels", std::to_string(off.Value()));
    EXPECT_LE(off.Value(), 0.05) << toolRadius; // the required accuracy
  }
}

TEST_P(TouchTruthOnFields, ForcesEqualThoseOfTheExactBody)
{
  if (this->Case().Truth == nullptr)
  {
    GTEST_SKIP() << "the nearest point of this surface is unknown";
  }
  const RadialModel body = this->Case().Truth();
  const ClosestPointSearch search(test::Shared(body));
  // The exact surface of the trilinear field, which is rendered, is not the body's: within a voxel
  // h its normal deviates by up to h / 2R, 1.2 degrees of the sphere's, in each axis.
  const bool isCubic = std::get<1>(GetParam()) == FieldInterpolation::TricubicBSpline;
  const Bounds most = isCubic ? AskedFor : Bounds{0.015, 1.5 * Degree, 4.0 * Degree, 1.5};
  for (const double toolRadius : {0.0, 1.0})
  {
    SCOPED_TRACE(toolRadius);
    Random random(8107);
    const auto tracker = TrackerOf(*this->Model, ToolShape::Sphere(toolRadius));
    const auto truth = [&](const Vector3& probe) { return TrueProxy(search, probe, toolRadius); };
    ForceQuality quality;
    for (int path = 0; path < 1000; ++path)
    {
      // A shell's points may lie 0.05 voxel, 0.0125 N, above the place where a sphere touches
      // first.
      CompareOnPath(*tracker, RadialWalk(body, random), toolRadius, 0.02, truth, quality);
    }
    ExpectTruth(quality, most);
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, TouchTruthOnFields,
                         ::testing::Combine(::testing::ValuesIn(FieldCases),
                                            ::testing::Values(FieldInterpolation::Trilinear,
                                                              FieldInterpolation::TricubicBSpline)),
                         [](const auto& each)
                         {
                           const bool isCubic =
                               std::get<1>(each.param) == FieldInterpolation::TricubicBSpline;
                           return std::string(std::get<0>(each.param).Name) +
                                  (isCubic ? "Tricubic" : "Trilinear");
                         });

TEST(TouchTruth, FacetForcesAreIndependentOfTheUnitOfLength)
{
  constexpr double Scale = 0x1p-10; // a power of two changes no digit
  Random random(8108);
  const RadialModel body = test::BumpyBody(random);
  const test::Mesh mesh = test::MeshOf(body, 60); // 72,000 triangles
  test::Mesh metres = mesh;
  for (Vector3& point : metres.Points)
  {
    point *= Scale;
  }
  const auto here = TrackerOf(*test::FacetContact(mesh), ToolShape::Sphere(1.0));
  const auto there = TrackerOf(*test::FacetContact(metres), ToolShape::Sphere(Scale));
  WorstCase difference;
  int touches = 0;
  for (int path = 0; path < 300; ++path)
  {
    here->Release();
    there->Release();
    test::FollowTouchPath(RadialWalk(body, random), 1.0,
                          [&](const Vector3& probe)
                          {
                            const Contact& one = here->Follow(At(probe));
                            const Contact& other = there->Follow(At(Scale * probe));
                            difference.Add((one.ProxyWorld - other.ProxyWorld / Scale).norm());
                            touches += other.IsTouching ? 1 : 0;
                          });
  }
  EXPECT_GT(touches, 300 * 26);
  EXPECT_LE(difference.Value(), 1e-9); // rounding
}
} // namespace
} // namespace palpate::touch_truth_test
