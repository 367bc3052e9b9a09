#pragma once

#include "ForbiddenStructure.h"
#include "OnDemandDegrees.h"
#include "PalpateSessionModule.h"
#include "Progress.h"
#include "SceneAccount.h"
#include "TouchContact.h"
#include "TouchScene.h"
#include "TouchSettings.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// What a structure that is drilled is made from: what of an image is at least a value, or a label
/// of a label map.
struct DrillSource
{
  std::shared_ptr<const ScalarField> Field;
  vtkSmartPointer<vtkImageData> Image;
  std::optional<int> Label; ///< none: an image
};

/// A structure ready to be touched and to be drawn, and what it took.
struct TouchableStructure
{
  TouchStructure Touch;                         ///< without a model where it is only seen
  TouchAppearance Looks;                        ///< empty where nobody sees it
  std::shared_ptr<OnDemandField> OnDemand;      ///< what is felt; none where all of it is in memory
  std::shared_ptr<OnDemandHarmonics> Harmonics; ///< the same of a model
  DrillSource Drilled;     ///< what is to be drilled, as it is before; without a field: nothing
  std::string Represented; ///< in words, such as "harmonics of degree 12, nearest point"
  double Seconds = 0.0;    ///< to make
  std::vector<std::string> Notes;
};

/// What a scene needs, and an account of it.
struct TouchStructures
{
  std::vector<TouchableStructure> Touched; ///< in the settings' order; some are seen too
  std::vector<TouchableStructure> OnlySeen;
  std::vector<ForbiddenStructure> Forbidden; ///< touched, seen, or neither
  std::shared_ptr<OnDemandDegrees> Degrees;  ///< that harmonics come and go by; none: they stay
  SceneAccount Account;
};

/// Reads the files and makes the models, each only as the settings ask, and nothing of what they do
/// not; drawings only where `isSeen`, since somebody looks. What is touched by voxels is drawn by
/// the field that is felt; what is only seen has no field but a surface. Throws InputError,
/// FilterError and Cancelled.
PALPATESESSION_EXPORT TouchStructures MakeTouchStructures(const TouchSettings& settings,
                                                          bool isSeen,
                                                          const ProgressFunction& progress);

/// What a servo makes for the touched structures to follow them by `settings`' tool, made once to
/// be told of. Throws InputError where they cannot be felt by it.
PALPATESESSION_EXPORT SceneItem AccountForServo(const TouchStructures& made,
                                                const TouchSettings& settings);

/// The tool of the settings. Throws InputError for one that is none.
PALPATESESSION_EXPORT ToolShape MakeTool(const TouchToolSettings& settings);
} // namespace palpate
