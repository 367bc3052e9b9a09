#pragma once

#include "ImageGrid.h"
#include "PalpateIOModule.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace palpate
{
/// The world frame that an NRRD header names by its field "space".
class PALPATEIO_EXPORT NrrdSpace
{
public:
  /// From the fields of a header (ReadNrrdFields). Construct it before the library reads the
  /// header: ITK 5.2 writes beyond its arrays if a space has more dimensions than the image has
  /// axes. Throws InputError, naming `file`, for a space that cannot be converted to patient LPS
  /// (left-handed, with a time axis, not three-dimensional, unknown), and for directions and an
  /// origin that do not place three axes.
  NrrdSpace(const std::filesystem::path& file, const std::map<std::string, std::string>& fields);

  /// Sets origin, spacing (mm) and direction of a grid, which the library has read, from "space
  /// directions" and "space origin". The library's own conversion to LPS is unreliable: ITK 5.2
  /// mirrors left-anterior-superior. Without directions in the header, the grid is unchanged.
  void PlaceGrid(ImageGrid& grid) const;

  /// Assumptions, as sentences, if the header does not state the orientation of the axes in the
  /// patient, and what was done with its unit ("space units", or "units" without directions), which
  /// ITK ignores: known ones become mm, unknown ones are taken as mm.
  std::vector<std::string> Notes() const;

private:
  void TakeName(const std::filesystem::path& file);
  void TakeUnits(const std::map<std::string, std::string>& fields);
  Vector3 ToLps(const Vector3& vector) const;

  std::string Name;                ///< empty if the header names none
  std::vector<Vector3> Steps;      ///< of the index axes, mm, in the space: three or none
  Vector3 First = Vector3::Zero(); ///< centre of the first voxel, mm, in the space
  Vector3 Scale = Vector3::Ones(); ///< mm per unit of the space's axes, or of the index axes
  std::string UnitNote;            ///< empty for mm and for a header without a unit
  bool IsAnatomical = false;       ///< whether the space defines its orientation in the patient
  Vector3 Signs = Vector3::Ones(); ///< of LPS coordinates relative to those of the space
};
} // namespace palpate
