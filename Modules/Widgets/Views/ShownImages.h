#pragma once

#include "GreyWindow.h"
#include "StructurePlaces.h"
#include "StudyPipeline.h"
#include "StudyState.h"

#include "vtkImageDisplay.h"
#include "vtkNew.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// The images that the views of a window share: volumes, and labels over them.
class ShownImages
{
public:
  /// The newest volumes and labels. Returns whether the first image is another one.
  bool Show(const StudyState& state, const StudyPipeline& pipeline);
  /// Colours and opacities of the labels, by their structures.
  void ShowLabels(const StudyState& state, const StructurePlaces& places);

  vtkImageDisplay* Display() const { return this->Shown; }
  const std::shared_ptr<const Segmentation>& Labels() const { return this->LabelsShown; }
  /// The overlay of the display that shows a further volume; none if it is not shown.
  std::optional<int> OverlayOf(int id) const;
  /// The image of a further volume; null if it is not shown.
  vtkImageData* ImageOf(int id) const;
  /// The values of the volumes and the names of the labels at a point (world, mm).
  std::string TextAt(const Vector3& pointWorld) const;

private:
  struct Overlay
  {
    StudyVolume Settings;
    std::shared_ptr<const Volume> Image;
    GreyWindow Automatic;
  };

  bool ShowFirst(std::shared_ptr<const Volume> grey,
                 const std::shared_ptr<const Segmentation>& labels);
  void ShowLabelImages(std::shared_ptr<const Segmentation> labels);
  void ShowOverlays(const StudyState& state, const StudyPipeline& pipeline);
  void Set(int number, const Overlay& overlay);

  vtkNew<vtkImageDisplay> Shown;
  // The displayed products; they are shared and never changed.
  std::shared_ptr<const Volume> Grey;
  std::shared_ptr<const Segmentation> LabelsShown;
  std::vector<Overlay> Overlays;
  std::vector<SceneStructure> Structures; ///< whose colours the labels have
};
} // namespace palpate
