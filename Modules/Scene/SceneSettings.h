#pragma once

#include "DrillForce.h"
#include "FieldBuilder.h"
#include "FitSettings.h"
#include "HarmonicContactModel.h"
#include "LeftHandedAxes.h"
#include "PalpateSceneModule.h"
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
  /// A model by harmonics, a surface by facets, voxels by the sub-voxel field.
  static constexpr const char* Automatic = "automatic";
  static constexpr const char* Harmonics = "harmonics";
  static constexpr const char* Facets = "facets";
  static constexpr const char* SubVoxel = "sub-voxel";
  /// Harmonics where they fit, otherwise the sub-voxel field.
  static constexpr const char* ModelOrField = "model-or-field";
};

/// As what a structure is displayed. An error map is its model, coloured by the distance from the
/// surface of its mask.
enum class SceneAppearance
{
  Automatic, ///< as what it is touched
  Model,
  Surface,
  ErrorMap,
  SubVoxel ///< volume: the field's own surface, ray by ray
};
constexpr std::array<SceneAppearance, 5> AllSceneAppearances{
    {SceneAppearance::Automatic, SceneAppearance::Model, SceneAppearance::Surface,
     SceneAppearance::ErrorMap, SceneAppearance::SubVoxel}};

/// "automatic", "model", "surface", "error map", "sub-voxel volume".
PALPATESCENE_EXPORT const char* NameOf(SceneAppearance appearance);

/// What a structure is made from.
enum class SceneSource
{
  Label,    ///< of a segmentation
  IsoValue, ///< of an image: what has at least this value
  Model,
  Surface
};

/// One structure of a scene: what it is made from, how it is displayed and how it is felt. As read
/// from a file or a command line, one entry may stand for several labels of a segmentation (see
/// ResolveLabels).
struct SceneStructure
{
  int Id = 0;                      ///< unique in a scene; of a label its number where that is free
  std::string Name;                ///< may be empty (see TitleOf)
  std::filesystem::path File;      ///< a model, a surface, a segmentation, or an image with `Iso`
  std::vector<std::string> Labels; ///< of a segmentation, numbers or names; empty: all of them
  std::optional<double> Iso;       ///< of an image: what has at least this value

  /// Nothing is made that is neither displayed nor touched nor forbidden, and its file isn't
  /// opened.
  bool IsVisible = true;
  bool IsTouchable = true;
  std::array<double, 3> Color{{0.9, 0.6, 0.4}}; ///< red, green, blue in 0..1
  SceneAppearance Appearance = SceneAppearance::Automatic;

  std::string Representation = TouchRepresentation::Automatic; ///< its name
  int Degree = 12; ///< of the harmonics that a label is fitted with
  HarmonicContactMode Mode = HarmonicContactMode::Nearest; ///< of harmonics
  FieldInterpolation Interpolation = FieldInterpolation::Trilinear;
  double Smoothing = 1.0; ///< of a label's field, in voxels

  double Stiffness = 0.5; ///< N/mm
  double Damping = 0.0;   ///< N s/mm
  SurfaceFriction Friction;
  /// Of force effects and representations (see SceneEffectKind and SceneRepresentation), by their
  /// keys in files; none is 0.
  std::map<std::string, double> Numbers;
  /// Of force effects, by their keys in files.
  std::map<std::string, std::filesystem::path> Images;
  /// 0 without such a number.
  PALPATESCENE_EXPORT double Number(const std::string& key) const;
  /// Empty without such an image.
  PALPATESCENE_EXPORT std::filesystem::path Image(const std::string& key) const;
  PALPATESCENE_EXPORT void SetNumber(const std::string& key, double number);
  PALPATESCENE_EXPORT void SetImage(const std::string& key, const std::filesystem::path& image);

  DrillLaw Drill;             ///< how the drill wears it down; without wear it does not
  bool IsForbidden = false;   ///< no drill removes any of it, whatever else it is part of
  double AlarmDistance = 2.0; ///< mm from the tool to a forbidden structure

  /// Then it is touched by its sub-voxel field, whatever else is chosen.
  bool IsDrilled() const noexcept
  {
    return this->IsTouchable && !this->IsForbidden && this->Drill.Wear > 0.0;
  }
  /// By its iso-value, or else by the ending of its file.
  PALPATESCENE_EXPORT SceneSource Source() const;
};

/// How a scene's tool runs as a drill.
struct TouchDrillSettings
{
  double Turns = 1000.0;             ///< a second
  double VibrationFrequency = 120.0; ///< Hz
};

/// Where the device's workspace lies in the patient.
struct ScenePlacement
{
  std::optional<double> Scale; ///< mm of the scene for one of the device; none: all is in reach
  std::optional<Vector3> CenterWorld; ///< mm, of the workspace; none: the centre of the scene
  bool AxesFollowCamera = true;       ///< where there is one; otherwise they are the patient's
};

/// What is displayed and touched, with what tool and by which device: a value that a scene file, a
/// command line and a session share.
struct SceneSettings
{
  std::vector<SceneStructure> Structures;
  LeftHandedAxes LeftHanded = LeftHandedAxes::Reverse; ///< of all images
  FitSettings Fit; ///< of all labels, but for the degree, which is that of new structures
  TouchToolSettings Tool;
  TouchDrillSettings Drill;
  std::string Device = "simulated"; ///< as DeviceRegistry::Make takes it
  double Rate = 1000.0;             ///< Hz, of the servo
  int ModelInterval = 1;            ///< ticks from one question to the models to the next
  ScenePlacement Placement;
};

PALPATESCENE_EXPORT bool operator==(const SceneStructure& a, const SceneStructure& b);
PALPATESCENE_EXPORT bool operator==(const ScenePlacement& a, const ScenePlacement& b);
PALPATESCENE_EXPORT bool operator==(const SceneSettings& a, const SceneSettings& b);

/// Its name, or "label 3" or the file's name where it has none.
PALPATESCENE_EXPORT std::string TitleOf(const SceneStructure& structure);

/// The structure of an id, or null.
PALPATESCENE_EXPORT const SceneStructure* FindStructure(const SceneSettings& scene, int id);

/// How a label of a scene is fitted.
PALPATESCENE_EXPORT FitSettings FitSettingsOf(const SceneSettings& scene,
                                              const SceneStructure& structure);
} // namespace palpate
