#pragma once

#include "PalpateStudyModule.h"
#include "SceneSettings.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
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

/// All that is open and how, as a value: a scene with what the window adds. A session file holds
/// it, and undo goes back to it. Files are absolute and normal (see StudyPath), or empty.
struct StudyState : SceneSettings
{
  std::filesystem::path VolumeFile;       ///< or the folder of a DICOM series
  std::string DicomSeries;                ///< see VolumeChoice
  std::filesystem::path SegmentationFile; ///< its labels lie over the slices

  std::vector<StudyLandmark> Landmarks;
  std::vector<StudyDistance> Distances;
  StudyView View;
};

PALPATESTUDY_EXPORT bool operator==(const StudyLandmark& a, const StudyLandmark& b);
PALPATESTUDY_EXPORT bool operator==(const StudyDistance& a, const StudyDistance& b);
PALPATESTUDY_EXPORT bool operator==(const StudyView& a, const StudyView& b);
PALPATESTUDY_EXPORT bool operator==(const StudyState& a, const StudyState& b);
inline bool operator!=(const StudyState& a, const StudyState& b)
{
  return !(a == b);
}

/// A file as a state names it, whatever the program's folder is later; empty stays empty.
PALPATESTUDY_EXPORT std::filesystem::path StudyPath(const std::filesystem::path& file);

} // namespace palpate
