#include "ElasticBuilds.h"

#include "BallContact.h"
#include "BallFraction.h"
#include "ComplianceSampler.h"
#include "LayeredSphere.h"
#include "RandomShapes.h"
#include "ResidentMemory.h"
#include "UnilateralSphere.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <malloc.h>
#include <sstream>
#include <stdexcept>

namespace palpate::bench
{
namespace
{
constexpr double BodyRadius = 25.0; // mm
constexpr double CoreDepth = 5.0;   // mm
constexpr double Tissue = 0.02;     // N/mm^2
constexpr double Core = 0.08;       // N/mm^2
constexpr double Bed = 1e-3;        // N/mm^3
constexpr double Poisson = 0.49;

void RequireBuild(const Status& status)
{
  if (!status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
}

LayeredSphere LayeredTruth(bool hasCore)
{
  return hasCore
             ? LayeredSphere({{BodyRadius - CoreDepth, Core}, {BodyRadius, Tissue}}, Poisson, Bed)
             : LayeredSphere({{BodyRadius, Tissue}}, Poisson, Bed);
}

// Of this process since ForgetPeak, MiB; the peak of its life where the kernel does not forget.
double PeakMebibytes()
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.rfind("VmHWM:", 0) == 0)
    {
      return std::strtod(line.c_str() + 6, nullptr) / 1024.0;
    }
  }
  return 0.0;
}

void ForgetPeak()
{
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
}

// The exact forces are the same for all rows of a body.
struct Body
{
  explicit Body(bool hasCore)
      : HasCore(hasCore), Model(0, {BodyRadius * std::sqrt(4.0 * M_PI)}, Vector3::Zero()),
        Sphere(LayeredTruth(hasCore)), Contact(Sphere, 7.0, 80)
  {
    if (hasCore)
    {
      this->Solid.Tissue.AddInclusion(test::BallFraction(Vector3::Zero(), BodyRadius - CoreDepth),
                                      Core);
    }
  }

  bool HasCore;
  RadialModel Model;
  ElasticSolid Solid{TissueMap(Tissue), Poisson, ElasticBed(Bed)};
  LayeredSphere Sphere;
  test::UnilateralSphere Contact;
};

void MeasureBuild(const Body& body, const ReducedCompliance& reduced, ElasticBuildRow& row)
{
  constexpr double TipRadius = 8.0;    // mm
  constexpr double LargestPatch = 9.0; // mm
  const auto worse = [](double worst, double found, double exact)
  { return std::fmax(worst, std::abs(found / exact - 1.0)); };
  const ComplianceSampler sampler(body.Model, body.Solid, reduced);
  test::Random random(71);
  for (const Vector3& direction : test::RandomDirections(random, 5))
  {
    for (const double patch : {0.5, 1.0, 2.0, 4.0, 6.0, 8.0})
    {
      row.ComplianceError =
          worse(row.ComplianceError, sampler.Compliance(sampler.PatchAt(direction, patch)),
                body.Sphere.Compliance(patch));
    }
    const PatchCompliance place = sampler.At(direction, LargestPatch);
    for (const double depth : {0.5, 1.0, 2.0, 3.0, 4.0})
    {
      row.ForceError =
          worse(row.ForceError, BallContact::Of(depth, TipRadius, 1.0 / BodyRadius, place).Force,
                body.Contact.Force(TipRadius, depth));
    }
  }
}

ElasticBuildRow MakeBuildRow(const Body& body, int elementsAcross, int degree)
{
  ElasticBuildRow row{elementsAcross, degree, body.HasCore, 0.0, 0.0, 0.0, 0.0};
  ForgetPeak();
  const double before = test::ResidentMebibytes();
  const auto start = std::chrono::steady_clock::now();
  StarMesh mesh;
  StiffnessMatrix stiffness;
  ReducedCompliance reduced;
  RequireBuild(StarMesh::Make(body.Model, elementsAcross, mesh));
  RequireBuild(AssembleStiffness(mesh, body.Model.CenterWorld(), body.Solid, stiffness));
  RequireBuild(ReducedCompliance::Make(mesh, stiffness, degree, {}, reduced));
  row.Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  row.Mebibytes = PeakMebibytes() - before;
  MeasureBuild(body, reduced, row);
  return row;
}
} // namespace

std::vector<ElasticBuildRow> ElasticBuilds()
{
  std::vector<ElasticBuildRow> rows;
  for (const bool hasCore : {false, true})
  {
    const Body body(hasCore);
    for (const int elementsAcross : {8, 12, 16})
    {
      for (const int degree : {8, 12, 16})
      {
        rows.push_back(MakeBuildRow(body, elementsAcross, degree));
      }
    }
  }
  return rows;
}

std::string ToMarkdown(const std::vector<ElasticBuildRow>& rows)
{
  std::ostringstream text;
  text << "| sphere | elements across | degree | built in, s | memory, MiB | compliance off by at "
          "most | force off by at most |\n|---|---|---|---|---|---|---|\n"
       << std::fixed;
  for (const ElasticBuildRow& row : rows)
  {
    text << "| " << (row.HasCore ? "core of 4 x, 5 mm down" : "homogeneous") << " | "
         << row.ElementsAcross << " | " << row.Degree << std::setprecision(2) << " | "
         << row.Seconds << std::setprecision(0) << " | " << row.Mebibytes << std::setprecision(2)
         << " | " << 100.0 * row.ComplianceError << " % | " << 100.0 * row.ForceError << " % |\n";
  }
  return text.str();
}
} // namespace palpate::bench
