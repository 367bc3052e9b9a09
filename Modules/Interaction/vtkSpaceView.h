/**
 * @class vtkSpaceView
 * @brief what a renderer shows in space, linked to slice views
 *
 * Surfaces are shown plain or coloured by an array, with a bar that says what the colours mean; the
 * slices of the volume through the shared vtkCrosshair; a haptic tool with its force and the place
 * that it touches. What is shown, and how views are linked, is vtkLinkedView's. Other props, such
 * as a vtkSubVoxelVolume, are added to the renderer itself.
 *
 * The camera is the renderer's own: any interactor style moves it. At first, and by LookFrom, it
 * shows everything.
 */
#ifndef vtkSpaceView_h
#define vtkSpaceView_h

#include "PalpateInteractionModule.h" // For export macro
#include "vtkLinkedView.h"

#include <memory> // For what is drawn

class PALPATEINTERACTION_EXPORT vtkSpaceView : public vtkLinkedView
{
public:
  static vtkSpaceView* New();
  vtkTypeMacro(vtkSpaceView, vtkLinkedView);
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

  void AddSurface(vtkSurfaceDisplay* surface) override;
  void RemoveSurface(vtkSurfaceDisplay* surface) override;

  ///@{
  /** Whether a slice is shown; orientations as in vtkSliceView. All are by default. */
  void SetSliceVisibility(int orientation, bool visibility);
  bool GetSliceVisibility(int orientation);
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

protected:
  vtkSpaceView();
  ~vtkSpaceView() override;

  void AddTo(vtkRenderer* renderer) override;
  void RemoveFrom(vtkRenderer* renderer) override;
  void UpdateFor(vtkRenderer* renderer) override;

private:
  vtkSpaceView(const vtkSpaceView&) = delete;
  void operator=(const vtkSpaceView&) = delete;

  void UpdateContents();
  void UpdateAnnotation(vtkRenderer* renderer);

  struct State;
  std::unique_ptr<State> Inner;
};

#endif
