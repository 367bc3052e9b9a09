#pragma once

#include "PalpateInteractionModule.h"
#include "VolumePreset.h"
#include "vtkSmartPointer.h"

#include <optional>

class vtkImageData;
class vtkVolume;
class vtkVolumeMapper;

namespace palpate
{
/// A volume as a whole in a 3-D view: by VTK's ray casting, on a graphics card or, without one, on
/// the processor. Other props hide it and are hidden by it, pixel by pixel. Values outside the
/// image are not drawn; of several components the first one is.
class PALPATEINTERACTION_EXPORT RenderedVolume
{
public:
  /// At most this many voxels are drawn (see ReducedImage).
  static constexpr double MostVoxels = 8e6;

  /// Prepares everything that takes long, so that the first frame takes no longer than the others:
  /// on any thread, before the object is passed to that of the views. The image is shared, and not
  /// changed.
  RenderedVolume(vtkImageData* image, bool usesCard);
  RenderedVolume(const RenderedVolume&) = delete;
  RenderedVolume& operator=(const RenderedVolume&) = delete;
  ~RenderedVolume();

  vtkVolume* Prop() const { return this->Shown; }
  /// Colours and opacities by a window (width and level), as slices have it.
  void Show(VolumePreset preset, double window, double level);
  /// Casts at most about so many rays for a view of `width` x `height` pixels; a card casts all.
  void LimitRays(int width, int height, double rays);

private:
  struct Look
  {
    VolumePreset Preset;
    double Window;
    double Level;
  };

  vtkSmartPointer<vtkVolume> Shown;
  vtkSmartPointer<vtkVolumeMapper> Mapper;
  std::optional<Look> Last;
};
} // namespace palpate
