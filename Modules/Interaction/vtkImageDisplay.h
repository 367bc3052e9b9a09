/**
 * @class vtkImageDisplay
 * @brief display of a volume and its segmentation in slices, shared by linked views
 *
 * A volume with window and level, further volumes over it, and label images over them in colours.
 * Images keep their direction matrix and may be on any grids; they are shown at their world
 * coordinates. None is copied.
 *
 * Views check the modification times of this object and of its images when they draw. Observe its
 * ModifiedEvent to know when to draw.
 */
#ifndef vtkImageDisplay_h
#define vtkImageDisplay_h

#include "PalpateInteractionModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For what is shown

class vtkImageData;

namespace palpate
{
struct SliceContent;
} // namespace palpate

class PALPATEINTERACTION_EXPORT vtkImageDisplay : public vtkObject
{
public:
  static vtkImageDisplay* New();
  vtkTypeMacro(vtkImageDisplay, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The volume; of several components the first is shown. A new volume resets the window. */
  void SetImage(vtkImageData* image);
  vtkImageData* GetImage();
  ///@}

  ///@{
  /**
   * Black and white are level -/+ half of the window. The window is at least a thousandth of the
   * volume's default; non-finite numbers are ignored.
   */
  void SetWindowLevel(double window, double level);
  double GetWindow();
  double GetLevel();
  ///@}
  /** From the 1st to the 99.5th percentile of the volume. */
  void ResetWindowLevel();
  /** The volume's default window: the unit of drags. */
  vtkGetMacro(ChosenWindow, double);

  ///@{
  /** Whether values between voxels are interpolated (the default) or taken from the nearest. */
  void SetInterpolate(bool interpolate);
  vtkBooleanMacro(Interpolate, bool);
  ///@}

  ///@{
  /**
   * Further volumes over the first one, in this order, with window and level, colours (see
   * palpate::VolumeColors) and the opacity of a blend, 0 to 1. Non-finite numbers are ignored.
   * AddOverlay returns the overlay's number, from 0; its window is that of ResetWindowLevel.
   */
  int AddOverlay(vtkImageData* image);
  int GetNumberOfOverlays();
  void RemoveAllOverlays();
  void SetOverlayWindowLevel(int overlay, double window, double level);
  double GetOverlayWindow(int overlay);
  double GetOverlayLevel(int overlay);
  void SetOverlayColors(int overlay, int colors);
  void SetOverlayOpacity(int overlay, double opacity);
  /** Whether values up to the low end of its window are transparent. Default: false. */
  void SetOverlayHidesBelow(int overlay, bool hides);
  ///@}

  enum
  {
    BLEND,
    CHECKERBOARD,
    CURTAIN
  };
  ///@{
  /** Where overlays cover the volume. Default: BLEND, with their opacities. */
  void SetMixing(int mixing);
  int GetMixing();
  ///@}
  ///@{
  /** CURTAIN shows overlays to the left of this fraction of the picture's width. Default: 0.5. */
  void SetCurtain(double place);
  double GetCurtain();
  ///@}

  /** Adds a label image over the previous ones. Returns the layer's number, from 0. */
  int AddLabels(vtkImageData* labels);
  int GetNumberOfLayers();
  void RemoveAllLabels();
  /** A label's colour and opacity, 0 to 1. Labels without a colour, or with opacity 0, are not
   * painted. */
  void SetLabelColor(int layer, int label, double red, double green, double blue, double opacity);
  ///@{
  /** Factor on the opacity of every label. Default: 0.4. */
  void SetLabelOpacity(double opacity);
  double GetLabelOpacity();
  ///@}

  ///@{
  /**
   * Paints the volume's values from `low` to `high` (infinity: all higher ones) in a colour, only
   * inside the voxels of `mask` that have this label unless it is null, as a preview of the region.
   * A new volume ends it. Values that are no numbers are ignored.
   */
  void MarkValues(double low, double high, vtkImageData* mask = nullptr, int label = 0);
  void ClearMarkedValues();
  bool HasMarkedValues();
  ///@}

  /** The centre of the volume (world, mm). Returns false without a volume. */
  bool GetCenterWorld(double center[3]);

  /** The latest of its own time and those of its images. */
  vtkMTimeType GetMTime() override;

#ifndef __VTK_WRAP__
  const palpate::SliceContent& GetContent() const
  {
    return *this->Content;
  }
#endif

protected:
  vtkImageDisplay();
  ~vtkImageDisplay() override;

private:
  vtkImageDisplay(const vtkImageDisplay&) = delete;
  void operator=(const vtkImageDisplay&) = delete;

  bool HasOverlay(int overlay);

  std::unique_ptr<palpate::SliceContent> Content;
  double ChosenWindow = 1.0;
};

#endif
