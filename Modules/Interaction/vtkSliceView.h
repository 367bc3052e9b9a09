/**
 * @class vtkSliceView
 * @brief one plane through a volume in a renderer, linked to other views
 *
 * The plane passes through the shared vtkCrosshair, in radiological or neurological convention. For
 * contents and links see vtkLinkedView; surfaces are shown as contours.
 *
 * The volume is sampled at the view's pixels, in world coordinates: volumes on oblique grids are
 * shown at their positions. The view controls the camera: parallel, in front of the plane. Letters
 * of the patient's directions, a scale bar and the slice's position can be switched off.
 *
 * vtkInteractorStyleSlice handles mouse and keys.
 */
#ifndef vtkSliceView_h
#define vtkSliceView_h

#include "PalpateInteractionModule.h" // For export macro
#include "vtkLinkedView.h"

#include <memory> // For what is drawn

class vtkVolume;
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

  /** A new one fits the view to its volume. */
  void SetImageDisplay(vtkImageDisplay* display) override;
  /** Without a volume, the view fits to the surfaces until it is zoomed or moved. */
  void AddSurface(vtkSurfaceDisplay* surface) override;
  void RemoveSurface(vtkSurfaceDisplay* surface) override;

  ///@{
  /** A vtkSubVoxelVolume, shown as a contour. */
  void AddField(vtkVolume* field);
  void RemoveField(vtkVolume* field);
  ///@}

  ///@{
  vtkSetClampMacro(Orientation, int, AXIAL, SAGITTAL);
  vtkGetMacro(Orientation, int);
  ///@}

  ///@{
  /** Axial slices from the head and coronal ones from behind, so that the patient's left is at the
   * left (neurological convention). Off by default: radiological convention. */
  vtkSetMacro(Neurological, bool);
  vtkGetMacro(Neurological, bool);
  vtkBooleanMacro(Neurological, bool);
  ///@}

  ///@{
  /** Whether the annotation begins with the plane's name and the slice's number. On by default. */
  vtkSetMacro(TitleVisibility, bool);
  vtkGetMacro(TitleVisibility, bool);
  vtkBooleanMacro(TitleVisibility, bool);
  ///@}

  /** Shows the whole volume, or without one all surfaces, centred, in the next frame. */
  void FitToImage();
  /** Moves the crosshair by that many slices to the patient's head, front or right. */
  void Scroll(int slices);
  /** The slice's number from 1, and their count; 0 if slices have no numbers. */
  int GetSliceNumber();
  int GetNumberOfSlices();
  /** Enlarges everything by a factor around that position of the window (pixels). */
  void Zoom(double factor, double x, double y);
  /** Moves the contents by pixels to the right and up. */
  void Pan(double right, double up);
  /** Centres a point (world, mm) if it lies beyond the view's edges. */
  void ShowPoint(const double world[3]);
  /** mm per pixel. */
  double GetPixelMillimeters();

  /** The point (world, mm) of the plane at a pixel's centre in the window. */
  void DisplayToWorld(double x, double y, double world[3]);
  /** Moves the crosshair there. */
  void MoveCrosshairTo(double x, double y);

#ifndef __VTK_WRAP__
  /** What is currently shown. */
  palpate::SlicePosition GetPosition();
  /** How often the volume was sampled and contours were cut so far. */
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
  void UpdateImage(const palpate::SlicePosition& position);

  int Orientation = AXIAL;
  bool Neurological = false;
  bool TitleVisibility = true;

  struct State;
  std::unique_ptr<State> Inner;
};

#endif
