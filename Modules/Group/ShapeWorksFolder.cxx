#include "ShapeWorksFolder.h"

#include "DecimalText.h"
#include "IcosahedronDirections.h"
#include "InputError.h"
#include "ModelSurface.h"
#include "SurfaceFile.h"
#include "WholeFile.h"

#include <system_error>
#include <utility>

namespace palpate
{
namespace
{
constexpr int ParticleFrequency = 10; // 1,002 points

Vector3 PointOn(const RadialModel& model, const Vector3& direction)
{
  return model.CenterWorld() + model.Radius(direction) * direction;
}

Vector3 PointOn(const SurfaceModel& surface, const Vector3& parameter)
{
  return surface.Point(parameter);
}

std::string ParticleText(const OrganModel& model)
{
  std::string text;
  const IcosahedronDirections sphere(ParticleFrequency);
  for (const Vector3& u : sphere.Directions())
  {
    const Vector3 point = std::visit([&](const auto& one) { return PointOn(one, u); }, model);
    text += ExactText(point.x()) + " " + ExactText(point.y()) + " " + ExactText(point.z()) + "\n";
  }
  return text;
}
} // namespace

ShapeWorksFolder::ShapeWorksFolder(std::filesystem::path folder) : Folder(std::move(folder))
{
  std::error_code problem;
  std::filesystem::create_directories(this->Folder, problem);
  if (problem)
  {
    throw InputError(this->Folder.string() + " cannot be made: " + problem.message());
  }
}

void ShapeWorksFolder::Add(const std::string& name, const OrganModel& patient,
                           const OrganModel& aligned)
{
  WriteWholeFile(this->Folder / (name + "_local.particles"), ParticleText(patient));
  WriteWholeFile(this->Folder / (name + "_world.particles"), ParticleText(aligned));
  WriteSurface(this->Folder / (name + ".ply"), DrawModel(patient, 2 * ParticleFrequency));
  this->Names.push_back(name);
}

void ShapeWorksFolder::Finish() const
{
  std::string rows;
  for (const std::string& name : this->Names)
  {
    const auto field = [](const std::string& key, const std::string& value)
    { return "\"" + key + "\": \"" + value + "\""; };
    rows += std::string(rows.empty() ? "" : ",") + "\n    {" + field("name", name) + ", " +
            field("shape_1", name + ".ply") + ", " + field("groomed_1", name + ".ply") + ", " +
            field("local_particles_1", name + "_local.particles") + ", " +
            field("world_particles_1", name + "_world.particles") + "}";
  }
  WriteWholeFile(this->Folder / "cohort.swproj", "{\n  \"data\": [" + rows + "\n  ]\n}\n");
}
} // namespace palpate
