#pragma once

#include "DrillForce.h"
#include "FieldBuilder.h"
#include "FitSettings.h"
#include "GuideSettings.h"
#include "LeftHandedAxes.h"
#include "OrganContact.h"
#include "PalpateSceneModule.h"
#include "SceneMove.h"
#include "SurfaceFriction.h"
#include "TouchToolSettings.h"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// Names of the representations by which structures can be touched (see SceneRepresentation).
struct TouchRepresentation
{
  /// A model by harmonics (one that yields, elastically), a surface by facets, voxels by the
  /// sub-voxel field.
  static constexpr const char* Automatic = "automatic";
  static constexpr const char* Harmonics = "harmonics";
  static constexpr const char* Facets = "facets";
  static constexpr const char* SubVoxel = "sub-voxel";
  static constexpr const char* Elastic = "elastic"; ///< a model, or one of a label, that yields
  /// Harmonics where they fit, otherwise the sub-voxel field.
  static constexpr const char* ModelOrField = "model-or-field";
};

/// How a structure is displayed. An error map is its model, coloured by the distance from the
/// surface of its mask; a stiffness map is a model that yields, coloured by the force on a ball
/// that is pressed into it.
enum class SceneAppearance
{
  Automatic, ///< the representation that is touched
  Model,
  Surface,
  ErrorMap,
  SubVoxel, ///< volume: the field's own surface, by ray casting
  StiffnessMap
};
constexpr std::array<SceneAppearance, 6> AllSceneAppearances{
    {SceneAppearance::Automatic, SceneAppearance::Model, SceneAppearance::Surface,
     SceneAppearance::ErrorMap, SceneAppearance::SubVoxel, SceneAppearance::StiffnessMap}};

/// "automatic", "model", "surface", "error map", "sub-voxel volume", "stiffness map".
PALPATESCENE_EXPORT const char* NameOf(SceneAppearance appearance);

/// Source of a structure.
enum class SceneSource
{
  Label,    ///< of a segmentation
  IsoValue, ///< of an image: the region of at least this value, which may be limited
  Model,
  Surface
};

/// One structure of a scene: its source, its display and its touch. As read from a file or a
/// command line, one entry may represent several labels of a segmentation (see ResolveLabels).
struct SceneStructure
{
  int Id = 0;                       ///< unique in a scene; of a label its number if that is free
  std::string Name;                 ///< may be empty (see TitleOf)
  std::filesystem::path File;       ///< a model, a surface, a segmentation, or an image with `Iso`
  std::vector<std::string> Labels;  ///< of a segmentation, numbers or names; empty: all
  std::optional<double> Iso;        ///< of an image: the region of at least this value
  std::optional<double> IsoUpper;   ///< limits it to at most this value
  std::filesystem::path WithinFile; ///< limits it to a label of this segmentation
  std::string WithinLabel;          ///< number or name of that label
  std::string Series;               ///< of the image, as in VolumeChoice
  SceneMove Move;                   ///< of all its files

  /// If a structure is neither displayed nor touched nor forbidden, nothing is made and its file is
  /// not opened.
  bool IsVisible = true;
  bool IsTouchable = true;
  /// Where the border of its image cuts a label: felt as if the structure ended there. Otherwise a
  /// tool passes there without force; a drilled structure always keeps them.
  bool KeepsCuts = false;
  std::array<double, 3> Color{{0.9, 0.6, 0.4}}; ///< red, green, blue in 0..1
  double Opacity = 1.0; ///< in 3D and over slices, 0..1; does not affect touch
  SceneAppearance Appearance = SceneAppearance::Automatic;

  std::string Representation = TouchRepresentation::Automatic; ///< its name
  int Degree = 12;                                     ///< of the harmonics fitted to a label
  RadialContactMode Mode = RadialContactMode::Nearest; ///< of harmonics
  FieldInterpolation Interpolation = FieldInterpolation::Trilinear;
  double Smoothing = 1.0; ///< of a label's field, in voxels

  double Stiffness = 0.5; ///< N/mm
  double Damping = 0.0;   ///< N s/mm
  SurfaceFriction Friction;
  /// Of force effects and representations (see SceneEffectKind and SceneRepresentation), by their
  /// keys in files; missing ones are 0.
  std::map<std::string, double> Numbers;
  /// Of force effects, by their keys in files.
  std::map<std::string, std::filesystem::path> Images;
  /// 0 if there is no such number.
  PALPATESCENE_EXPORT double Number(const std::string& key) const;
  /// Empty if there is no such image.
  PALPATESCENE_EXPORT std::filesystem::path Image(const std::string& key) const;
  PALPATESCENE_EXPORT void SetNumber(const std::string& key, double number);
  PALPATESCENE_EXPORT void SetImage(const std::string& key, const std::filesystem::path& image);

  DrillLaw Drill;           ///< how the drill removes it; not at all if wear is 0
  bool IsForbidden = false; ///< protected from the drill, even where it overlaps drilled structures
  double AlarmDistance = 2.0; ///< mm from the tool, if forbidden

  /// Drilled structures are touched by their sub-voxel field, regardless of Representation.
  bool IsDrilled() const noexcept
  {
    return this->IsTouchable && !this->IsForbidden && this->Drill.Wear > 0.0;
  }
  /// Whether an iso-value is limited, so that the structure is a part of a region of the image.
  bool IsLimited() const noexcept
  {
    return this->Iso && (this->IsoUpper || !this->WithinFile.empty());
  }
  /// Determined by its iso-value, otherwise by the ending of its file.
  PALPATESCENE_EXPORT SceneSource Source() const;
};

/// Motion of the tool as a drill.
struct TouchDrillSettings
{
  double Turns = 1000.0;             ///< 1/s
  double VibrationFrequency = 120.0; ///< Hz
};

/// Placement of the device's workspace in the patient.
struct ScenePlacement
{
  std::optional<double> Scale;        ///< mm of the scene per mm of the device; none: all in reach
  std::optional<Vector3> CenterWorld; ///< mm, of the workspace; none: the centre of the scene
  bool AxesFollowCamera = true;       ///< if there is one; otherwise the patient's axes
};

/// A scene as a value: structures, tool and device. Shared by scene files, the command line and
/// sessions.
struct SceneSettings
{
  std::vector<SceneStructure> Structures;
  std::vector<GuideSettings> Guides;
  LeftHandedAxes LeftHanded = LeftHandedAxes::Reverse; ///< of all images
  FitSettings Fit; ///< of all labels, except the degree, which applies to new structures
  TouchToolSettings Tool;
  TouchDrillSettings Drill;
  std::string Device = "simulated"; ///< as DeviceRegistry::Make takes it
  double Rate = 1000.0;             ///< Hz, of the servo
  int ModelInterval = 1;            ///< ticks between queries of the contact models
  ScenePlacement Placement;
};

PALPATESCENE_EXPORT bool operator==(const SceneStructure& a, const SceneStructure& b);
PALPATESCENE_EXPORT bool operator==(const ScenePlacement& a, const ScenePlacement& b);
PALPATESCENE_EXPORT bool operator==(const SceneSettings& a, const SceneSettings& b);

/// The structure's name; if empty, "label 3" or the name of its file.
PALPATESCENE_EXPORT std::string TitleOf(const SceneStructure& structure);

/// The structure with this id, or null.
PALPATESCENE_EXPORT const SceneStructure* FindStructure(const SceneSettings& scene, int id);

/// Whether any structure is touchable.
PALPATESCENE_EXPORT bool HasTouchable(const SceneSettings& scene);

/// Whether a guide is made by the structure with this id.
PALPATESCENE_EXPORT bool IsGuide(const SceneSettings& scene, int id);

/// Removes the guides of structures that the scene does not have.
PALPATESCENE_EXPORT void DropLooseGuides(SceneSettings& scene);

/// Fit settings for a label of a scene.
PALPATESCENE_EXPORT FitSettings FitSettingsOf(const SceneSettings& scene,
                                              const SceneStructure& structure);
} // namespace palpate
