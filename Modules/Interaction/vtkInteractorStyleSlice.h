/**
 * @class vtkInteractorStyleSlice
 * @brief mouse and keys in slice views, as in 3D Slicer and ITK-SNAP
 *
 * - left drag: moves the crosshair, or window (to the right: wider) and level (upwards: brighter);
 *   LeftButtonMode selects which, Ctrl the other one
 * - Shift: the pointer moves the crosshair without a button, and a left drag pans, as in 3D Slicer
 * - mouse wheel: slices; with Ctrl: zoom. Middle drag: pan. Right drag: zoom, upwards larger
 * - arrow keys: one slice; page up and down: ten slices; r: fit the view to the volume
 *
 * While Hand is on, a left press raises AimedEvent; if an observer calls AcceptPress, the drag
 * leads a haptic tool instead (PressedEvent, HandMovedEvent, LiftedEvent with GetPointerWorld).
 *
 * It acts on the added view whose renderer is under the pointer. In other renderers of the window
 * it is a vtkInteractorStyleTrackballCamera, so that one style serves slices and a 3D view side by
 * side. It draws its own window; to draw views in other windows, observe the shared objects
 * (vtkCrosshair, vtkImageDisplay) and this style's InteractionEvent.
 */
#ifndef vtkInteractorStyleSlice_h
#define vtkInteractorStyleSlice_h

#include "PalpateInteractionModule.h" // For export macro
#include "vtkCommand.h"               // For the numbers of the events
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkSmartPointer.h" // For the views

#include <vector> // For the views

class vtkSliceView;

class PALPATEINTERACTION_EXPORT vtkInteractorStyleSlice : public vtkInteractorStyleTrackballCamera
{
public:
  static vtkInteractorStyleSlice* New();
  vtkTypeMacro(vtkInteractorStyleSlice, vtkInteractorStyleTrackballCamera);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum LeftButtonModes
  {
    CROSSHAIR,
    WINDOW_LEVEL
  };

  enum Events
  {
    AimedEvent = vtkCommand::UserEvent + 731,
    PressedEvent,
    HandMovedEvent,
    LiftedEvent
  };

  void AddView(vtkSliceView* view);

  ///@{
  /** Whether a left press may lead a tool. Off by default. */
  vtkSetMacro(Hand, bool);
  vtkGetMacro(Hand, bool);
  ///@}
  /** The pointer in the slice of the drag: world, mm. */
  vtkGetVector3Macro(PointerWorld, double);
  void AcceptPress() { this->IsAccepted = true; }
  /** Ends such a drag. */
  void Lift();

  ///@{
  /** Action of a left drag. Default: CROSSHAIR. */
  vtkSetClampMacro(LeftButtonMode, int, CROSSHAIR, WINDOW_LEVEL);
  vtkGetMacro(LeftButtonMode, int);
  ///@}

  void OnMouseMove() override;
  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnMiddleButtonDown() override;
  void OnMiddleButtonUp() override;
  void OnRightButtonDown() override;
  void OnRightButtonUp() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;
  void OnKeyPress() override;
  void OnChar() override;

protected:
  vtkInteractorStyleSlice() = default;
  ~vtkInteractorStyleSlice() override = default;

private:
  vtkInteractorStyleSlice(const vtkInteractorStyleSlice&) = delete;
  void operator=(const vtkInteractorStyleSlice&) = delete;

  enum Drags
  {
    NO_DRAG,
    CROSSHAIR_DRAG,
    WINDOW_LEVEL_DRAG,
    PAN_DRAG,
    ZOOM_DRAG,
    PUSH_DRAG
  };

  /** The added view under the pointer; null if there is none. */
  vtkSliceView* PokedView();
  /** Returns whether the drag belongs to a slice view. */
  bool StartDrag(int drag);
  bool EndDrag();
  void Drag();
  void DragWindowLevel(double right, double up);
  bool Wheel(int direction);
  void Finish();
  /** Whether a press at the pointer leads the tool. */
  bool Aims();

  std::vector<vtkSmartPointer<vtkSliceView>> Views;
  int LeftButtonMode = CROSSHAIR;
  int ActiveDrag = NO_DRAG;
  vtkSmartPointer<vtkSliceView> DraggedView;
  int StartPosition[2] = {0, 0};
  bool Hand = false;
  bool IsAccepted = false;
  double PointerWorld[3] = {0.0, 0.0, 0.0};
};

#endif
