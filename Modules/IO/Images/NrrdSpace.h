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
  /// From the fields of a header (ReadNrrdFields). To be made before the library reads the header:
  /// ITK 5.2 writes beyond its arrays where a space has more dimensions than the image has axes.
  /// Throws InputError, naming `file`, for a space that patient LPS cannot be made of (left-handed,
  /// with a time axis, of another dimension than three, unknown), and for directions and an origin
  /// that do not place three axes.
  NrrdSpace(const std::filesystem::path& file, const std::map<std::string, std::string>& fields);

  /// Puts origin, spacing (mm) and direction of a grid, which the library has read, where "space
  /// directions" and "space origin" say. The library's own conversion to LPS cannot be relied on:
  /// ITK 5.2 mirrors left-anterior-superior. Nothing changes where the header gives no directions.
  void PlaceGrid(ImageGrid& grid) const;

  /// Sentences on what had to be assumed, since the header does not say how the axes lie in the
  /// patient.
  std::vector<std::string> Notes() const;

private:
  void TakeName(const std::filesystem::path& file);
  Vector3 ToLps(const Vector3& vector) const;

  std::string Name;                ///< empty where the header names none
  std::vector<Vector3> Steps;      ///< of the index axes, mm, in the space: three or none
  Vector3 First = Vector3::Zero(); ///< centre of the first voxel, mm, in the space
  bool IsAnatomical = false;       ///< whether the space says how it lies in the patient
  Vector3 Signs = Vector3::Ones(); ///< of LPS coordinates, by coordinates of the space
};
} // namespace palpate
