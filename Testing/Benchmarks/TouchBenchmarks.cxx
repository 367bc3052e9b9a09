#include "TouchBenchmarks.h"

#include "FacetContactModel.h"
#include "FieldBuilder.h"
#include "FieldContactModel.h"
#include "IcosahedronDirections.h"
#include "OrganContact.h"
#include "ProceduralFields.h"
#include "PublishedShell.h"
#include "RandomShapes.h"
#include "StructureStroke.h"
#include "SurfacePhantoms.h"

#include "vtkCellArray.h"
#include "vtkGenericCell.h"
#include "vtkImplicitPolyDataDistance.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

namespace palpate::bench
{
namespace
{
constexpr int TouchTicks = 4000;
constexpr double TouchStep = 0.05; // mm per tick: 50 mm/s at 1 kHz

// A unit vector that moves over the sphere, some `angle` (rad) per tick.
std::vector<Vector3> Wander(double angle)
{
  test::Random random(61);
  std::vector<Vector3> places;
  Vector3 place = Vector3::UnitX();
  Vector3 axis = test::RandomDirection(random);
  while (places.size() < TouchTicks)
  {
    axis = (axis + 0.02 * test::RandomDirection(random)).normalized();
    place = (Eigen::AngleAxisd(angle, axis) * place).normalized();
    places.push_back(place);
  }
  return places;
}

// Proxies of both sides of a pair.
struct Proxies
{
  std::vector<Vector3> Ours{TouchTicks};
  std::vector<Vector3> Theirs{TouchTicks};

  std::string Disagreement(double most) const
  {
    double worst = 0.0;
    for (std::size_t i = 0; i < TouchTicks; ++i)
    {
      const double difference = (this->Ours[i] - this->Theirs[i]).norm();
      worst = std::isnan(difference) ? INFINITY : std::max(worst, difference);
    }
    if (worst <= most)
    {
      return {};
    }
    std::ostringstream text;
    text << "proxies differ by " << worst << " mm";
    return text.str();
  }
};

void FollowAll(ContactTracker& tracker, const std::vector<Vector3>& path,
               std::vector<Vector3>& proxies)
{
  tracker.Release();
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    proxies[i] = tracker.Follow({path[i], Eigen::Quaterniond::Identity()}).ProxyWorld;
  }
}

// Contact points instead of proxies, so that tools of different radii can be compared.
void TouchAll(ContactTracker& tracker, double toolRadius, const std::vector<Vector3>& path,
              std::vector<Vector3>& places)
{
  tracker.Release();
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    const Contact& contact = tracker.Follow({path[i], Eigen::Quaterniond::Identity()});
    places[i] = contact.ProxyWorld - toolRadius * contact.NormalWorld;
  }
}

std::unique_ptr<ContactTracker> TrackerOf(const std::shared_ptr<const ContactModel>& model,
                                          const ToolShape& tool)
{
  std::unique_ptr<ContactTracker> tracker;
  return model != nullptr && model->MakeTracker(tool, {}, tracker).IsOk() ? std::move(tracker)
                                                                          : nullptr;
}

// An organ of degree 12 and its meshes of 8,000, 32,000 and 128,000 triangles, touched 1.5 mm deep.
class OrganCase
{
public:
  OrganCase()
  {
    test::Random random(12);
    const auto organ = std::make_shared<const RadialModel>(test::RandomOrgan(random, 12));
    for (const Vector3& u : Wander(TouchStep / 20.0))
    {
      this->PointPath.push_back(organ->PointWorld(u) - 1.5 * organ->Normal(u));
      this->SpherePath.push_back(organ->PointWorld(u) + (SphereRadius - 1.5) * organ->Normal(u));
    }
    std::shared_ptr<const ContactModel> model;
    if (MakeOrganContact(organ, RadialContactMode::Nearest, model).IsOk())
    {
      this->Harmonic = TrackerOf(model, ToolShape::Sphere(0.0));
      this->RadialSphere = TrackerOf(model, ToolShape::Sphere(SphereRadius));
    }
    this->MakeMesh(*organ);
    for (const int frequency : {20, 40, 80})
    {
      this->MakeFacets(*organ, frequency);
    }
  }

  void FollowRadial() { FollowAll(*this->Harmonic, this->PointPath, this->Pairs.Ours); }
  void FollowHarmonicAsTheirs() { FollowAll(*this->Harmonic, this->PointPath, this->Pairs.Theirs); }
  void TouchHarmonicPoint() { TouchAll(*this->Harmonic, 0.0, this->PointPath, this->Pairs.Theirs); }
  void TouchHarmonicSphere()
  {
    TouchAll(*this->RadialSphere, SphereRadius, this->SpherePath, this->Pairs.Ours);
  }
  void FollowHarmonicSphere()
  {
    FollowAll(*this->RadialSphere, this->SpherePath, this->Pairs.Ours);
  }
  void FollowFacets(std::size_t size)
  {
    FollowAll(*this->Facets[size], this->PointPath, this->Pairs.Ours);
  }
  void FollowFacetsSphere()
  {
    FollowAll(*this->FacetsSphere[0], this->SpherePath, this->Pairs.Theirs);
  }
  void Locate()
  {
    for (std::size_t i = 0; i < TouchTicks; ++i)
    {
      vtkIdType triangle = 0;
      int part = 0;
      double square = 0.0;
      this->Locator->FindClosestPoint(this->PointPath[i].data(), this->Pairs.Theirs[i].data(),
                                      this->Cell, triangle, part, square);
    }
  }
  void EvaluateDistance()
  {
    for (std::size_t i = 0; i < TouchTicks; ++i)
    {
      this->Distance->EvaluateFunctionAndGetClosestPoint(this->PointPath[i].data(),
                                                         this->Pairs.Theirs[i].data());
    }
  }
  // Facets lie up to some hundredths of a millimetre inside the surface, and the closest point of a
  // facet differs by its slope times the depth.
  std::string Disagreement() const { return this->Pairs.Disagreement(0.3); }
  // A god-object sometimes sticks at edges: up to 22 degrees off, of 1.5 mm.
  std::string FacetsDisagreement() const { return this->Pairs.Disagreement(0.6); }

private:
  static constexpr double SphereRadius = 2.0; // mm

  void MakeMesh(const RadialModel& organ)
  {
    const IcosahedronDirections sphere(20);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vector3& u : sphere.Directions())
    {
      points->InsertNextPoint(organ.PointWorld(u).data());
    }
    vtkNew<vtkCellArray> triangles;
    for (const auto& [a, b, c] : sphere.Triangles())
    {
      triangles->InsertNextCell({a, b, c});
    }
    this->Mesh->SetPoints(points);
    this->Mesh->SetPolys(triangles);
    this->Locator->SetDataSet(this->Mesh);
    this->Locator->BuildLocator();
    this->Distance->SetInput(this->Mesh);
  }

  void MakeFacets(const RadialModel& organ, int frequency)
  {
    const IcosahedronDirections sphere(frequency);
    std::vector<Vector3> corners;
    for (const Vector3& u : sphere.Directions())
    {
      corners.push_back(organ.PointWorld(u));
    }
    std::shared_ptr<const ContactModel> model;
    if (FacetContactModel::Make(corners, sphere.Triangles(), model).IsOk())
    {
      this->Facets.push_back(TrackerOf(model, ToolShape::Sphere(0.0)));
      this->FacetsSphere.push_back(TrackerOf(model, ToolShape::Sphere(SphereRadius)));
    }
  }

  std::vector<Vector3> PointPath;
  std::vector<Vector3> SpherePath;
  std::unique_ptr<ContactTracker> Harmonic;
  std::unique_ptr<ContactTracker> RadialSphere;
  std::vector<std::unique_ptr<ContactTracker>> Facets;
  std::vector<std::unique_ptr<ContactTracker>> FacetsSphere;
  Proxies Pairs;
  vtkNew<vtkPolyData> Mesh;
  vtkNew<vtkStaticCellLocator> Locator;
  vtkNew<vtkGenericCell> Cell;
  vtkNew<vtkImplicitPolyDataDistance> Distance;
};

// A surface model and its mesh of 8,000 triangles, touched 1.5 mm deep by a point.
class SurfaceTouchCase
{
public:
  explicit SurfaceTouchCase(const SurfaceModel& surface)
  {
    this->MakePath(surface);
    std::shared_ptr<const ContactModel> model;
    if (MakeOrganContact(surface, model).IsOk())
    {
      this->Mapped = TrackerOf(model, ToolShape::Sphere(0.0));
    }
    const IcosahedronDirections sphere(20);
    std::vector<Vector3> corners;
    for (const Vector3& parameter : sphere.Directions())
    {
      corners.push_back(surface.Point(parameter));
    }
    if (FacetContactModel::Make(corners, sphere.Triangles(), model).IsOk())
    {
      this->Facets = TrackerOf(model, ToolShape::Sphere(0.0));
    }
  }
  void AddStar(const std::shared_ptr<const RadialModel>& organ)
  {
    std::shared_ptr<const ContactModel> model;
    if (MakeOrganContact(organ, RadialContactMode::Nearest, model).IsOk())
    {
      this->Star = TrackerOf(model, ToolShape::Sphere(0.0));
    }
  }

  void FollowSurface() { FollowAll(*this->Mapped, this->Path, this->Pairs.Ours); }
  void FollowFacets() { FollowAll(*this->Facets, this->Path, this->Pairs.Theirs); }
  void FollowStar() { FollowAll(*this->Star, this->Path, this->Pairs.Theirs); }
  // As for FacetsDisagreement; a radial model has the same surface, tracked to 1e-5 mm.
  std::string Disagreement() const { return this->Pairs.Disagreement(0.6); }
  std::string StarDisagreement() const { return this->Pairs.Disagreement(2e-5); }

private:
  void MakePath(const SurfaceModel& surface)
  {
    // Parameters are stretched differently everywhere: turns of any angle that moves by a step.
    test::Random random(61);
    Vector3 u = Vector3::UnitX();
    Vector3 axis = test::RandomDirection(random);
    while (this->Path.size() < TouchTicks)
    {
      axis = (axis + 0.02 * test::RandomDirection(random)).normalized();
      const auto turned = [&](double angle)
      { return Vector3((Eigen::AngleAxisd(angle, axis) * u).normalized()); };
      constexpr double Small = 1e-4; // rad
      const double speed = (surface.Point(turned(Small)) - surface.Point(u)).norm() / Small;
      u = turned(std::min(0.01, TouchStep / speed));
      this->Path.push_back(surface.Point(u) - 1.5 * surface.Normal(u));
    }
  }

  std::vector<Vector3> Path;
  std::unique_ptr<ContactTracker> Mapped;
  std::unique_ptr<ContactTracker> Facets;
  std::unique_ptr<ContactTracker> Star;
  Proxies Pairs;
};

std::vector<PairedBenchmark> SurfaceTouchBenchmarks()
{
  test::Random random(12);
  // As a surface model the degree is one higher.
  const auto organ = std::make_shared<const RadialModel>(test::RandomOrgan(random, 15));
  const auto body = std::make_shared<SurfaceTouchCase>(SurfaceModel::FromModel(*organ));
  body->AddStar(organ);
  const auto ring = std::make_shared<SurfaceTouchCase>(test::OpenRing());
  return {{"touch/surface/degree16", "god-object on 8,000 triangles (ours)",
           [body] { body->FollowSurface(); }, [body] { body->FollowFacets(); },
           [body] { return body->Disagreement(); }, TouchTicks},
          {"touch/surface/degree16/star", "the same as a radial model (ours)",
           [body] { body->FollowSurface(); }, [body] { body->FollowStar(); },
           [body] { return body->StarDisagreement(); }, TouchTicks},
          {"touch/surface/degree16/ring", "god-object on 8,000 triangles (ours)",
           [ring] { ring->FollowSurface(); }, [ring] { ring->FollowFacets(); },
           [ring] { return ring->Disagreement(); }, TouchTicks}};
}

// A sphere of 30 mm in voxels of 0.5 mm, touched by one of 2 mm with 26 points, half a voxel deep.
class FieldTouchCase
{
public:
  FieldTouchCase()
  {
    constexpr int Nodes = 140;
    const FieldGrid grid({Nodes, Nodes, Nodes}, Vector3::Zero(), Vector3::Constant(0.5),
                         Matrix3::Identity());
    const test::SphereField sphere{Vector3(69.3, 70.1, 68.7), 60.0};
    const auto samples = test::SampleAtIndices<float>(grid.Size(), sphere);
    FieldBuilder builder(grid);
    builder.AddMaterial({builder.AddChannel(SamplesOfGrid(samples.data(), grid)), 0.0});
    std::shared_ptr<const ScalarField> field;
    if (!builder.Build(field).IsOk())
    {
      return;
    }
    const ToolShape tool = ToolShape::SpherePoints(2.0, ToolShape::NeighbourCount);
    std::shared_ptr<const ContactModel> model;
    if (FieldContactModel::Make(field, 0, model).IsOk())
    {
      this->Solved = TrackerOf(model, tool);
      this->Small = TrackerOf(model, ToolShape::SpherePoints(SmallRadius, tool.NeighbourCount));
      this->Large = TrackerOf(model, ToolShape::SpherePoints(LargeRadius, tool.NeighbourCount));
    }
    if (test::MakePublishedShell(field, 0, model).IsOk())
    {
      this->Published = TrackerOf(model, tool);
    }
    for (const Vector3& u : Wander(TouchStep / 30.0))
    {
      const Vector3 place = grid.PointWorld(sphere.Center) + (30.0 - 0.5) * u;
      this->Path.push_back(place + 2.0 * u);
      this->SmallPath.push_back(place + SmallRadius * u);
      this->LargePath.push_back(place + LargeRadius * u);
    }
  }

  void FollowSolved() { FollowAll(*this->Solved, this->Path, this->Pairs.Ours); }
  void FollowPublished() { FollowAll(*this->Published, this->Path, this->Pairs.Theirs); }
  void TouchSmall() { TouchAll(*this->Small, SmallRadius, this->SmallPath, this->Pairs.Theirs); }
  void TouchLarge() { TouchAll(*this->Large, LargeRadius, this->LargePath, this->Pairs.Ours); }
  // The published law pushes out by the mean, which is less by up to the depth.
  std::string LawsDisagreement() const { return this->Pairs.Disagreement(0.6); }
  // Tools touch at the same place, except for solving, and for normals that lag by a tick: 4 mm
  // times some hundredths.
  std::string RadiiDisagreement() const { return this->Pairs.Disagreement(0.06); }

private:
  static constexpr double SmallRadius = 0.5; // mm
  static constexpr double LargeRadius = 4.0;

  std::vector<Vector3> Path;
  std::vector<Vector3> SmallPath;
  std::vector<Vector3> LargePath;
  std::unique_ptr<ContactTracker> Small;
  std::unique_ptr<ContactTracker> Large;
  std::unique_ptr<ContactTracker> Solved;
  std::unique_ptr<ContactTracker> Published;
  Proxies Pairs;
};

// TouchTicks of a whole servo, with many structures and with one.
PairedBenchmark StructureBenchmark(int count)
{
  const std::shared_ptr<ServoStroke> many = StructureStroke(count);
  const std::shared_ptr<ServoStroke> one = StructureStroke(1);
  const auto disagreement = [many, one]
  { return many->Forces() == one->Forces() ? "" : "forces differ between the scenes"; };
  return {"touch/structures/" + std::to_string(count),
          "one structure (ours)",
          [many] { many->Stroke(); },
          [one] { one->Stroke(); },
          disagreement,
          StructureTicks};
}
} // namespace

std::vector<PairedBenchmark> TouchBenchmarks()
{
  const auto organ = std::make_shared<OrganCase>();
  const auto field = std::make_shared<FieldTouchCase>();
  const auto agree = [organ] { return organ->Disagreement(); };
  const auto facets = [&](std::size_t size, const char* count)
  {
    return PairedBenchmark{std::string("touch/facets/") + count,
                           "spherical harmonics of degree 12 (ours)",
                           [organ, size] { organ->FollowFacets(size); },
                           [organ] { organ->FollowHarmonicAsTheirs(); },
                           [organ] { return organ->FacetsDisagreement(); },
                           TouchTicks};
  };
  std::vector<PairedBenchmark> all{
      {"touch/sh/degree12", "vtkStaticCellLocator, 8,000 triangles",
       [organ] { organ->FollowRadial(); }, [organ] { organ->Locate(); }, agree, TouchTicks},
      {"touch/sh/degree12/signed", "vtkImplicitPolyDataDistance, 8,000 triangles",
       [organ] { organ->FollowRadial(); }, [organ] { organ->EvaluateDistance(); }, agree,
       TouchTicks},
      {"touch/sh/degree12/sphere", "god-object on 8,000 triangles (ours), sphere of 2 mm",
       [organ] { organ->FollowHarmonicSphere(); }, [organ] { organ->FollowFacetsSphere(); }, agree,
       TouchTicks},
      {"touch/sh/degree12/radius", "a point instead of a sphere of 2 mm (ours)",
       [organ] { organ->TouchHarmonicSphere(); }, [organ] { organ->TouchHarmonicPoint(); }, agree,
       TouchTicks},
      facets(0, "8000"),
      facets(1, "32000"),
      facets(2, "128000"),
      {"touch/subvoxel/26/radius", "a sphere of 0.5 mm instead of one of 4 mm (ours)",
       [field] { field->TouchLarge(); }, [field] { field->TouchSmall(); },
       [field] { return field->RadiiDisagreement(); }, TouchTicks},
      StructureBenchmark(10),
      StructureBenchmark(116),
      StructureBenchmark(10000),
      {"touch/subvoxel/26", "the published law (ours)", [field] { field->FollowSolved(); },
       [field] { field->FollowPublished(); }, [field] { return field->LawsDisagreement(); },
       TouchTicks}};
  const std::vector<PairedBenchmark> surfaces = SurfaceTouchBenchmarks();
  all.insert(all.end(), surfaces.begin(), surfaces.end());
  return all;
}
} // namespace palpate::bench
