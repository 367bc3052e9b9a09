#pragma once

#include "ForceEffect.h"
#include "PalpateSceneModule.h"
#include "Progress.h"
#include "Vector3.h"
#include "Volume.h"

#include <Eigen/Geometry>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
struct SceneStructure;

/// A number of a structure that a force effect or a representation adds to scene files and to the
/// window's dialog.
struct SceneNumber
{
  std::string Key; ///< in files; ends with the unit
  std::string Label;
  double Largest = 1.0;
  int Decimals = 3; ///< 0 for a whole number
  /// Of a choice: words in files, of which the number is the index.
  std::vector<std::string> Words = {};
  double Least = 0.0;     ///< at most 0, which is the default of every number
  std::string Unit = {};  ///< after the number in the window
  std::string Zero = {};  ///< what 0 stands for, in words: "20 kPa (default)"
  std::string Group = {}; ///< of rows in the window; empty: the main one
};

/// What a force effect is made from.
struct SceneEffectSource
{
  const SceneStructure& Structure;
  const Volume* Image = nullptr;   ///< if its kind needs one
  Eigen::AlignedBox3d BoundsWorld; ///< mm, of the structure
  double ToolReach = 0.0;          ///< mm, from the tool's origin to its farthest surface
  bool Yields = false;             ///< then the structure's stiffness is that of its tissue
};

/// A kind of force effect. A structure has it if the first of its numbers is not 0.
struct SceneEffectKind
{
  std::string Name; ///< in messages: "texture"
  std::vector<SceneNumber> Numbers;
  std::string ImageKey; ///< in files; empty if it needs no image
  std::string ImageLabel;
  /// Throws InputError and Cancelled.
  std::function<std::shared_ptr<const ForceEffect>(const SceneEffectSource&,
                                                   const ProgressFunction&)>
      Make;

  PALPATESCENE_EXPORT bool IsIn(const SceneStructure& structure) const;
};

/// The kinds of force effects that scenes can have, in the order in which their forces are added:
/// texture, viscosity, stiffness, guiding gradient, then those that were added.
PALPATESCENE_EXPORT const std::deque<SceneEffectKind>& SceneEffectKinds();

/// Adds a kind for the whole program, or replaces the one of its name, before the first scene is
/// read or shown. It has at least one number.
PALPATESCENE_EXPORT void AddSceneEffectKind(SceneEffectKind kind);

/// The kinds that a structure has.
PALPATESCENE_EXPORT std::vector<const SceneEffectKind*> EffectsOf(const SceneStructure& structure);

/// The effects of a structure that are made from an image, by name.
struct ImageEffects
{
  std::map<std::string, std::shared_ptr<const ForceEffect>> Made;

  PALPATESCENE_EXPORT std::size_t Bytes() const;
};
} // namespace palpate
