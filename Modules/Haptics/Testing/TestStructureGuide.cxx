#include "StructureGuide.h"

#include "FeltCases.h"
#include "RandomOrientation.h"
#include "StiffnessAdvice.h"

#include <cmath>

namespace palpate::structure_guide_test
{
namespace
{
constexpr double Reach = 15.0;  // mm
constexpr double Radius = 12.0; // mm

double DistanceToSphere(const Vector3& place)
{
  return place.norm() - Radius;
}

// Two overlapping spheres: on the plane between them, both surfaces are equally near. There, the
// smaller distance is rounded within some millimetres, as a Gaussian does.
double DistanceToTwin(const Vector3& place)
{
  constexpr double Width = 0.6; // mm
  const Vector3 apart(8.0, 0.0, 0.0);
  const double one = (place - apart).norm();
  const double other = (place + apart).norm();
  return -Width * std::log(std::exp(-one / Width) + std::exp(-other / Width)) - 9.0;
}

std::shared_ptr<const StructureDistance>
DistanceField(const std::function<double(const Vector3&)>& distance, const Matrix3& turn)
{
  const auto field =
      test::FeltField(test::FeltGrid(68, turn), distance, FieldInterpolation::TricubicBSpline);
  std::shared_ptr<const StructureDistance> made;
  const Status status = StructureDistance::Make(field, Reach, made);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return made;
}

const std::shared_ptr<const StructureDistance>& Sphere()
{
  static const auto distance = DistanceField(DistanceToSphere, Matrix3::Identity());
  return distance;
}

const std::shared_ptr<const StructureDistance>& Twin()
{
  static test::Random random(90);
  static const auto distance = DistanceField(DistanceToTwin, test::RandomOrientation(random));
  return distance;
}

GuideSettings SettingsOf(GuideShape shape, double distance = 0.0)
{
  GuideSettings settings;
  settings.Shape = shape;
  settings.Structure = 3;
  settings.Distance = distance;
  settings.Stiffness = 0.1;
  settings.Range = 8.0;
  settings.LargestForce = 2.0;
  return settings;
}

std::shared_ptr<const StructureGuide> Made(const GuideSettings& settings,
                                           const std::shared_ptr<const StructureDistance>& distance)
{
  std::shared_ptr<const StructureGuide> guide;
  const Status status = StructureGuide::Make(settings, distance, guide);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return guide;
}

std::vector<GuideSettings> AllSettings()
{
  return {SettingsOf(GuideShape::Inside),       SettingsOf(GuideShape::Inside, -3.0),
          SettingsOf(GuideShape::Outside),      SettingsOf(GuideShape::Outside, 2.5),
          SettingsOf(GuideShape::Surface),      SettingsOf(GuideShape::Surface, 5.0),
          SettingsOf(GuideShape::Surface, -6.0)};
}

double LawAt(double distance)
{
  const double left = std::max(0.0, 1.0 - distance * distance / 64.0);
  return 0.1 * distance * left * left;
}

// N, along the outward direction, at a distance from the sphere.
double RadialForce(const StructureGuide& guide, double distance)
{
  const Vector3 out = Vector3(2.0, -1.0, 2.0) / 3.0;
  const Vector3 force = guide.ForceWorld((Radius + distance) * out);
  EXPECT_NEAR((force - force.dot(out) * out).norm(), 0.0, 2e-4);
  return force.dot(out);
}

// The distances of a sphere, on a grid of 1 mm, are right to some micrometres.
TEST(StructureGuide, FollowsItsLawOnASphere)
{
  const auto inside = Made(SettingsOf(GuideShape::Inside), Sphere());
  const auto outside = Made(SettingsOf(GuideShape::Outside, 2.0), Sphere());
  const auto surface = Made(SettingsOf(GuideShape::Surface, -1.0), Sphere());
  for (double distance = -7.5; distance < 10.0; distance += 0.375)
  {
    const double in = std::max(0.0, distance);
    const double out = std::min(0.0, distance - 2.0);
    EXPECT_NEAR(RadialForce(*inside, distance), -LawAt(in), 4e-4) << distance;
    EXPECT_NEAR(RadialForce(*outside, distance), -LawAt(out), 4e-4) << distance;
    EXPECT_NEAR(RadialForce(*surface, distance), -LawAt(distance + 1.0), 4e-4) << distance;
  }
}

TEST(StructureGuide, LeavesTheAllowedSideAlone)
{
  const auto inside = Made(SettingsOf(GuideShape::Inside, -3.0), Sphere());
  const auto outside = Made(SettingsOf(GuideShape::Outside, 2.5), Sphere());
  for (double distance = 0.1; distance < 9.0; distance += 0.3)
  {
    EXPECT_EQ(RadialForce(*inside, -3.0 - distance), 0.0);
    EXPECT_EQ(RadialForce(*outside, 2.5 + distance), 0.0);
  }
}

TEST(StructureGuide, EndsSmoothlyAtItsRange)
{
  const auto guide = Made(SettingsOf(GuideShape::Surface), Sphere());
  EXPECT_LT(std::abs(RadialForce(*guide, 7.98)), 1e-4);
  for (const double distance : {-11.9, -8.05, 8.05, 12.0, 40.0, 400.0})
  {
    EXPECT_EQ(RadialForce(*guide, distance), 0.0) << distance;
  }
}

TEST(StructureGuide, ForceIsMinusTheGradientOfItsPotential)
{
  test::Random random(91);
  std::uniform_real_distribution<double> coordinate(-24.0, 24.0);
  constexpr double Step = 1e-4; // mm
  for (const GuideSettings& settings : AllSettings())
  {
    const auto guide = Made(settings, Twin());
    double largest = 0.0;
    for (int n = 0; n < 5000; ++n)
    {
      const Vector3 place(coordinate(random), coordinate(random), coordinate(random));
      const Vector3 force = guide->ForceWorld(place);
      for (int axis = 0; axis < 3; ++axis)
      {
        const Vector3 step = Step * Vector3::Unit(axis);
        const double slope =
            (guide->PotentialAt(place + step) - guide->PotentialAt(place - step)) / (2.0 * Step);
        EXPECT_NEAR(force[axis], -slope, 1e-6);
      }
      largest = std::max(largest, force.norm());
    }
    EXPECT_GT(largest, 0.1);
  }
}

// The work on a straight piece by Gauss-Legendre quadrature with 5 points.
double WorkAlong(const StructureGuide& guide, const Vector3& from, const Vector3& to)
{
  constexpr double Places[3] = {0.0, 0.5384693101056831, 0.9061798459386640};
  constexpr double Weights[3] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  const Vector3 half = 0.5 * (to - from);
  const Vector3 centre = 0.5 * (to + from);
  Vector3 sum = Weights[0] * guide.ForceWorld(centre);
  for (int n = 1; n < 3; ++n)
  {
    sum += Weights[n] * (guide.ForceWorld(centre + Places[n] * half) +
                         guide.ForceWorld(centre - Places[n] * half));
  }
  return sum.dot(half);
}

// Closed polygons across the medial plane, the range's end and the surface. The quadrature's error,
// where a piece crosses the level or a face between cells, is of the third order of the piece: with
// 16 times the pieces it falls to nothing but rounding.
TEST(StructureGuide, ClosedPathsDoNoWork)
{
  test::Random random(92);
  std::uniform_real_distribution<double> coordinate(-20.0, 20.0);
  constexpr int Corners = 5;
  constexpr int Pieces = 40'000; // of an edge
  for (const GuideSettings& settings : AllSettings())
  {
    const auto guide = Made(settings, Twin());
    Vector3 corners[Corners];
    for (Vector3& corner : corners)
    {
      corner = {coordinate(random), coordinate(random), coordinate(random)};
    }
    double work = 0.0;
    double span = 0.0;
    for (int edge = 0; edge < Corners; ++edge)
    {
      const Vector3& from = corners[edge];
      const Vector3 along = corners[(edge + 1) % Corners] - from;
      for (int n = 0; n < Pieces; ++n)
      {
        const double piece = WorkAlong(*guide, from + (1.0 * n / Pieces) * along,
                                       from + ((n + 1.0) / Pieces) * along);
        work += piece;
        span += std::abs(piece);
      }
    }
    EXPECT_GT(span, 0.5); // N mm
    EXPECT_LE(std::abs(work), 1e-9 * span);
  }
}

TEST(StructureGuide, LargestForceAndEnergyHoldEverywhere)
{
  test::Random random(93);
  std::uniform_real_distribution<double> coordinate(-26.0, 26.0);
  for (GuideSettings settings : AllSettings())
  {
    for (const double largest : {0.05, 2.0})
    {
      settings.LargestForce = largest;
      const auto guide = Made(settings, Twin());
      double most = 0.0;
      for (int n = 0; n < 50'000; ++n)
      {
        const Vector3 place(coordinate(random), coordinate(random), coordinate(random));
        most = std::max(most, guide->ForceWorld(place).norm());
        EXPECT_GE(guide->PotentialAt(place), -guide->Energy());
        EXPECT_LE(guide->PotentialAt(place), 0.0);
      }
      EXPECT_LE(guide->Energy(), 0.1 * 64.0 / 6.0 * (1.0 + 1e-12));
      EXPECT_LE(most, std::min(largest, 1.06 * 0.2862168 * 0.1 * 8.0));
      EXPECT_GT(most, 0.85 * std::min(largest, 0.286 * 0.1 * 8.0));
    }
  }
}

// Across the plane between two spheres, where the nearest point jumps from the one to the other.
TEST(StructureGuide, ForceTurnsContinuouslyWhereTwoPartsAreEquallyNear)
{
  const Vector3 across = Vector3::UnitX();
  const Vector3 up = Vector3(0.0, 0.6, 0.8);
  const auto guide = Made(SettingsOf(GuideShape::Surface), Twin());
  constexpr double Step = 1e-3; // mm
  Vector3 before = guide->ForceWorld(12.0 * up - 3.0 * across);
  double turned = 0.0;
  for (double x = -3.0; x < 3.0; x += Step)
  {
    const Vector3 now = guide->ForceWorld(12.0 * up + x * across);
    EXPECT_LE((now - before).norm(), 1.2 * guide->Stiffness() * Step);
    turned = std::max(turned, std::abs(now.dot(across)));
    before = now;
  }
  EXPECT_GT(turned, 0.07) << "reaches from one side to the other";
  const Vector3 middle = guide->ForceWorld(12.0 * up);
  EXPECT_LT(std::abs(middle.dot(across)), 0.02);
}

TEST(StructureGuide, RejectsInvalidGuides)
{
  std::shared_ptr<const StructureGuide> guide;
  const auto isRefused = [&](const GuideSettings& settings)
  { return !StructureGuide::Make(settings, Sphere(), guide).IsOk(); };
  GuideSettings settings = SettingsOf(GuideShape::Surface);
  settings.Structure = 0;
  EXPECT_TRUE(isRefused(settings));
  EXPECT_TRUE(isRefused(SettingsOf(GuideShape::Inside, 7.1))) << "beyond the reach";
  EXPECT_TRUE(isRefused(SettingsOf(GuideShape::Inside, test::NotANumber)));
  settings = SettingsOf(GuideShape::Point);
  settings.PointsWorld = {Vector3::Zero()};
  EXPECT_TRUE(isRefused(settings)) << "has no structure";
  for (double GuideSettings::*number :
       {&GuideSettings::Stiffness, &GuideSettings::Range, &GuideSettings::LargestForce})
  {
    for (const double bad : {0.0, -1.0, test::NotANumber, test::Infinite})
    {
      settings = SettingsOf(GuideShape::Surface);
      settings.*number = bad;
      EXPECT_TRUE(isRefused(settings));
    }
  }
  EXPECT_FALSE(StructureGuide::Make(SettingsOf(GuideShape::Surface), nullptr, guide).IsOk());
  EXPECT_EQ(guide, nullptr);
}

TEST(StructureDistance, RejectsFieldsWithoutSmoothDistances)
{
  std::shared_ptr<const StructureDistance> made;
  const auto linear = test::FeltField(test::FeltGrid(10), DistanceToSphere);
  EXPECT_FALSE(StructureDistance::Make(linear, Reach, made).IsOk()) << "its gradient has steps";
  const auto far = test::FeltField(
      test::FeltGrid(10), [](const Vector3&) { return 90.0; }, FieldInterpolation::TricubicBSpline);
  EXPECT_FALSE(StructureDistance::Make(far, Reach, made).IsOk()) << "no surface";
  EXPECT_FALSE(StructureDistance::Make(nullptr, Reach, made).IsOk());
  EXPECT_EQ(made, nullptr);
}

TEST(StructureGuide, IsFiniteForHostilePlaces)
{
  test::Random random(94);
  const auto guide = Made(SettingsOf(GuideShape::Surface), Sphere());
  for (int n = 0; n < 20'000; ++n)
  {
    const Vector3 place = test::HostileVector(random);
    EXPECT_LE(guide->ForceWorld(place).norm(), 2.0);
    EXPECT_LE(guide->PotentialAt(place), 0.0);
  }
}

// Through the servo, without contact and with a frame of twice the scale.
TEST(StructureGuide, GuidesInAScene)
{
  TouchScene scene = test::WallScene(-50.0, {0.5, 0.0});
  scene.Frame = DeviceFrame(Matrix3::Identity(), 2.0, Vector3::Zero());
  const auto guide = Made(SettingsOf(GuideShape::Outside), Sphere());
  scene.Fields = {guide};
  test::ServoRun run(scene);
  run.RestAt({0.0, 0.0, 7.0});
  EXPECT_EQ(run.TickAt({0.0, 0.0, 7.0}).norm(), 0.0);
  for (int n = 0; n < 400; ++n)
  {
    const Vector3 hand(0.0, 0.0, 7.0 - 0.005 * n);
    EXPECT_NEAR((run.TickAt(hand) - guide->ForceWorld(2.0 * hand)).norm(), 0.0, 1e-13);
  }
  EXPECT_GT(run.TickAt({0.0, 0.0, 5.0}).z(), 0.1);
}

TEST(StructureGuide, WarningsIncludeIt)
{
  DeviceCapabilities device;
  device.MaximumStiffness = 0.55;
  TouchScene scene = test::WallScene(0.0, {0.5, 0.0});
  EXPECT_TRUE(StiffnessWarnings(scene, device, 1000.0).empty());
  scene.Fields = {Made(SettingsOf(GuideShape::Surface), Sphere())};
  EXPECT_EQ(StiffnessWarnings(scene, device, 1000.0).size(), 1U);
}
} // namespace
} // namespace palpate::structure_guide_test
