#include "SpharmPdmFolder.h"

#include "DecimalText.h"
#include "IcosahedronDirections.h"
#include "LatitudeAxis.h"
#include "SpharmPdmCoefficients.h"
#include "WholeFile.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr int PdmFrequency = 20; // what ParaToSPHARMMesh takes unless told otherwise
constexpr int AxisLatitudes = 100;
constexpr int AxisLongitudes = 100;

/// A named number at each point.
using PointNumbers = std::pair<std::string, std::vector<double>>;

SurfaceModel SurfaceModelOf(const OrganModel& model)
{
  const auto* radial = std::get_if<RadialModel>(&model);
  return radial != nullptr ? SurfaceModel::FromModel(*radial) : std::get<SurfaceModel>(model);
}

// LPS to RAS and back: a half turn, which leaves triangles outward.
Vector3 HalfTurned(const Vector3& point)
{
  return {-point.x(), -point.y(), point.z()};
}

std::string SingleText(double value)
{
  return ExactText(static_cast<float>(value));
}

std::string PolyDataHead(const std::vector<Vector3>& points)
{
  std::string text =
      "# vtk DataFile Version 3.0\nPalpate, SPACE=RAS, unit mm\nASCII\nDATASET POLYDATA\nPOINTS " +
      std::to_string(points.size()) + " float\n";
  for (const Vector3& point : points)
  {
    text +=
        SingleText(point.x()) + " " + SingleText(point.y()) + " " + SingleText(point.z()) + "\n";
  }
  return text;
}

std::string ArraysText(std::size_t count, const std::vector<PointNumbers>& arrays)
{
  if (arrays.empty())
  {
    return {};
  }
  std::string text = "POINT_DATA " + std::to_string(count) + "\nFIELD FieldData " +
                     std::to_string(arrays.size()) + "\n";
  for (const auto& [name, values] : arrays)
  {
    text += name + " 1 " + std::to_string(count) + " double\n";
    for (const double value : values)
    {
      text += ExactText(value) + "\n";
    }
  }
  return text;
}

std::string MeshText(const std::vector<Vector3>& points, const IcosahedronDirections& sphere,
                     const std::vector<PointNumbers>& arrays)
{
  std::string text = PolyDataHead(points) + "POLYGONS " +
                     std::to_string(sphere.Triangles().size()) + " " +
                     std::to_string(4 * sphere.Triangles().size()) + "\n";
  for (const std::array<int, 3>& corners : sphere.Triangles())
  {
    text += "3 " + std::to_string(corners[0]) + " " + std::to_string(corners[1]) + " " +
            std::to_string(corners[2]) + "\n";
  }
  return text + ArraysText(points.size(), arrays);
}

std::vector<Vector3> PointsOf(const SurfaceModel& surface, const IcosahedronDirections& sphere)
{
  std::vector<Vector3> points;
  for (const Vector3& parameter : sphere.Directions())
  {
    points.push_back(HalfTurned(surface.Point(parameter)));
  }
  return points;
}

// SPHARM-PDM's coordinates of the parameter sphere: phi from 0 to 2 pi, from -x; half of it and
// back; theta from -z; and a mixture by which two corresponding points can be told from all others.
std::vector<PointNumbers> ParameterNumbers(const IcosahedronDirections& sphere)
{
  std::vector<PointNumbers> numbers{
      {"_paraPhi", {}}, {"_paraPhiHalf", {}}, {"_paraTheta", {}}, {"_paraMix", {}}};
  for (const Vector3& u : sphere.Directions())
  {
    const double phi = std::atan2(u.y(), u.x()) + M_PI;
    const double half = phi > M_PI ? 2.0 * M_PI - phi : phi;
    const double theta = std::atan2(u.z(), std::hypot(u.x(), u.y())) + 0.5 * M_PI;
    numbers[0].second.push_back(phi);
    numbers[1].second.push_back(half);
    numbers[2].second.push_back(theta);
    numbers[3].second.push_back(theta / M_PI * (half / M_PI + 1.0));
  }
  return numbers;
}

// SPHARM-PDM writes the head of the parameters with blanks around each sign, that of the medial
// mesh without.
std::string ScalarText(const std::vector<double>& values, const std::string& sign = " = ")
{
  std::string text = "NUMBER_OF_POINTS" + sign + std::to_string(values.size()) + "\nDIMENSION" +
                     sign + "1\nTYPE" + sign + "Scalar\n";
  for (const double value : values)
  {
    text += SignificantText(value, 10) + "\n";
  }
  return text;
}

std::vector<Vector3> HalfTurnedAll(std::vector<Vector3> points)
{
  for (Vector3& point : points)
  {
    point = HalfTurned(point);
  }
  return points;
}

void WriteAxis(const LatitudeAxis& axis, const std::string& base)
{
  std::string table = "Theta,Radius,Area\n";
  std::string line = std::to_string(axis.Theta.size());
  for (std::size_t i = 0; i < axis.Theta.size(); ++i)
  {
    table += ExactText(axis.Theta[i]) + "," + ExactText(axis.Radii[i]) + "," +
             ExactText(axis.Areas[i]) + "\n";
    line += " " + std::to_string(i);
  }
  WriteWholeFile(base + "_MedialAxisScalars.csv", table);
  WriteWholeFile(
      base + "_SPHARMMedialAxis.vtk",
      PolyDataHead(HalfTurnedAll(axis.Middles)) + "LINES 1 " +
          std::to_string(axis.Theta.size() + 1) + "\n" + line + "\n" +
          ArraysText(axis.Theta.size(),
                     {{"_theta", axis.Theta}, {"_radius", axis.Radii}, {"_area", axis.Areas}}));
}

// The value of its circle at each point.
std::vector<double> Repeated(const std::vector<double>& values, int times)
{
  std::vector<double> all;
  for (const double value : values)
  {
    all.insert(all.end(), static_cast<std::size_t>(times), value);
  }
  return all;
}

// Two triangles between neighbouring circles and meridians, outward.
std::string MedialTriangles(int circles, int longitudes)
{
  const int count = 2 * (circles - 1) * (longitudes - 1);
  std::string text = "POLYGONS " + std::to_string(count) + " " + std::to_string(4 * count) + "\n";
  for (int i = 0; i + 1 < circles; ++i)
  {
    for (int j = 0; j + 1 < longitudes; ++j)
    {
      const std::string here = std::to_string(i * longitudes + j);
      const std::string next = std::to_string(i * longitudes + j + 1);
      const std::string below = std::to_string((i + 1) * longitudes + j);
      const std::string across = std::to_string((i + 1) * longitudes + j + 1);
      text += "3 " + here + " " + below + " " + across + "\n3 " + here + " " + across + " " + next +
              "\n";
    }
  }
  return text;
}

void WriteMedialMesh(const LatitudeAxis& axis, const std::string& base)
{
  const std::vector<PointNumbers> numbers{{"radius", Repeated(axis.Radii, axis.Longitudes)},
                                          {"area", Repeated(axis.Areas, axis.Longitudes)},
                                          {"partial_area", axis.PartialAreas},
                                          {"partial_radius", axis.PartialRadii}};
  const std::array<const char*, 4> names{{"Radius", "Area", "PartialArea", "PartialRadius"}};
  for (std::size_t k = 0; k < names.size(); ++k)
  {
    WriteWholeFile(base + "_medialMesh" + names[k] + ".txt", ScalarText(numbers[k].second, "="));
  }
  WriteWholeFile(base + "_SPHARMMedialMesh.vtk",
                 PolyDataHead(HalfTurnedAll(axis.Points)) +
                     MedialTriangles(static_cast<int>(axis.Theta.size()), axis.Longitudes) +
                     ArraysText(axis.Points.size(), numbers));
}

void WritePose(const OrganModel& model, const IcosahedronDirections& sphere,
               const std::string& base, const std::vector<PointNumbers>& arrays)
{
  WriteWholeFile(base + ".vtk", MeshText(PointsOf(SurfaceModelOf(model), sphere), sphere, arrays));
  WriteWholeFile(base + ".coef", SurfaceToSpharmPdm(model, base));
}
} // namespace

void WriteSpharmPdmCase(const SpharmPdmCase& one, const std::filesystem::path& folder)
{
  const IcosahedronDirections sphere(PdmFrequency);
  const SurfaceModel patient = SurfaceModelOf(one.Patient);
  const std::filesystem::path second = folder / "Step2_GenParaMesh";
  const std::filesystem::path third = folder / "Step3_ParaToSPHARMMesh";
  std::filesystem::create_directories(second);
  std::filesystem::create_directories(third);
  const std::string parameters = MeshText(sphere.Directions(), sphere, {});
  WriteWholeFile(second / (one.Name + "_pp_para.vtk"), parameters);
  WriteWholeFile(second / (one.Name + "_pp_surf.vtk"),
                 MeshText(PointsOf(patient, sphere), sphere, {}));
  const std::string base = (third / (one.Name + "_pp_surf")).string();
  const std::vector<PointNumbers> numbers = ParameterNumbers(sphere);
  WritePose(one.Patient, sphere, base + "_SPHARM", numbers);
  WritePose(one.Ellipsoid, sphere, base + "_SPHARM_ellalign", numbers);
  WriteWholeFile(base + "_SPHARM_procalign.vtk",
                 MeshText(PointsOf(SurfaceModelOf(one.Group), sphere), sphere, numbers));
  WriteWholeFile(base + "_para.vtk", parameters);
  for (const auto& [name, values] : numbers)
  {
    WriteWholeFile(base + name + ".txt", ScalarText(values));
  }
  const LatitudeAxis axis =
      FindLatitudeAxis(WithLongAxisFirst(patient), AxisLatitudes, AxisLongitudes);
  WriteAxis(axis, base);
  WriteMedialMesh(axis, base);
}
} // namespace palpate
