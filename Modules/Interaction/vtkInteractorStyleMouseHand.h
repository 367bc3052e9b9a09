/**
 * @class vtkInteractorStyleMouseHand
 * @brief the mouse as the hand of a simulated haptic device, in a 3D view
 *
 * While Hand is on, the pointer moves the hand in its plane parallel to the screen, and the wheel
 * moves it along the line of sight, forwards away from the viewer. The camera uses the rest: Ctrl
 * with a left drag rotates, Shift with a left drag and a middle drag pan, a right drag and Ctrl
 * with the wheel zoom. Otherwise it is a vtkInteractorStyleTrackballCamera with only the key r
 * (show everything).
 *
 * While Dragging is on, a left drag and the wheel move another object in the same manner, such as
 * the device's workspace; the hand stays.
 *
 * It moves nothing itself: observers of HandMovedEvent pass GetHandWorld to the device, and
 * observers of DraggedEvent move the dragged object to GetDraggedWorld.
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
    /** A drag has ended; the object is at its final position. */
    DragEndEvent
  };

  ///@{
  /** Whether the mouse moves the hand. Off by default. */
  vtkSetMacro(Hand, bool);
  vtkGetMacro(Hand, bool);
  vtkBooleanMacro(Hand, bool);
  ///@}
  ///@{
  /** Target of the hand: world, mm. Non-finite positions are ignored. */
  void SetHandWorld(const double position[3]);
  vtkGetVector3Macro(HandWorld, double);
  ///@}
  ///@{
  /** Whether the mouse moves another object. Off by default. */
  vtkSetMacro(Dragging, bool);
  vtkGetMacro(Dragging, bool);
  vtkBooleanMacro(Dragging, bool);
  ///@}
  ///@{
  /** Position of that object: world, mm. Non-finite positions are ignored. */
  void SetDraggedWorld(const double position[3]);
  vtkGetVector3Macro(DraggedWorld, double);
  ///@}
  ///@{
  /** mm along the line of sight per notch of the wheel. Default: 0.5. */
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
