#pragma once

#include "ViewContents.h"
#include "ViewGround.h"
#include "ViewPane.h"

#include "vtkInteractorStyleMouseHand.h"
#include "vtkSpaceView.h"

#include <QTimer>

#include <set>

namespace palpate
{
/// The 3D view of a window. While touching with a simulated device, the mouse over it moves the
/// hand.
class SpacePane : public ViewPane
{
  Q_OBJECT

public:
  /// Shows `contents`, which outlive it.
  SpacePane(const ViewContents& contents, QWidget* parent);

  vtkSpaceView* View() const { return this->Space; }
  /// Shows only these.
  void ShowFields(const std::set<vtkProp*>& fields);
  /// The same for volumes that are drawn as a whole.
  void ShowVolumes(const std::set<vtkProp*>& volumes);
  void ShowSlices(bool areShown);
  /// See vtkSpaceView::SetAntialiasing, SetAmbientOcclusion and SetToolShadow.
  void SmoothEdges(bool areSmooth);
  /// Whether smooth edges and ambient occlusion wait until nothing has moved for a moment, so that
  /// they cost no frames. On by default.
  void WaitForRest(bool areWaiting) { this->AreEffectsWaiting = areWaiting; }
  /// Milliseconds without a change until a view is at rest.
  static constexpr int RestTime = 200;
  void Settle() override;
  void SetGround(ViewGround ground);
  void ShowOcclusion(bool isShown);
  void ShowToolShadow(bool isShown);
  void LookFrom(int side);
  /// Moves the camera so that it turns around a point (mm), as far from it as it was from what it
  /// turned around.
  void LookAt(const Vector3& world);
  void ShowAll();
  /// The same, unless the user has moved the camera since FreeCamera.
  void ShowAllUnlessLed();
  void FreeCamera() { this->IsLed = false; }

  /// Whether the mouse moves the hand, which is at `handWorld` (mm).
  void SetHand(bool isOn, const Vector3& handWorld);
  /// Whether a left press pushes the hand.
  void SetButtonPushes(bool isOn) { this->Style->SetButtonPushes(isOn); }
  /// Corrects the hand's position (mm).
  void PlaceHand(const Vector3& handWorld) { this->Style->SetHandWorld(handWorld.data()); }
  /// Answers Aimed: where the tool rests, with the normal there, and the strongest push (mm).
  void Rest(const Vector3& toolWorld, const Vector3& normalWorld, double mostPush);
  bool IsPressed() const { return this->Style->IsPressed(); }
  /// Ends a push.
  void Lift() { this->Style->Lift(); }
  /// Whether a push is along the line of sight instead of the surface's normal.
  void PushAlongSight(bool isOn) { this->Style->SetPushAlongSight(isOn); }
  Vector3 HandWorld() const { return Vector3(this->Style->GetHandWorld()); }
  /// Whether the mouse drags an object at `world` (mm) instead.
  void SetDragging(bool isOn, const Vector3& world);
  /// Columns: right, up and towards the viewer in the world.
  Matrix3 Axes() const;

Q_SIGNALS:
  void HandMoved(const Vector3& targetWorld);
  /// The pointer aims along this line (world, mm); see Rest.
  void Aimed(const Vector3& from, const Vector3& to);
  void Pressed();
  void CameraTurned();
  void Dragged(const Vector3& world); ///< the object's new position
  void DragEnded();

protected:
  void Stir() override;
  void changeEvent(QEvent* event) override;

private:
  using Props = std::set<vtkSmartPointer<vtkProp>>;
  void ShowOnly(Props& shown, const std::set<vtkProp*>& props);
  void TellHand();
  void TellAim();
  bool eventFilter(QObject* object, QEvent* event) override;
  void ShowCursor();
  void TellDrag();
  void TakeCamera();

  vtkNew<vtkSpaceView> Space;
  vtkNew<vtkInteractorStyleMouseHand> Style;
  Props Fields;
  Props Volumes;
  QTimer* Pause;
  bool AreEffectsWaiting = true;
  ViewGround Ground = ViewGround::Theme;
  bool IsLed = false;
};
} // namespace palpate
