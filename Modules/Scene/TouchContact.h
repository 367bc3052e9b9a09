#pragma once

#include "ComplianceMaps.h"
#include "ContactModel.h"
#include "ContentDigest.h"
#include "OrganContact.h"
#include "OrganModel.h"
#include "PalpateSceneModule.h"
#include "ScalarField.h"
#include "ScanCut.h"
#include "TouchScene.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// Source of a drilled structure: the region where an image reaches a value, or a label of a label
/// map.
struct DrillSource
{
  std::shared_ptr<const ScalarField> Field; ///< null: not drilled
  vtkSmartPointer<vtkImageData> Image;
  std::optional<int> Label; ///< none: an image
  ContentDigest Voxels;     ///< of the image's values and grid
};

/// A structure's contact model.
struct TouchContact
{
  std::shared_ptr<const ContactModel> Model;
  std::shared_ptr<const ScalarField> Field; ///< that it is made from; null: of another kind
  std::string Represented;                  ///< "harmonics of degree 12, nearest point"
  bool Yields = false;                      ///< then the scene's stiffness does not count
  DrillSource Drilled;                      ///< for a field that keeps its inside
  std::vector<ScanCut> Cuts;                ///< that are not felt
};

/// The kinds of contacts. `file` is for messages. Throw InputError if it cannot be touched;
/// a surface model has no radius for RadialContactMode::Radial.
PALPATESCENE_EXPORT TouchContact MakeModelContact(const OrganModel& model, RadialContactMode mode,
                                                  const std::filesystem::path& file);
/// Throws InputError also for a surface model. `tissue` describes what it is made of; may be empty.
PALPATESCENE_EXPORT TouchContact MakeElasticContact(const OrganModel& model,
                                                    const ComplianceMaps& maps,
                                                    const std::string& tissue,
                                                    const std::filesystem::path& file);
PALPATESCENE_EXPORT TouchContact MakeFacetContact(vtkPolyData* surface,
                                                  const std::filesystem::path& file);
PALPATESCENE_EXPORT TouchContact MakeFieldContact(const std::shared_ptr<const ScalarField>& field,
                                                  int material, const std::filesystem::path& file);
} // namespace palpate
