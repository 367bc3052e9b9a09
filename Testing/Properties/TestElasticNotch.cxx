#include "ContactTracker.h"
#include "DentedSurface.h"
#include "ElasticContactModel.h"
#include "ElasticForce.h"
#include "ElasticTracker.h"
#include "IcosahedronDirections.h"
#include "OrganSoftening.h"
#include "SphericalHarmonicProjection.h"
#include "ToolPose.h"
#include "ToolShape.h"
#include "Units.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// A ball pressed into a cleft of 90 degrees in an elastic organ, against finite elements of another
// program (Utilities/elastic_reference.py), and what has to hold without a reference.
namespace palpate::elastic_notch_test
{
namespace
{
const nlohmann::json& Reference()
{
  static const nlohmann::json reference =
      nlohmann::json::parse(std::ifstream(std::string(PALPATE_ELASTIC_REFERENCES) + "/notch.json"));
  return reference;
}

// As in the reference: the nearer of a sphere and of two planes with a fillet, blended.
double RadiusAt(const Vector3& direction)
{
  constexpr double Far = 1e3;
  const auto& shape = Reference()["shape"];
  const double edge = shape["edge_mm"];
  const double fillet = shape["fillet_mm"];
  const double blend = shape["blend_mm"];
  const double x = std::abs(direction.x());
  const double z = direction.z();
  double cleft = z > x ? std::min(Far, edge / std::max(z - x, 1e-9)) : Far;
  const double middle = edge + std::sqrt(2.0) * fillet;
  const double square = x * x + z * z;
  const double root = middle * z * middle * z - square * (middle * middle - fillet * fillet);
  if (z > x && root > 0.0)
  {
    const double hollow = (middle * z - std::sqrt(root)) / square;
    cleft = hollow * x < fillet / std::sqrt(2.0) ? hollow : cleft;
  }
  const double sphere = shape["radius_mm"];
  const double least = std::min(sphere, cleft);
  return least -
         blend * std::log(std::exp((least - sphere) / blend) + std::exp((least - cleft) / blend));
}

RadialModel NotchModel()
{
  const auto& shape = Reference()["shape"];
  const int degree = shape["degree"];
  const double smoothing = shape["smoothing"];
  std::vector<double> coefficients = ProjectOnHarmonics(degree, 4 * degree, RadiusAt);
  for (int l = 0; l <= degree; ++l)
  {
    for (int i = l * l; i < (l + 1) * (l + 1); ++i)
    {
      coefficients[static_cast<std::size_t>(i)] *= std::exp(-smoothing * l * (l + 1));
    }
  }
  return {degree, coefficients, Vector3::Zero()};
}

// Elements of 3 mm carry the harmonics that a cleft of that size needs.
struct Notch
{
  std::shared_ptr<const RadialModel> Model;
  ComplianceMaps Maps;
  std::shared_ptr<const ContactModel> Contact;
};

Notch MakeNotch()
{
  Notch notch{std::make_shared<const RadialModel>(NotchModel()), {}, nullptr};
  const double tissue = Reference()["tissue_kpa"];
  const double bed = Reference()["bed_kpa_per_mm"];
  const ElasticSolid solid{TissueMap(1e-3 * tissue), Reference()["poisson_ratio"],
                           ElasticBed(1e-3 * bed)};
  OrganSoftening softening;
  softening.ElementsAcross = 12;
  softening.Maps.Degree = 20;
  OrganSoftening::Account account;
  Status status = softening.Make(*notch.Model, solid, {}, notch.Maps, account);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  status = ElasticContactModel::Make(notch.Model, notch.Maps, notch.Contact);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return notch;
}

const Notch& TheNotch()
{
  static const Notch notch = MakeNotch();
  return notch;
}

// A ball over the cleft, without friction.
class Hand
{
public:
  explicit Hand(double ball)
  {
    const Status status =
        TheNotch().Contact->MakeTracker(ToolShape::Sphere(ball), {}, this->Tracker);
    EXPECT_TRUE(status.IsOk()) << status.Message();
  }

  const ElasticForce& MoveTo(const Vector3& place)
  {
    return *this->Tracker->Follow({place, Eigen::Quaterniond::Identity()}).Elastic;
  }
  const ElasticForce& PressAt(const Vector3& place)
  {
    for (double height = 14.0; height > 0.0; height -= 0.05)
    {
      this->MoveTo(place + height * Vector3::UnitZ());
    }
    return this->MoveTo(place);
  }
  // Where it presses.
  std::vector<PressedPlace> Places() const
  {
    const auto& tracker = dynamic_cast<const ElasticTracker&>(*this->Tracker);
    return {tracker.Places(), tracker.Places() + tracker.PlaceCount()};
  }

private:
  std::unique_ptr<ContactTracker> Tracker;
};

Vector3 VectorOf(const nlohmann::json& numbers)
{
  return Vector3(numbers[0].get<double>(), numbers[1].get<double>(), numbers[2].get<double>());
}

// Height of the centre of a ball that touches both walls.
double TouchingHeight(double ball)
{
  for (const auto& press : Reference()["presses"])
  {
    if (press["ball_radius_mm"] == ball && press["center_mm"][0] == 0.0)
    {
      return press["center_mm"][2].get<double>() + press["depth_mm"].get<double>();
    }
  }
  ADD_FAILURE() << "no ball of " << ball << " mm in the reference";
  return 0.0;
}

// Root mean square, over the presses of a ball, of the force's error as a vector relative to the
// reference's size.
TEST(ElasticNotch, ForceIsThatOfFiniteElements)
{
  constexpr double Most = 0.10;
  std::map<double, std::vector<double>> errors;
  for (const auto& press : Reference()["presses"])
  {
    const double ball = press["ball_radius_mm"];
    const Vector3 wanted = VectorOf(press["force_n"]);
    const Vector3 force = Hand(ball).PressAt(VectorOf(press["center_mm"])).ForceWorld;
    errors[ball].push_back((force - wanted).norm() / wanted.norm());
    RecordProperty("ball" + std::to_string(static_cast<int>(ball)) + "press" +
                       std::to_string(errors[ball].size()),
                   std::to_string(errors[ball].back()));
  }
  ASSERT_EQ(errors.size(), 2U);
  for (const auto& [ball, parts] : errors)
  {
    double squares = 0.0;
    for (const double part : parts)
    {
      squares += part * part;
    }
    EXPECT_LE(std::sqrt(squares / static_cast<double>(parts.size())), Most) << ball;
  }
}

// Across the cleft in steps of 0.01 mm, from one wall to both and to the other. A single wall takes
// 0.005 N a step at this depth.
TEST(ElasticNotch, ForceDoesNotJumpWhereTheOtherWallTakesHold)
{
  constexpr double Aside = 5.0;  // mm
  constexpr double Step = 0.01;  // mm
  constexpr double Most = 0.008; // N
  for (const auto& [ball, depth] : {std::pair(4.0, 2.0), std::pair(8.0, 2.0), std::pair(8.0, 4.0)})
  {
    Hand hand(ball);
    Vector3 place(-Aside, 0.0, TouchingHeight(ball) - depth);
    Vector3 last = hand.PressAt(place).ForceWorld;
    double most = 0.0;
    for (; place.x() < Aside; place.x() += Step)
    {
      const Vector3 force = hand.MoveTo(place).ForceWorld;
      most = std::max(most, (force - last).norm());
      last = force;
    }
    EXPECT_LE(most, Most) << ball << " mm, " << depth << " mm deep";
  }
}

TEST(ElasticNotch, ClosedLoopsTakeNoWork)
{
  constexpr int Ticks = 4000;
  constexpr double Most = 1e-3; // of the energy's span
  const auto across = [](double angle)
  { return Vector3(2.0 * std::sin(angle), 0.0, 0.8 * (1.0 - std::cos(angle))); };
  const auto along = [](double angle)
  {
    return Vector3(0.8 * std::sin(angle), 2.0 * std::sin(angle),
                   0.5 * (1.0 - std::cos(angle)) + 0.3 * std::sin(2.0 * angle));
  };
  const auto aside = [](double angle)
  { return Vector3(1.5 + 1.5 * std::cos(angle), std::sin(angle), 1.0 + std::sin(angle)); };
  for (const auto& [ball, depth] : {std::pair(4.0, 2.0), std::pair(8.0, 2.0), std::pair(8.0, 4.0)})
  {
    for (const std::function<Vector3(double)>& loop :
         std::vector<std::function<Vector3(double)>>{across, along, aside})
    {
      Hand hand(ball);
      const Vector3 bottom(0.0, 0.0, TouchingHeight(ball) - depth);
      ElasticForce last = hand.PressAt(bottom + loop(0.0));
      Vector3 lastPlace = bottom + loop(0.0);
      double work = 0.0;
      double least = last.Energy;
      double most = last.Energy;
      for (int tick = 1; tick <= Ticks; ++tick)
      {
        const Vector3 place = bottom + loop(2.0 * Pi * tick / Ticks);
        const ElasticForce& force = hand.MoveTo(place);
        work += 0.5 * (force.ForceWorld + last.ForceWorld).dot(place - lastPlace);
        least = std::min(least, force.Energy);
        most = std::max(most, force.Energy);
        last = force;
        lastPlace = place;
      }
      EXPECT_GT(most - least, 0.1); // N mm
      EXPECT_LE(std::abs(work), Most * (most - least)) << ball << " mm, " << depth << " mm deep";
    }
  }
}

TEST(ElasticNotch, WallsPushAlike)
{
  for (const double ball : {4.0, 8.0})
  {
    for (const double aside : {0.0, 0.3, 1.0, 3.0})
    {
      const double height = TouchingHeight(ball) - 2.0;
      const Vector3 one = Hand(ball).PressAt(Vector3(aside, 0.5, height)).ForceWorld;
      const Vector3 other = Hand(ball).PressAt(Vector3(-aside, 0.5, height)).ForceWorld;
      EXPECT_LE((Vector3(-one.x(), one.y(), one.z()) - other).norm(), 1e-3 * one.norm())
          << ball << " mm, " << aside << " mm aside";
    }
  }
}

// Of vertices that lie mirrored at the cleft.
TEST(ElasticNotch, BothWallsAreDrawnOnTheBall)
{
  constexpr double Depth = 2.0;
  constexpr double Close = 0.05; // mm
  const IcosahedronDirections mesh(40);
  std::vector<Vector3> directions = mesh.Directions();
  for (const Vector3& direction : mesh.Directions())
  {
    directions.emplace_back(-direction.x(), direction.y(), direction.z());
  }
  const DentedSurface surface(*TheNotch().Model, TheNotch().Maps, directions);
  for (const double ball : {4.0, 8.0})
  {
    const Vector3 center(0.0, 0.0, TouchingHeight(ball) - Depth);
    Hand hand(ball);
    hand.PressAt(center);
    ASSERT_EQ(hand.Places().size(), 2U);
    const auto points = surface.PointsWorld({center, ball, hand.Places()});
    const std::size_t half = mesh.Directions().size();
    double farthest = 0.0; // that a vertex moves
    for (std::size_t i = 0; i < half; ++i)
    {
      const Vector3& other = points[half + i];
      EXPECT_LT((points[i] - Vector3(-other.x(), other.y(), other.z())).norm(), Close);
      EXPECT_GT((points[i] - center).norm(), ball - 1e-9);
      farthest = std::max(farthest, (points[i] - surface.RestWorld()[i]).norm());
    }
    EXPECT_GT(farthest, 0.5 * Depth);
    for (const auto& [a, b, c] : mesh.Triangles())
    {
      const Vector3 middle =
          (points[static_cast<std::size_t>(a)] + points[static_cast<std::size_t>(b)] +
           points[static_cast<std::size_t>(c)]) /
          3.0;
      EXPECT_GT((middle - center).norm(), ball - 0.1);
    }
  }
}
} // namespace
} // namespace palpate::elastic_notch_test
