#pragma once

#include "PalpateStudyModule.h"
#include "SceneSettings.h"
#include "StudyCorrection.h"
#include "StudyDrawing.h"
#include "StudyMeasurement.h"
#include "VolumeColors.h"
#include "VolumePreset.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// A named point; mm, patient LPS.
struct StudyLandmark
{
  std::string Name;
  Vector3 PositionWorld = Vector3::Zero();
};

/// How a volume is drawn in the 3-D view, beside the surfaces.
struct StudyRendering
{
  bool IsShown = false;
  VolumePreset Preset = VolumePreset::Bone;
};

/// A further volume, which slices show over the first one. It may have any grid.
struct StudyVolume
{
  int Id = 0;                      ///< unique in a study, from 1
  std::filesystem::path File;      ///< or the folder of a DICOM series
  std::string Series;              ///< see VolumeChoice
  std::filesystem::path Transform; ///< moves it onto the first one (see ReadTransform); or empty
  bool IsVisible = true;           ///< if not, it is not read
  std::optional<double> Window;    ///< intensity window width; none: by the volume
  std::optional<double> Level;     ///< intensity window centre
  VolumeColors Colors = VolumeColors::Grey;
  double Opacity = 0.5;    ///< of a blend, 0..1
  bool HidesBelow = false; ///< values up to the window's low end are transparent
  StudyRendering Rendering;
};

/// Where further volumes cover the first one in slices.
enum class StudyMixing
{
  Blend,
  Checkerboard,
  Curtain
};

/// View settings; no product depends on them.
struct StudyView
{
  std::optional<Vector3> CrosshairWorld; ///< mm, common point of the slices; none: the centre
  std::optional<double> Window;          ///< intensity window width; none: by the volume
  std::optional<double> Level;           ///< intensity window centre
  std::string Layout;                    ///< name defined by the window; empty: its first one
  double OverlayOpacity = 0.5;           ///< of the segmentation over the slices, 0..1
  bool UsesVolumeAxes = true;            ///< slices along the volume's axes, else the patient's
  bool SlicesFollowProbe = true;
  StudyMixing Mixing = StudyMixing::Blend;
  double Curtain = 0.5;             ///< its place as a fraction of a slice's width, 0..1
  std::optional<double> ErrorScale; ///< mm at the ends of error maps' colours; none: two voxels
};

/// The complete state of a study as a value: a scene with the window's additions. Saved in session
/// files and restored by undo. Files are absolute and normalised (see StudyPath), or empty.
struct StudyState : SceneSettings
{
  std::filesystem::path VolumeFile;       ///< or the folder of a DICOM series
  std::string DicomSeries;                ///< see VolumeChoice
  StudyRendering Rendering;               ///< of that volume
  std::vector<StudyVolume> Volumes;       ///< over the first one, in this order
  std::filesystem::path SegmentationFile; ///< its labels are overlaid on the slices

  std::vector<StudyLandmark> Landmarks;
  std::vector<StudyMeasurement> Measurements; ///< at most one is open
  StudyDrawing Drawing;
  StudyCorrection Correction;
  StudyView View;
};

PALPATESTUDY_EXPORT bool operator==(const StudyLandmark& a, const StudyLandmark& b);
PALPATESTUDY_EXPORT bool operator==(const StudyRendering& a, const StudyRendering& b);
PALPATESTUDY_EXPORT bool operator==(const StudyVolume& a, const StudyVolume& b);
PALPATESTUDY_EXPORT bool operator==(const StudyView& a, const StudyView& b);
PALPATESTUDY_EXPORT bool operator==(const StudyState& a, const StudyState& b);
inline bool operator!=(const StudyState& a, const StudyState& b)
{
  return !(a == b);
}

/// The further volume of this id, or null.
PALPATESTUDY_EXPORT StudyVolume* FindVolume(StudyState& state, int id);
PALPATESTUDY_EXPORT const StudyVolume* FindVolume(const StudyState& state, int id);

/// How a further volume is moved, and structures of its values with it.
PALPATESTUDY_EXPORT SceneMove MoveOf(const StudyState& state, const StudyVolume& volume);

/// The state with another transform of a further volume, and of the structures that were moved by
/// the same file, or if there was none, are of its values; an empty one leaves it where its file
/// says. Throws InputError as ReadMove does.
PALPATESTUDY_EXPORT StudyState WithTransform(const StudyState& state, int volumeId,
                                             const std::filesystem::path& transform);

/// The state that shows one further volume over the first one, the next of the list; none after the
/// last one: for points in time, one by one.
PALPATESTUDY_EXPORT StudyState WithNextVolume(const StudyState& state);

/// A path as stored in a state: absolute, so that it is independent of the working directory; empty
/// stays empty.
PALPATESTUDY_EXPORT std::filesystem::path StudyPath(const std::filesystem::path& file);

} // namespace palpate
