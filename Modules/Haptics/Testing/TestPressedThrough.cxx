// Thin structures hold a tool that is pressed on, however deep and fast, and until it slides off.
#include "ElasticContactModel.h"
#include "ExtremeCases.h"
#include "OrganContact.h"
#include "RandomOrientation.h"
#include "ServoRun.h"
#include "SomeMaps.h"
#include "SurfacePhantoms.h"

#include <functional>

namespace palpate::pressed_through_test
{
namespace
{
using test::Random;

// A structure whose top is at the origin of a frame, with its normal along z.
struct Thin
{
  std::string Name;
  std::shared_ptr<const ContactModel> Model;
  Matrix3 Rotation;
  Vector3 Top;
  bool IsElastic = false;
};

constexpr double Half = 15.0;     // mm, of plates
constexpr double Thickness = 1.0; // mm
constexpr double Stiffness = 0.5; // N/mm
constexpr double Clamp = 8.0;     // N, of the device
constexpr double Rough = 0.03;    // N, of proxies on facets and in voxels

// Height above the surface (mm) of bodies whose top is z = 0, negative inside.
using Height = std::function<double(const Vector3&)>;

double BoxHeight(const Vector3& p, const Vector3& half)
{
  return (p.cwiseAbs() - half).maxCoeff();
}

const std::vector<std::pair<std::string, Height>>& Bodies()
{
  static const std::vector<std::pair<std::string, Height>> bodies = {
      {"plate",
       [](const Vector3& p) {
         return BoxHeight(p + Vector3(0.0, 0.0, 0.5 * Thickness), {Half, Half, 0.5 * Thickness});
       }},
      {"disc",
       [](const Vector3& p)
       {
         return std::max(p.head<2>().norm() - Half,
                         std::abs(p[2] + 0.5 * Thickness) - 0.5 * Thickness);
       }},
      {"shell",
       [](const Vector3& p)
       {
         const double r = (p + Vector3(0.0, 0.0, Half)).norm();
         return std::max(r - Half, Half - Thickness - r);
       }},
      // Its lower side rises to the edge at x = 15 mm.
      {"wedge", [](const Vector3& p)
       {
         const double lower = -0.1 * (Half - p[0]) - 0.3;
         return std::max({p[2], lower - p[2], std::abs(p[0]) - Half, std::abs(p[1]) - Half});
       }}};
  return bodies;
}

struct Inside
{
  const Height& Above;
  Vector3 First; // mm
  double Voxel;  // mm
  double Value(const Vector3& index) const
  {
    return -this->Above(this->First + this->Voxel * index);
  }
};

Thin OfVoxels(const std::string& name, const Height& height, Random& random)
{
  constexpr int Size = 84;
  constexpr double Voxel = 0.5;
  const Matrix3 rotation = test::RandomOrientation(random).matrix();
  const Vector3 top = 10.0 * test::RandomDirection(random);
  // The bodies lie between -30 and 0 mm along z; a plate is near the top.
  const Vector3 middle(0.0, 0.0, name == "shell" ? -Half : 0.0);
  const Vector3 origin = top + rotation * (middle - Vector3::Constant(0.5 * Voxel * (Size - 1)));
  const FieldGrid grid({Size, Size, Size}, origin, Vector3::Constant(Voxel), rotation);
  const Vector3 first = middle - Vector3::Constant(0.5 * Voxel * (Size - 1));
  const auto field = test::SampledField(grid, Inside{height, first, Voxel});
  return {name + " of voxels", test::FieldContact(field), rotation, top};
}

// The upper and the lower side as grids of squares, joined by a wall; of single precision, as files
// have them.
test::Mesh Sheet(const std::function<double(const Vector3&)>& lower)
{
  constexpr int Squares = 20;
  test::Mesh mesh;
  const auto number = [](int i, int j, int side)
  { return side * (Squares + 1) * (Squares + 1) + j * (Squares + 1) + i; };
  for (int side = 0; side < 2; ++side)
  {
    for (int j = 0; j <= Squares; ++j)
    {
      for (int i = 0; i <= Squares; ++i)
      {
        Vector3 p((2.0 * i / Squares - 1.0) * Half, (2.0 * j / Squares - 1.0) * Half, 0.0);
        p[2] = side == 0 ? 0.0 : lower(p);
        mesh.Points.push_back(p);
      }
    }
  }
  const auto square = [&mesh](int a, int b, int c, int d)
  {
    mesh.Triangles.push_back({a, b, c});
    mesh.Triangles.push_back({a, c, d});
  };
  for (int j = 0; j < Squares; ++j)
  {
    for (int i = 0; i < Squares; ++i)
    {
      square(number(i, j, 0), number(i + 1, j, 0), number(i + 1, j + 1, 0), number(i, j + 1, 0));
      square(number(i, j, 1), number(i, j + 1, 1), number(i + 1, j + 1, 1), number(i + 1, j, 1));
    }
    square(number(j, 0, 0), number(j, 0, 1), number(j + 1, 0, 1), number(j + 1, 0, 0));
    square(number(j, Squares, 0), number(j + 1, Squares, 0), number(j + 1, Squares, 1),
           number(j, Squares, 1));
    square(number(0, j, 0), number(0, j + 1, 0), number(0, j + 1, 1), number(0, j, 1));
    square(number(Squares, j, 0), number(Squares, j, 1), number(Squares, j + 1, 1),
           number(Squares, j + 1, 0));
  }
  return mesh;
}

test::Mesh Shell()
{
  const auto sphere = [](double radius)
  {
    const RadialModel model(0, {radius * std::sqrt(4.0 * M_PI)}, Vector3(0.0, 0.0, -Half));
    return test::MeshOf(model, 16);
  };
  test::Mesh inner = sphere(Half - Thickness);
  for (FacetTree::Triangle& t : inner.Triangles)
  {
    std::swap(t[0], t[1]);
  }
  return test::Joined(sphere(Half), inner);
}

Thin OfFacets(const std::string& name, const test::Mesh& mesh, Random& random)
{
  const Matrix3 rotation = test::RandomOrientation(random).matrix();
  const Vector3 top = 10.0 * test::RandomDirection(random);
  test::Mesh moved = test::Moved(mesh, rotation, top);
  for (Vector3& point : moved.Points)
  {
    point = point.cast<float>().cast<double>();
  }
  return {name + " of facets", test::FacetContact(moved), rotation, top};
}

Thin OfHarmonics(Random& random)
{
  const Matrix3 rotation = test::RandomOrientation(random).matrix();
  const RadialModel lens = test::Ellipsoid({20.0, 20.0, 5.0}, rotation, 16);
  const Vector3 top = lens.PointWorld(rotation.col(2));
  return {"lens of harmonics", test::RadialContact(lens), rotation, top};
}

Thin OfSurfaceModel()
{
  const Vector3 axes(20.0, 20.0, 0.6);
  Thin thin{"plate as a surface model", nullptr, Matrix3::Identity(), {12.0, -7.0, 40.6}};
  const Status status = MakeOrganContact(test::EllipsoidPhantom(axes), thin.Model);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return thin;
}

Thin Yielding(Random& random)
{
  Thin thin = OfHarmonics(random);
  thin.Name = "lens that yields";
  thin.IsElastic = true;
  const RadialModel lens = test::Ellipsoid({20.0, 20.0, 5.0}, thin.Rotation, 16);
  const Status status = ElasticContactModel::Make(test::Shared(lens), test::SomeMaps(), thin.Model);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return thin;
}

std::vector<Thin> ThinStructures()
{
  Random random(1960);
  std::vector<Thin> all;
  for (const auto& [name, height] : Bodies())
  {
    all.push_back(OfVoxels(name, height, random));
  }
  all.push_back(OfFacets("plate", Sheet([](const Vector3&) { return -Thickness; }), random));
  all.push_back(OfFacets(
      "wedge", Sheet([](const Vector3& p) { return -0.1 * (Half - p[0]) - 0.3; }), random));
  all.push_back(OfFacets("shell", Shell(), random));
  all.push_back(OfHarmonics(random));
  all.push_back(OfSurfaceModel());
  all.push_back(Yielding(random));
  return all;
}

TouchScene SceneOf(const Thin& thin, double toolRadius)
{
  TouchScene scene;
  scene.Tool = ToolShape::Sphere(toolRadius);
  scene.Structures.push_back({thin.Name, thin.Model, {Stiffness, 0.0}, {}});
  return scene;
}

// Presses along `path` (mm, in the structure's frame) from 4 mm above, `step` mm a tick; below the
// clamp the force never falls.
void ExpectHeld(const Thin& thin, double toolRadius, const Vector3& path, double step)
{
  test::ServoRun run(SceneOf(thin, toolRadius));
  const Vector3 from(0.3, -0.4, 4.0 + toolRadius);
  const auto place = [&](double part) -> Vector3
  { return thin.Top + thin.Rotation * (from + part * path); };
  run.RestAt(place(0.0));
  const int ticks = static_cast<int>(std::ceil(path.norm() / step));
  double largest = 0.0;
  for (int tick = 1; tick <= ticks; ++tick)
  {
    const double force = run.TickAt(place(1.0 * tick / ticks)).norm();
    ASSERT_GE(force, std::min(largest, Clamp - 0.5) - Rough)
        << thin.Name << ", tool " << toolRadius << " mm, " << step << " mm a tick, at "
        << (from + (1.0 * tick / ticks) * path).transpose();
    largest = std::max(largest, force);
  }
  const double force = run.RestAt(place(1.0)).norm();
  ASSERT_EQ(run.Loop.Latest().Safety.Fault, SafetyFault::None);
  // Of the way past the surface, less what a tool slides on a curved one.
  const double deep = Stiffness * (-path[2] - 4.0);
  EXPECT_GE(force, thin.IsElastic ? largest - Rough : 0.85 * std::min(deep, Clamp)) << thin.Name;
}

TEST(PressedThrough, ForceNeverFallsWhileTheHandPushesOn)
{
  Random random(7);
  for (const Thin& thin : ThinStructures())
  {
    // What yields has no point tool.
    for (const double toolRadius : {thin.IsElastic ? 0.5 : 0.0, 1.0, 2.0})
    {
      for (const double step : {0.02, 0.3, 2.0})
      {
        const Vector3 aside = 0.25 * test::RandomDirection(random);
        const Vector3 path = 14.0 * Vector3(aside[0], aside[1], -1.0);
        ASSERT_NO_FATAL_FAILURE(ExpectHeld(thin, toolRadius, path, step));
      }
    }
  }
}

// A hand below a plate goes on aside until the tool slides off, and comes back below it.
TEST(PressedThrough, ToolThatSlidOffIsFreeBehindAndPressedFromThere)
{
  Random random(8);
  for (const Thin& thin :
       {OfVoxels("plate", Bodies()[0].second, random), OfVoxels("disc", Bodies()[1].second, random),
        OfFacets("plate", Sheet([](const Vector3&) { return -Thickness; }), random)})
  {
    for (const double toolRadius : {0.0, 1.0})
    {
      test::ServoRun run(SceneOf(thin, toolRadius));
      const auto move = [&](const Vector3& from, const Vector3& to)
      {
        return Vector3(thin.Rotation.transpose() * run.MoveAndRest(thin.Top + thin.Rotation * from,
                                                                   thin.Top + thin.Rotation * to));
      };
      const Vector3 above(0.3, -0.4, 5.0);
      const Vector3 below(0.3, -0.4, -6.0);
      const Vector3 aside(Half + 4.0, -0.4, -6.0);
      EXPECT_GT(move(above, below)[2], Stiffness * 5.0) << thin.Name;
      EXPECT_EQ(move(below, aside), Vector3::Zero()) << thin.Name;
      EXPECT_EQ(move(aside, below), Vector3::Zero()) << thin.Name;
      EXPECT_LT(move(below, {0.3, -0.4, -0.5})[2], -0.1) << thin.Name;
      EXPECT_EQ(move({0.3, -0.4, -0.5}, below), Vector3::Zero()) << thin.Name;
    }
  }
}

// The structure that holds the tool is not among those near the hand.
TEST(PressedThrough, HeldStructureIsFarFromTheHandAmongMany)
{
  Random random(9);
  const Thin plate = OfFacets("plate", Sheet([](const Vector3&) { return -Thickness; }), random);
  TouchScene scene = SceneOf(plate, 1.0);
  for (int n = 0; n < 40; ++n)
  {
    const Vector3 center =
        plate.Top + plate.Rotation * Vector3(3.0 * (n % 8) - 10.0, 6.0, -20.0 + 4.0 * (n / 8));
    scene.Structures.push_back({"sphere",
                                test::RadialContact({0, {0.5 * std::sqrt(4.0 * M_PI)}, center}),
                                {Stiffness, 0.0},
                                {}});
  }
  test::ServoRun run(scene);
  const auto place = [&](double z) -> Vector3
  { return plate.Top + plate.Rotation * Vector3(0.3, -0.4, z); };
  EXPECT_NEAR(run.MoveAndRest(place(4.0), place(-12.0)).norm(), Stiffness * 13.0, Rough);
  EXPECT_EQ(run.Loop.Latest().Structure, 0);
}

// Noise in the last digits of a mesh's coordinates, which single precision has, does not stop a
// tool.
TEST(PressedThrough, DeepToolFollowsTheHandAlongAFlatMesh)
{
  Random random(10);
  // Across the squares, and along their edges.
  for (const Vector3& start : {Vector3(-9.0, -6.0, 3.0), Vector3(-9.0, 0.0, 3.0)})
  {
    const Vector3 stride(0.02, start[1] < 0.0 ? 0.013 : 0.0, 0.0);
    for (const double toolRadius : {0.0, 1.0})
    {
      const Thin plate =
          OfFacets("plate", Sheet([](const Vector3&) { return -Thickness; }), random);
      const auto tracker = test::TrackerOf(*plate.Model, ToolShape::Sphere(toolRadius));
      const auto at = [&](const Vector3& place) -> const Contact&
      { return tracker->Follow(test::At(plate.Top + plate.Rotation * place)); };
      at(start);
      for (int tick = 0; tick <= 900; ++tick)
      {
        const Vector3 hand = start + tick * stride - Vector3(0.0, 0.0, 15.0);
        const Contact& contact = at(hand);
        const Vector3 proxy = plate.Rotation.transpose() * (contact.ProxyWorld - plate.Top);
        ASSERT_TRUE(contact.IsTouching);
        // Rounds end where one changes the pull by a thousandth, which nobody feels.
        ASSERT_LE((proxy - Vector3(hand[0], hand[1], toolRadius)).norm(), 2e-3 * contact.Depth)
            << tick;
      }
    }
  }
}
} // namespace
} // namespace palpate::pressed_through_test
