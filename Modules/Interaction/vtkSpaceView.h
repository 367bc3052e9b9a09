/**
 * @class vtkSpaceView
 * @brief what a renderer shows in space, linked to slice views
 *
 * Give it a renderer of any render window, and what is shown: surfaces, plain or coloured by an
 * array with a bar that says what the colours mean; the slices of a volume through a shared
 * vtkCrosshair; landmarks; a haptic tool with its force and the place that it touches. Other props,
 * such as a vtkSubVoxelVolume, are added to the renderer itself. The view brings itself up to date
 * whenever the renderer draws, and does then only what has to be done anew.
 *
 * The camera is the renderer's own: any interactor style moves it. At first, and by LookFrom, it
 * shows everything.
 */
#ifndef vtkSpaceView_h
#define vtkSpaceView_h

#include "PalpateInteractionModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For what is drawn

class vtkCrosshair;
class vtkImageDisplay;
class vtkLandmarks;
class vtkProbeRepresentation;
class vtkRenderer;
class vtkSurfaceDisplay;
class vtkWorkspaceRepresentation;

class PALPATEINTERACTION_EXPORT vtkSpaceView : public vtkObject
{
public:
  static vtkSpaceView* New();
  vtkTypeMacro(vtkSpaceView, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Sides
  {
    ANTERIOR,
    POSTERIOR,
    LEFT,
    RIGHT,
    SUPERIOR,
    INFERIOR
  };

  ///@{
  /** Where it is drawn. The view takes its things away from the renderer before. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /** What is shown; null shows none. */
  void SetImageDisplay(vtkImageDisplay* display);
  void SetCrosshair(vtkCrosshair* crosshair);
  void SetLandmarks(vtkLandmarks* landmarks);
  void SetProbe(vtkProbeRepresentation* probe);
  void SetWorkspace(vtkWorkspaceRepresentation* workspace);
  void AddSurface(vtkSurfaceDisplay* surface);
  void RemoveSurface(vtkSurfaceDisplay* surface);
  ///@}

  ///@{
  /** Whether a slice is shown; orientations as in vtkSliceView. All are by default. */
  void SetSliceVisibility(int orientation, bool visibility);
  bool GetSliceVisibility(int orientation);
  ///@}
  ///@{
  /** Whether slices run along the volume's own axes (the default) or along the body's. */
  vtkSetMacro(AlongImage, bool);
  vtkGetMacro(AlongImage, bool);
  vtkBooleanMacro(AlongImage, bool);
  ///@}
  ///@{
  /** The patient's axes and the bar of colours. On by default. */
  vtkSetMacro(AnnotationVisibility, bool);
  vtkGetMacro(AnnotationVisibility, bool);
  vtkBooleanMacro(AnnotationVisibility, bool);
  ///@}

  /** Looks at everything from a side of the patient; see palpate::FrameOf for what is up. */
  void LookFrom(int side);
  /** Shows everything from where the camera looks now. */
  void ResetCamera();

  /**
   * The nearest point (world, mm) of a surface, a slice or a sub-voxel volume under a place of the
   * window in pixels; false where there is none. It is the surface's own point, not one of the
   * depth buffer.
   */
  bool Pick(double x, double y, double world[3]);
  /** The surface that was picked last; null where it was something else, or nothing. */
  vtkSurfaceDisplay* GetPickedSurface();

  /** Brings everything up to date; done whenever the renderer draws. */
  void Update();

protected:
  vtkSpaceView();
  ~vtkSpaceView() override;

private:
  vtkSpaceView(const vtkSpaceView&) = delete;
  void operator=(const vtkSpaceView&) = delete;

  void UpdateContents();
  void UpdateAnnotation();

  bool AlongImage = true;
  bool AnnotationVisibility = true;

  struct State;
  std::unique_ptr<State> Inner;
};

#endif
