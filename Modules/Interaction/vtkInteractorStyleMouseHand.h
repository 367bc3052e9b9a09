/**
 * @class vtkInteractorStyleMouseHand
 * @brief the mouse as the hand of a simulated haptic device, in a view in space
 *
 * While Hand is on, the pointer moves the hand in the plane of the screen that the hand lies in,
 * and the wheel moves it along the line of sight, forwards away from the viewer. The camera keeps
 * what is left: Ctrl with a left drag turns it, Shift with a left drag and a middle drag pan, a
 * right drag and Ctrl with the wheel zoom. Otherwise it is a
 * vtkInteractorStyleTrackballCamera, of whose letters only r is left (shows everything).
 *
 * While Dragging is on, a left drag moves something else in the same way, such as the device's
 * workspace, and the wheel moves that; the hand stays.
 *
 * It moves nothing itself: whoever observes HandMovedEvent takes GetHandWorld to the device, and
 * whoever observes DraggedEvent moves what GetDraggedWorld belongs to.
 */
#ifndef vtkInteractorStyleMouseHand_h
#define vtkInteractorStyleMouseHand_h

#include "PalpateInteractionModule.h" // For export macro
#include "vtkCommand.h"               // For the number of the event
#include "vtkInteractorStyleTrackballCamera.h"

class PALPATEINTERACTION_EXPORT vtkInteractorStyleMouseHand
    : public vtkInteractorStyleTrackballCamera
{
public:
  static vtkInteractorStyleMouseHand* New();
  vtkTypeMacro(vtkInteractorStyleMouseHand, vtkInteractorStyleTrackballCamera);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Events
  {
    HandMovedEvent = vtkCommand::UserEvent + 721,
    DraggedEvent,
    /** A drag has ended, with what was moved where it is. */
    DragEndEvent
  };

  ///@{
  /** Whether the mouse is the hand. Off by default. */
  vtkSetMacro(Hand, bool);
  vtkGetMacro(Hand, bool);
  vtkBooleanMacro(Hand, bool);
  ///@}
  ///@{
  /** Where the hand wants to be: world, mm. What is no number is ignored. */
  void SetHandWorld(const double position[3]);
  vtkGetVector3Macro(HandWorld, double);
  ///@}
  ///@{
  /** Whether the mouse moves something else. Off by default. */
  vtkSetMacro(Dragging, bool);
  vtkGetMacro(Dragging, bool);
  vtkBooleanMacro(Dragging, bool);
  ///@}
  ///@{
  /** Where that is: world, mm. What is no number is ignored. */
  void SetDraggedWorld(const double position[3]);
  vtkGetVector3Macro(DraggedWorld, double);
  ///@}
  ///@{
  /** mm along the line of sight that a notch of the wheel is. Default: 0.5. */
  vtkSetClampMacro(NotchMillimeters, double, 0.001, 100.0);
  vtkGetMacro(NotchMillimeters, double);
  ///@}

  void OnMouseMove() override;
  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;
  void OnChar() override;

protected:
  vtkInteractorStyleMouseHand() = default;
  ~vtkInteractorStyleMouseHand() override = default;

private:
  vtkInteractorStyleMouseHand(const vtkInteractorStyleMouseHand&) = delete;
  void operator=(const vtkInteractorStyleMouseHand&) = delete;

  bool IsForCamera();
  bool FindRenderer();
  void WorldAtPointer(const double depthOf[3], const int pointer[2], double world[3]);
  void Deepen(double notches, double world[3]);
  void MoveHandToPointer();
  bool MoveDeeper(double notches);
  void DragToPointer();

  bool Hand = false;
  double HandWorld[3] = {0.0, 0.0, 0.0};
  bool Dragging = false;
  bool IsDragged = false; ///< the button is down
  double DraggedWorld[3] = {0.0, 0.0, 0.0};
  double NotchMillimeters = 0.5;
};

#endif
