/**
 * @class vtkImageDisplay
 * @brief what slices show of a volume and its segmentation, shared by linked views
 *
 * A volume with window and level, and label images that are painted over it in colours. Images keep
 * their direction matrix and may lie on any grids; they are shown where world coordinates say. None
 * is copied.
 *
 * Views look at the modification times of this object and of its images when they draw. Whoever
 * wants to know when to draw observes its ModifiedEvent.
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
  /** The volume; of several components the first is shown. Another one chooses its window. */
  void SetImage(vtkImageData* image);
  vtkImageData* GetImage();
  ///@}

  ///@{
  /**
   * What is black and what is white: level -/+ half of the window. The window is not below a
   * thousandth of what the volume would choose; numbers that are none are ignored.
   */
  void SetWindowLevel(double window, double level);
  double GetWindow();
  double GetLevel();
  ///@}
  /** From the 1st to the 99.5th percentile of the volume. */
  void ResetWindowLevel();
  /** The window that the volume chooses: by it drags are measured. */
  vtkGetMacro(ChosenWindow, double);

  ///@{
  /** Whether values between voxels are interpolated (the default) or those of the nearest. */
  void SetInterpolate(bool interpolate);
  bool GetInterpolate();
  vtkBooleanMacro(Interpolate, bool);
  ///@}

  /** Adds a label image over those before; the layer's number, from 0. */
  int AddLabels(vtkImageData* labels);
  int GetNumberOfLayers();
  void RemoveAllLabels();
  /** How a label is painted, 0 to 1. Labels without a colour, and with opacity 0, are not. */
  void SetLabelColor(int layer, int label, double red, double green, double blue, double opacity);
  ///@{
  /** Times the opacity of every label. Default: 0.4. */
  void SetLabelOpacity(double opacity);
  double GetLabelOpacity();
  ///@}

  /** The middle of the volume (world, mm); false where there is none. */
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

  std::unique_ptr<palpate::SliceContent> Content;
  double ChosenWindow = 1.0;
};

#endif
