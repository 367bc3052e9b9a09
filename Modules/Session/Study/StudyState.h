#pragma once

#include "FitSettings.h"
#include "LeftHandedAxes.h"
#include "PalpateSessionModule.h"
#include "StudyDial.h"
#include "TouchSettings.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// As what a structure is shown. An error map is its model, coloured by the distance from the
/// surface of its mask.
enum class StudyAppearance
{
  Automatic, ///< as what it is touched
  Model,
  Surface, ///< of its mask
  ErrorMap,
  SubVoxel ///< volume: the field's own surface, ray by ray
};
constexpr std::array<StudyAppearance, 5> AllStudyAppearances{
    {StudyAppearance::Automatic, StudyAppearance::Model, StudyAppearance::Surface,
     StudyAppearance::ErrorMap, StudyAppearance::SubVoxel}};

/// "automatic", "model", "surface", "error map", "sub-voxel volume".
PALPATESESSION_EXPORT const char* NameOf(StudyAppearance appearance);

/// A structure of the segmentation, and how it is to be seen and felt.
struct StudyStructure
{
  int Label = 0;                                ///< by which the segmentation names it
  std::string Name;                             ///< may be empty (see TitleOf)
  std::array<double, 3> Color{{0.9, 0.6, 0.4}}; ///< red, green, blue in 0..1
  bool IsVisible = true;
  bool IsTouchable = true;
  StudyAppearance Appearance = StudyAppearance::Automatic;
  /// Automatic: by harmonics, and by the sub-voxel field where those are refused.
  TouchRepresentation Representation = TouchRepresentation::Automatic;
  int Degree = 12;        ///< of the harmonics
  double Stiffness = 0.5; ///< N/mm
  SurfaceFriction Friction;
  DrillLaw Drill;             ///< how it gives way to the drill; without wear it does not
  bool IsForbidden = false;   ///< no drill removes any of it
  double AlarmDistance = 2.0; ///< mm from the drill to it, where it is forbidden

  /// Then it is touched by its sub-voxel field, whatever else is chosen.
  bool IsDrilled() const noexcept
  {
    return GivesWayToDrill(this->IsTouchable, this->IsForbidden, this->Drill);
  }
};

/// Where the device's workspace lies in the patient.
struct StudyPlacement
{
  std::optional<double> Scale; ///< mm of the scene for one of the device; none: all is in reach
  std::optional<Vector3> CenterWorld; ///< mm, of the workspace; none: the middle of the scene
  bool AxesFollowCamera = true;       ///< else they are the patient's
};

/// A point with a name; mm, patient LPS.
struct StudyLandmark
{
  std::string Name;
  Vector3 PositionWorld = Vector3::Zero();
};

/// A straight way between two points; mm, patient LPS.
struct StudyDistance
{
  std::string Name;
  Vector3 FromWorld = Vector3::Zero();
  Vector3 ToWorld = Vector3::Zero();

  double Length() const { return (this->ToWorld - this->FromWorld).norm(); } ///< mm
};

/// Where one looks; nothing is computed from it.
struct StudyView
{
  std::optional<Vector3> CrosshairWorld; ///< mm, that the slices go through; none: the middle
  std::optional<double> Window;          ///< of intensities, its width; none: by the volume
  std::optional<double> Level;           ///< and its middle
  std::string Layout;                    ///< the window's own word; empty: its first one
  double OverlayOpacity = 0.5;           ///< of the segmentation over the slices, 0..1
  bool UsesVolumeAxes = true;            ///< slices along the volume's axes, else the patient's
  bool SlicesFollowProbe = false;
};

/// All that is open and how, as a value: what a session file holds and what undo goes back to.
/// Files are absolute and normal (see StudyPath), or empty.
struct StudyState
{
  std::filesystem::path VolumeFile; ///< or the folder of a DICOM series
  std::string DicomSeries;          ///< see VolumeChoice
  std::filesystem::path SegmentationFile;
  LeftHandedAxes LeftHanded = LeftHandedAxes::Reverse; ///< of both files

  std::vector<StudyStructure> Structures;
  FitSettings Fit; ///< of all structures, but for the degree, which is that of new ones
  FieldInterpolation Interpolation = FieldInterpolation::Trilinear; ///< of sub-voxel fields
  double FieldSmoothing = 1.0;                                      ///< of them, in voxels

  TouchToolSettings Tool;
  TouchDrillSettings Drill;         ///< how the tool runs where something is drilled
  std::string Device = "simulated"; ///< as DeviceRegistry::Make takes it
  double Rate = 1000.0;             ///< Hz, of the servo
  /// Else how structures are felt is not as they and `Interpolation` say.
  StudyDial Dial = StudyDial::ByHand;
  StudyPlacement Placement;

  std::vector<StudyLandmark> Landmarks;
  std::vector<StudyDistance> Distances;
  StudyView View;
};

PALPATESESSION_EXPORT bool operator==(const StudyStructure& a, const StudyStructure& b);
PALPATESESSION_EXPORT bool operator==(const StudyPlacement& a, const StudyPlacement& b);
PALPATESESSION_EXPORT bool operator==(const StudyLandmark& a, const StudyLandmark& b);
PALPATESESSION_EXPORT bool operator==(const StudyDistance& a, const StudyDistance& b);
PALPATESESSION_EXPORT bool operator==(const StudyView& a, const StudyView& b);
PALPATESESSION_EXPORT bool operator==(const StudyState& a, const StudyState& b);
inline bool operator!=(const StudyState& a, const StudyState& b)
{
  return !(a == b);
}

/// A file as a state names it, whatever the program's folder is later; empty stays empty.
PALPATESESSION_EXPORT std::filesystem::path StudyPath(const std::filesystem::path& file);

/// Its name, or "label 3" where it has none.
PALPATESESSION_EXPORT std::string TitleOf(const StudyStructure& structure);

/// The structure of a label, or nothing.
PALPATESESSION_EXPORT const StudyStructure* FindStructure(const StudyState& state, int label);

/// How a structure of a state is fitted.
PALPATESESSION_EXPORT FitSettings FitSettingsOf(const StudyState& state,
                                                const StudyStructure& structure);
} // namespace palpate
