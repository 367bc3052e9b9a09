/**
 * @class vtkSliceView
 * @brief what a renderer shows of one plane through a volume, linked to other views
 *
 * The plane passes through the shared vtkCrosshair; hung as radiologists do. What is shown, and how
 * views are linked, is vtkLinkedView's; surfaces are shown as contours.
 *
 * The picture is sampled from the volume at the view's own pixels, in world coordinates: volumes on
 * oblique grids are shown where they are. The camera is the view's: parallel, in front of the
 * plane. Letters of the patient's directions, a scale bar and the slice's place can be switched
 * off.
 *
 * vtkInteractorStyleSlice joins mouse and keys to it.
 */
#ifndef vtkSliceView_h
#define vtkSliceView_h

#include "PalpateInteractionModule.h" // For export macro
#include "vtkLinkedView.h"

#include <memory> // For what is drawn

namespace palpate
{
struct SlicePosition;
} // namespace palpate

class PALPATEINTERACTION_EXPORT vtkSliceView : public vtkLinkedView
{
public:
  static vtkSliceView* New();
  vtkTypeMacro(vtkSliceView, vtkLinkedView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Orientations
  {
    AXIAL,   ///< from the feet, the patient's front up
    CORONAL, ///< from the front, the head up
    SAGITTAL ///< from the left, the head up
  };

  /** Another one fits the view to its volume. */
  void SetImageDisplay(vtkImageDisplay* display) override;
  void AddSurface(vtkSurfaceDisplay* surface) override;
  void RemoveSurface(vtkSurfaceDisplay* surface) override;

  ///@{
  vtkSetClampMacro(Orientation, int, AXIAL, SAGITTAL);
  vtkGetMacro(Orientation, int);
  ///@}

  /** Shows the whole volume in the middle, when it is drawn next. */
  void FitToImage();
  /** Moves the crosshair so many slices to the patient's head, front or right. */
  void Scroll(int slices);
  /** The slice's number from 1, and how many there are; 0 where they have none. */
  int GetSliceNumber();
  int GetNumberOfSlices();
  /** Makes everything larger by a factor; what is at that place of the window (pixels) stays there.
   */
  void Zoom(double factor, double x, double y);
  /** Moves the picture by pixels to the right and up. */
  void Pan(double right, double up);
  /** Puts the crosshair into the middle of the view. */
  void CenterOnCrosshair();
  /** mm that a pixel shows. */
  double GetPixelMillimeters();

  /** The point (world, mm) of the plane at a place of the window in pixels: its middle. */
  void DisplayToWorld(double x, double y, double world[3]);
  /** Moves the crosshair there. */
  void MoveCrosshairTo(double x, double y);

#ifndef __VTK_WRAP__
  /** What is shown at the moment. */
  palpate::SlicePosition GetPosition();
  /** How often the picture was sampled and contours were cut so far. */
  int GetPaintCount() const;
  int GetCutCount() const;
#endif

protected:
  vtkSliceView();
  ~vtkSliceView() override;

  void AddTo(vtkRenderer* renderer) override;
  void RemoveFrom(vtkRenderer* renderer) override;
  void UpdateFor(vtkRenderer* renderer) override;

private:
  vtkSliceView(const vtkSliceView&) = delete;
  void operator=(const vtkSliceView&) = delete;

  void Fit();
  void PlaceCamera(vtkRenderer* renderer, const palpate::SlicePosition& position);
  void UpdatePicture(const palpate::SlicePosition& position);

  int Orientation = AXIAL;

  struct State;
  std::unique_ptr<State> Inner;
};

#endif
