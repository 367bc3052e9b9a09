// The reference of a mask against the exact body that it was made from.

#include "TradeReference.h"

#include "IcosahedronDirections.h"
#include "MeshConversion.h"
#include "StructureTrade.h"
#include "TradeAdvice.h"
#include "TradeCases.h"
#include "TradeErrors.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace palpate::trade_reference_test
{
namespace
{
using test::GoOn;

// An ellipsoid around the origin, as a mask and exactly.
struct Ellipsoid
{
  Vector3 SemiAxes; // mm
  double TiltDegrees = 0.0;

  Matrix3 Axes() const
  {
    const Vector3 about = Vector3(1.0, 2.0, 0.5).normalized();
    return Eigen::AngleAxisd(this->TiltDegrees * M_PI / 180.0, about).toRotationMatrix() *
           this->SemiAxes.asDiagonal();
  }
  test::MaskTrade Mask(const Vector3& spacing) const
  {
    const double reach = this->SemiAxes.maxCoeff() + 6.0;
    std::array<int, 3> size{};
    for (int axis = 0; axis < 3; ++axis)
    {
      size[static_cast<std::size_t>(axis)] = static_cast<int>(2.0 * reach / spacing[axis]);
    }
    const Matrix3 toBall = this->Axes().inverse();
    return test::MaskTrade([&toBall](double x, double y, double z)
                           { return (toBall * Vector3(x, y, z)).norm() < 1.0; },
                           test::MaskTrade::GridOf(size, {{spacing[0], spacing[1], spacing[2]}}));
  }
  // Facets that lie at most 0.01 mm below it.
  std::unique_ptr<TradeReference> Exact(const TouchToolSettings& tool) const
  {
    const IcosahedronDirections sphere(40);
    IndexedMesh mesh;
    for (const Vector3& direction : sphere.Directions())
    {
      mesh.Points.push_back(this->Axes() * direction);
    }
    mesh.Triangles = sphere.Triangles();
    return FacetReference(MakeFacetContact(ToPolyData(mesh), "ellipsoid"), tool);
  }
};

// How far the reference is from the exact body, along its path.
struct Deviation
{
  std::vector<double> Apart;       // mm, of the proxies
  std::vector<double> Uncertainty; // mm

  double PartWithin(double times) const
  {
    std::size_t within = 0;
    for (std::size_t tick = 0; tick < this->Apart.size(); ++tick)
    {
      within += this->Apart[tick] <= times * this->Uncertainty[tick] ? 1 : 0;
    }
    return static_cast<double>(within) / static_cast<double>(this->Apart.size());
  }
};

Deviation DeviationOf(const TradePath& path, TradeReference& exact)
{
  Deviation deviation;
  for (std::size_t stroke = 0; stroke < path.Strokes.size(); ++stroke)
  {
    exact.Begin(path.Ticks[path.Strokes[stroke]].ProbeWorld);
    for (std::size_t tick = path.Strokes[stroke]; tick < path.EndOf(stroke); ++tick)
    {
      const TradePath::Tick& one = path.Ticks[tick];
      const TradePosition is = exact.At(one.ProbeWorld);
      if (one.Truth.IsKnown && is.IsTouching)
      {
        deviation.Apart.push_back((is.ProxyWorld - one.Truth.ProxyWorld).norm());
        deviation.Uncertainty.push_back(one.Truth.Uncertainty);
      }
    }
  }
  return deviation;
}

constexpr double Slices = 3.0; // mm, thick ones of pixels of 0.6 mm
const Vector3 ThickVoxels(0.6, 0.6, Slices);

TEST(TradeReference, ExactBodiesLieWithinTheUncertainty)
{
  const std::vector<Ellipsoid> bodies{{Vector3(30.0, 20.0, 12.0)},
                                      {Vector3(30.0, 20.0, 12.0), 35.0},
                                      {Vector3(12.0, 12.0, 12.0)},
                                      {Vector3(25.0, 20.0, 4.0), 20.0}};
  for (const Ellipsoid& body : bodies)
  {
    for (const Vector3& spacing : {ThickVoxels, Vector3(1.0, 1.0, 1.0)})
    {
      const test::MaskTrade mask = body.Mask(spacing);
      StructureTrade trade = mask.Trade();
      const auto exact = body.Exact(mask.Scene.Tool);
      const Deviation deviation = DeviationOf(trade.MeasuredPath(GoOn), *exact);
      const std::string what = "semi-axis " + std::to_string(body.SemiAxes[2]) + " tilted by " +
                               std::to_string(body.TiltDegrees) + ", slices of " +
                               std::to_string(spacing[2]);
      // A few strokes have some dozens of independent places: 95 % less what that leaves open.
      EXPECT_GT(deviation.PartWithin(1.0), 0.9) << what;
      EXPECT_GT(deviation.PartWithin(2.0), 0.99) << what;
      // And it is not worth nothing: no more than a slice's spacing along its normal, on average
      // far less.
      EXPECT_LT(MeanOf(deviation.Uncertainty), 0.6 * spacing[2]) << what;
    }
  }
}

// Against the exact body, degree 8 has a smaller mean error than the tricubic field; the mask alone
// cannot tell.
TEST(TradeReference, SettingsThatTheMaskCannotTellApartAreEqual)
{
  const Ellipsoid body{Vector3(30.0, 20.0, 12.0)};
  const test::MaskTrade mask = body.Mask(ThickVoxels);
  StructureTrade trade = mask.Trade();
  ContactSetting harmonics = SettingOf(mask.Scene, TouchRepresentation::Harmonics);
  harmonics.Structure.Degree = 8;
  std::vector<TradeRow> rows{
      trade.Measure(harmonics, GoOn),
      trade.Measure(mask.SubVoxel(FieldInterpolation::TricubicBSpline, 98), GoOn)};
  const auto exact = body.Exact(mask.Scene.Tool);
  const TradePath path = MakeTradePath(*exact, mask.Scene.Tool, test::ShortPath().Path, GoOn);
  const auto errorOf = [&](const TradeRow& row)
  {
    TradeTouch touch;
    touch.Tool.Points = row.Setting.ToolPoints;
    touch.Runs = 1;
    TradeRow judged;
    MeasureTouch(*trade.ContactFor(row.Setting, GoOn)->Model, touch, path, test::StillClock(),
                 judged, GoOn);
    return judged.PositionMean;
  };
  for (TradeRow& row : rows)
  {
    row.CostSeconds = row.Setting.Structure.Degree == 8 ? 1.0 : 2.0; // whatever the machine
    row.Rate = 1e5;
  }
  EXPECT_LT(errorOf(rows[0]), errorOf(rows[1]));
  const TradeAdvice advice = AdviseOn(rows, 1000.0);
  EXPECT_EQ(advice.Row, 0U) << advice.Message;
  EXPECT_TRUE(advice.IsMet) << advice.Message;
  harmonics.Structure.Degree = 4; // follows terraces
  rows[0] = trade.Measure(harmonics, GoOn);
  rows[0].CostSeconds = 1.0;
  rows[0].Rate = 1e5;
  EXPECT_GT(errorOf(rows[0]), errorOf(rows[1]));
  EXPECT_EQ(AdviseOn(rows, 1000.0).Row, 1U) << "degree 4";
}

// A box with a step of four thick slices at x = 0.
test::MaskTrade TerracedBox()
{
  return test::MaskTrade(
      [](double x, double y, double z) {
        return std::abs(x) < 14.0 && std::abs(y) < 14.0 && z > -9.0 && z < (x < 0.0 ? 9.0 : -3.0);
      },
      test::MaskTrade::GridOf({{64, 64, 12}}, {{0.6, 0.6, Slices}}));
}

// Adds a stroke of a hand that goes straight from point to point; a reference's proxy is known at
// each of these and in between.
struct Waypoint
{
  Vector3 Probe;
  Vector3 Proxy;
  Vector3 Normal;
};

void AddStroke(const std::vector<Waypoint>& points, TradePath& path)
{
  constexpr double Step = 0.05; // mm
  path.Strokes.push_back(path.Ticks.size());
  for (std::size_t n = 1; n < points.size(); ++n)
  {
    const Waypoint& from = points[n - 1];
    const Waypoint& to = points[n];
    const int steps = static_cast<int>((to.Probe - from.Probe).norm() / Step) + 1;
    for (int step = 0; step < steps; ++step)
    {
      const double part = static_cast<double>(step) / steps;
      const Vector3 probe = from.Probe + part * (to.Probe - from.Probe);
      const Vector3 proxy = from.Proxy + part * (to.Proxy - from.Proxy);
      const bool isTouching = (proxy - probe).norm() > 1e-9;
      path.Ticks.push_back({probe, {isTouching, proxy, to.Normal, true}});
    }
  }
}

// A reference whose side slants slides down it; the tool is held on the flat terrace above, 10 mm
// from the hand.
TEST(TradeReference, HandThatPartsAtATerraceIsCountedAndLeftOut)
{
  const test::MaskTrade box = TerracedBox();
  StructureTrade trade = box.Trade();
  TradeTouch touch;
  touch.Runs = 1;
  const double top = 9.0 + touch.Tool.Radius;
  TradePath path;
  path.MostDepth = 2.0;
  const auto above = [&](double x, double height)
  {
    return Waypoint{Vector3(x, 0.0, height), Vector3(x, 0.0, std::max(height, top)),
                    Vector3::UnitZ()};
  };
  const auto beside = [&](double height) {
    return Waypoint{Vector3(-2.0, 0.0, height), Vector3(0.0, 0.0, height), Vector3::UnitX()};
  };
  AddStroke({above(-8.0, top + 2.0), above(-8.0, top - 1.0), above(-4.0, top - 1.0)}, path);
  AddStroke({above(-8.0, top + 2.0), above(-8.0, top - 1.0), above(-4.0, top - 1.0),
             beside(top - 1.0), beside(top - 10.0)},
            path);
  const auto contact = trade.ContactFor(box.SubVoxel(FieldInterpolation::Trilinear, 26), GoOn);
  TradeRow row;
  MeasureTouch(*contact->Model, touch, path, test::StillClock(), row, GoOn);
  EXPECT_EQ(row.Parted, 1.0);
  EXPECT_EQ(row.Seizures, 0.0);
  // On the terrace, whose height the slices leave open by half of one.
  EXPECT_LT(row.PositionMost, 0.5 * Slices);
  path.Ticks.resize(path.Strokes.back());
  path.Strokes.pop_back();
  TradeRow alone;
  MeasureTouch(*contact->Model, touch, path, test::StillClock(), alone, GoOn);
  EXPECT_EQ(alone.Parted, 0.0);
  EXPECT_EQ(row.PositionMean, alone.PositionMean) << "the other stroke takes no part";
}

// A person is guided by what the tool itself feels, and so never presses that deep.
TEST(TradeReference, HandGuidedByWhatItFeelsDoesNotPartAtATerrace)
{
  const test::MaskTrade box = TerracedBox();
  StructureTrade trade = box.Trade();
  const auto felt =
      FieldReference(*trade.ContactFor(box.SubVoxel(FieldInterpolation::Trilinear, 26), GoOn),
                     "the measured setting", box.Scene.Tool);
  const TradePath path = MakeTradePath(*felt, box.Scene.Tool, test::ShortPath().Path, GoOn);
  double deepest = 0.0;
  for (const TradePath::Tick& tick : path.Ticks)
  {
    deepest = std::max(deepest, (tick.Truth.ProxyWorld - tick.ProbeWorld).norm());
  }
  EXPECT_LT(deepest, 2.0 * path.MostDepth);
}
} // namespace
} // namespace palpate::trade_reference_test
