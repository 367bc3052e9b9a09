#include "NrrdSpace.h"

#include "DecimalText.h"
#include "LengthUnit.h"
#include "Refusal.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <sstream>
#include <string_view>

namespace palpate
{
namespace
{
constexpr const char* Remedy = "write it again with space left-posterior-superior";

// Names are compared without case, spaces and hyphens.
std::string Normalised(const std::string& name)
{
  std::string normalised;
  for (const char letter : name)
  {
    if (letter != ' ' && letter != '-')
    {
      normalised += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
  }
  return normalised;
}

bool IsOneOf(const std::string& name, std::initializer_list<const char*> names)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

// "(1,0,0)", with or without spaces between its numbers.
std::optional<Vector3> ParseVector(std::string_view text)
{
  if (text.size() < 2 || text.front() != '(' || text.back() != ')')
  {
    return std::nullopt;
  }
  text = text.substr(1, text.size() - 2);
  Vector3 vector;
  for (int i = 0; i < 3; ++i)
  {
    const std::size_t comma = text.find(',');
    const std::optional<double> number = ParseNumber(text.substr(0, comma));
    if (!number || (comma == std::string_view::npos) != (i == 2))
    {
      return std::nullopt;
    }
    vector[i] = *number;
    text.remove_prefix(i == 2 ? text.size() : comma + 1);
  }
  return vector;
}

// One entry for each axis, empty for "none"; an empty list if one is damaged.
using AxisDirections = std::vector<std::optional<Vector3>>;
std::optional<AxisDirections> ParseDirections(std::string_view text)
{
  AxisDirections directions;
  while (true)
  {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    if (text.empty())
    {
      return directions;
    }
    const std::size_t length =
        text.front() == '(' ? text.find(')') + 1 : text.find_first_of(" \t(");
    const std::string_view word = text.substr(0, length);
    const std::optional<Vector3> direction = ParseVector(word);
    if (!direction && word != "none")
    {
      return std::nullopt;
    }
    directions.push_back(direction);
    text.remove_prefix(word.size());
  }
}

// Whether all axes with a direction are of a spatial kind: the library takes vectors, colours and
// the like for components of a voxel.
bool AreDomains(const AxisDirections& directions, const std::string& kinds)
{
  std::istringstream words(kinds);
  std::string kind;
  return std::all_of(directions.begin(), directions.end(),
                     [&](const std::optional<Vector3>& direction)
                     {
                       return !(words >> kind) || !direction ||
                              IsOneOf(Normalised(kind), {"domain", "space", "time", "none", "???"});
                     });
}

std::string FieldOf(const std::map<std::string, std::string>& fields, const std::string& key)
{
  const auto found = fields.find(key);
  return found == fields.end() ? std::string() : found->second;
}
} // namespace

NrrdSpace::NrrdSpace(const std::filesystem::path& file,
                     const std::map<std::string, std::string>& fields)
    : Name(FieldOf(fields, "space"))
{
  const std::string dimension = FieldOf(fields, "spacedimension");
  if (!dimension.empty() && ParseInteger(dimension) != 3)
  {
    Refuse(file, "has a space of dimension " + dimension, "extract one three-dimensional volume");
  }
  if (!this->Name.empty())
  {
    this->TakeName(file);
  }
  const auto directions = ParseDirections(FieldOf(fields, "spacedirections"));
  for (const std::optional<Vector3>& direction : directions.value_or(AxisDirections()))
  {
    if (direction)
    {
      this->Steps.push_back(*direction);
    }
  }
  if (!directions || (!this->Steps.empty() && this->Steps.size() != 3))
  {
    Refuse(file, "has space directions that are not three vectors of three finite numbers",
           "correct its header or export it again");
  }
  if (!AreDomains(*directions, FieldOf(fields, "kinds")))
  {
    Refuse(file, "has a space direction for an axis whose kind is not spatial",
           "correct its header or export it again");
  }
  const std::string origin = FieldOf(fields, "spaceorigin");
  const std::optional<Vector3> first = origin.empty() ? Vector3::Zero() : ParseVector(origin);
  if (!first)
  {
    Refuse(file, "has a space origin that is not three finite numbers",
           "correct its header or export it again");
  }
  this->First = *first;
  this->TakeUnits(fields);
}

void NrrdSpace::TakeUnits(const std::map<std::string, std::string>& fields)
{
  const std::vector<std::string> units =
      ListedUnits(FieldOf(fields, this->Steps.empty() ? "units" : "spaceunits"));
  for (std::size_t axis = 0; axis < units.size() && units.size() == 3; ++axis)
  {
    if (units[axis].empty())
    {
      continue;
    }
    const std::optional<double> millimeters = MillimetersPer(units[axis]);
    this->Scale[static_cast<Eigen::Index>(axis)] = millimeters.value_or(1.0);
    if (!millimeters)
    {
      this->UnitNote = "The file's unit, " + units[axis] + ", is not known; mm were assumed.";
    }
    else if (*millimeters != 1.0 && this->UnitNote.empty())
    {
      this->UnitNote = "The file's unit, " + units[axis] + ", was converted to mm.";
    }
  }
  this->First = this->First.cwiseProduct(this->Scale);
  for (Vector3& step : this->Steps)
  {
    step = step.cwiseProduct(this->Scale);
  }
}

void NrrdSpace::TakeName(const std::filesystem::path& file)
{
  const std::string space = Normalised(this->Name);
  if (IsOneOf(space, {"leftposteriorsuperior", "lps"}))
  {
    this->IsAnatomical = true;
  }
  else if (IsOneOf(space, {"rightanteriorsuperior", "ras"}))
  {
    this->IsAnatomical = true;
    this->Signs = {-1.0, -1.0, 1.0};
  }
  else if (IsOneOf(space, {"leftanteriorsuperior", "las"}))
  {
    this->IsAnatomical = true;
    this->Signs = {1.0, -1.0, 1.0};
  }
  else if (space == "3dlefthanded")
  {
    Refuse(file, "has the left-handed space " + this->Name + ", which is not a patient frame",
           Remedy);
  }
  else if (!IsOneOf(space, {"scannerxyz", "3drighthanded"}))
  {
    Refuse(file, "has the space " + this->Name + ", which is not three-dimensional or not known",
           Remedy);
  }
}

Vector3 NrrdSpace::ToLps(const Vector3& vector) const
{
  // A sum with 0 makes +0 of -0.
  return (this->Signs.cwiseProduct(vector).array() + 0.0).matrix();
}

void NrrdSpace::PlaceGrid(ImageGrid& grid) const
{
  grid.IsOriented = this->IsAnatomical && !this->Steps.empty();
  if (this->Steps.empty())
  {
    grid.Spacing = grid.Spacing.cwiseProduct(this->Scale);
    grid.OriginWorld = grid.OriginWorld.cwiseProduct(this->Scale);
  }
  for (int axis = 0; axis < static_cast<int>(this->Steps.size()); ++axis)
  {
    const Vector3 step = this->ToLps(this->Steps[static_cast<std::size_t>(axis)]);
    grid.Spacing[axis] = step.norm();
    grid.Direction.col(axis) = step.norm() > 0.0 ? Vector3(step / step.norm()) : step;
    grid.OriginWorld = this->ToLps(this->First);
  }
}

std::vector<std::string> NrrdSpace::Notes() const
{
  std::vector<std::string> notes;
  if (this->Steps.empty())
  {
    notes.emplace_back("The file gives no space directions; its index axes were taken as L, P, S.");
  }
  else if (!this->IsAnatomical)
  {
    notes.push_back(this->Name.empty()
                        ? "The file names no space; its space directions were taken as L, P, S."
                        : "The file's space, " + this->Name +
                              ", does not state its orientation in the patient; it was taken as L, "
                              "P, S.");
  }
  if (!this->UnitNote.empty())
  {
    notes.push_back(this->UnitNote);
  }
  return notes;
}
} // namespace palpate
