/**
 * @class vtkInteractorStyleMouseHand
 * @brief the mouse as the hand of a simulated haptic device, in a 3D view
 *
 * While Hand is on, the tool rests on what can be touched under the pointer: for each position of
 * the pointer the style raises AimedEvent, and an observer calls SetRest if the line of sight
 * (GetSightFrom, GetSightTo) meets something. There a left press pushes the tool into the surface
 * (PressedEvent), the harder the longer it is held; the wheel pushes without a button, and SetPush
 * takes a pen's pressure. While the button is down the pointer strokes along the surface with the
 * same push. Releasing the button, leaving the view and Lift end it (LiftedEvent). By keyboard:
 * arrows move the pointer, and the space bar is the button.
 *
 * The camera uses the rest: a left press on anything else and Ctrl with a left drag rotate, Shift
 * with a left drag and a middle drag pan, a right drag and Ctrl with the wheel zoom. Without Hand
 * it is a vtkInteractorStyleTrackballCamera with only the key r (show everything). Where nothing
 * can be touched under the pointer, the hand follows it in its plane parallel to the screen, and
 * the wheel moves it along the line of sight, by a fiftieth of the view's height.
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
    /** The pointer aims along another line; observers call SetRest. */
    AimedEvent,
    /** The tool is pushed into the surface from now on; and no longer. */
    PressedEvent,
    LiftedEvent,
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
  /** The line of sight under the pointer: world, mm, through the whole visible range. */
  vtkGetVector3Macro(SightFrom, double);
  vtkGetVector3Macro(SightTo, double);
  ///@}
  ///@{
  /** Where the tool rests on a surface along that line: world, mm, and the unit normal outwards. */
  void SetRest(const double position[3], const double normal[3]);
  vtkGetMacro(HasRest, bool);
  ///@}
  ///@{
  /** The push from 0 to 1 of the strongest; a pen sets its pressure. Ignored without a rest. */
  void SetPush(double push);
  vtkGetMacro(Push, double);
  ///@}
  ///@{
  /** The strongest push: mm of the world from the rest. Default: 5. */
  vtkSetClampMacro(MostPush, double, 0.0, 1e6);
  vtkGetMacro(MostPush, double);
  ///@}
  ///@{
  /** Whether a push is along the line of sight instead of the surface's normal. Off by default. */
  vtkSetMacro(PushAlongSight, bool);
  vtkGetMacro(PushAlongSight, bool);
  vtkBooleanMacro(PushAlongSight, bool);
  ///@}
  ///@{
  /** Whether a left press pushes; otherwise it is left to others, such as what places marks. On by
   * default. */
  vtkSetMacro(ButtonPushes, bool);
  vtkGetMacro(ButtonPushes, bool);
  ///@}
  /** Ends a push. */
  void Lift();
  bool IsPressed() const { return this->Presses; }

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
  void OnMouseMove() override;
  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;
  void OnLeave() override;
  void OnTimer() override;
  void OnKeyPress() override;
  void OnKeyRelease() override;
  void OnChar() override;

protected:
  /** Subclasses with a repeating timer of about 20 ms set it to false. */
  bool NeedsTimer = true;

  vtkInteractorStyleMouseHand() = default;
  ~vtkInteractorStyleMouseHand() override = default;

private:
  vtkInteractorStyleMouseHand(const vtkInteractorStyleMouseHand&) = delete;
  void operator=(const vtkInteractorStyleMouseHand&) = delete;

  bool IsForCamera();
  bool AimsAtSurface();
  void BeginPush();
  bool MovePointer(const char* key);
  bool FindRenderer();
  void WorldAtPointer(const double depthOf[3], const int pointer[2], double world[3]);
  void Deepen(double notches, double world[3]);
  void Aim();
  void Press(double push);
  void TellHand();
  void MoveHandToPointer();
  bool MoveDeeper(double notches);
  void DragToPointer();

  bool Hand = false;
  double HandWorld[3] = {0.0, 0.0, 0.0};
  bool Dragging = false;
  bool IsDragged = false; ///< the button is down
  double DraggedWorld[3] = {0.0, 0.0, 0.0};
  double SightFrom[3] = {0.0, 0.0, 0.0};
  double SightTo[3] = {0.0, 0.0, 0.0};
  bool HasRest = false;
  double Rest[3] = {0.0, 0.0, 0.0};
  double RestNormal[3] = {0.0, 0.0, 1.0};
  double MostPush = 5.0;
  bool PushAlongSight = false;
  bool Presses = false; ///< pushes into a surface
  bool ButtonPushes = true;
  bool IsButtonDown = false;
  bool Grows = false; ///< with time, until it is set by a wheel or a pen
  double Push = 0.0;
  int Growing = 0; ///< the timer
};

#endif
